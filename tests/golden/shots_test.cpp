// Ten shots whose bits may not change by accident: the same digest in every build type, from every
// compiler, on every machine. A change to shots/digests.txt states the old digest, the new one and
// the reason in its commit. `breakshot simulate FILE` prints a file's digest in its last line.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "common/hash/hash.hpp"
#include "common/record/record.hpp"
#include "common/wire/scenario.hpp"

namespace breakshot {
namespace {

const std::string folder = BREAKSHOT_GOLDEN_DIR "/shots/";

std::string text_of(const std::string& name) {
  std::ifstream file(folder + name);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::map<std::string, std::string> digests() {
  std::map<std::string, std::string> digests;
  std::ifstream file(folder + "digests.txt");
  for (std::string name, digest; file >> name >> digest;) digests[name] = digest;
  return digests;
}

std::string digest_of_shot(const std::string& name) {
  const auto reading = wire::read_scenario(text_of(name + ".json"));
  if (const auto* faults = std::get_if<std::vector<physics::Fault>>(&reading)) {
    return faults->front().field + ": " + faults->front().what;
  }
  const auto& scenario = std::get<wire::Scenario>(reading);
  const auto outcome = physics::simulate(scenario.scene, scenario.state, scenario.strike,
                                         scenario.seed, scenario.limits);
  const auto* shot = std::get_if<physics::Shot>(&outcome);
  if (shot == nullptr) return "stalled";
  return hash::hex_of(record::simulation_digest(*shot));
}

TEST(GoldenShots, HaveTheSameBitsEverywhere) {
  const auto expected = digests();
  ASSERT_EQ(expected.size(), 10u);
  for (const auto& [name, digest] : expected) EXPECT_EQ(digest_of_shot(name), digest) << name;
}

}  // namespace
}  // namespace breakshot
