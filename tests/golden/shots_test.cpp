// Ten shots whose bits may not change by accident: the same digest in every build type, from every
// compiler, on every machine. A change to shots/digests.txt states the old digest, the new one and
// the reason in its commit. Each line names the version of the physics that the digest is of;
// `breakshot simulate FILE` prints that of the present one in its last line.
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "common/hash/hash.hpp"
#include "common/record/record.hpp"
#include "common/wire/scenario.hpp"
#include "tests/golden/set.hpp"

namespace breakshot {
namespace {

const std::string folder = BREAKSHOT_GOLDEN_DIR "/shots/";

std::string text_of(const std::string& name) {
  std::ifstream file(folder + name);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

struct Expected {
  std::string name;
  std::uint32_t physics;
  std::string digest;
};

std::vector<Expected> all_expected() {
  std::vector<Expected> all;
  std::ifstream file(folder + "digests.txt");
  for (Expected one; file >> one.name >> one.physics >> one.digest;) all.push_back(one);
  return all;
}

std::string digest_of_shot(const std::string& name, std::uint32_t physics) {
  const auto reading = wire::read_scenario(text_of(name + ".json"));
  if (const auto* faults = std::get_if<std::vector<physics::Fault>>(&reading)) {
    return faults->front().field + ": " + faults->front().what;
  }
  const auto& scenario = std::get<wire::Scenario>(reading);
  physics::Limits limits = scenario.limits;
  limits.physics = physics;
  const auto outcome =
      physics::simulate(scenario.scene, scenario.state, scenario.strike, scenario.seed, limits);
  const auto* shot = std::get_if<physics::Shot>(&outcome);
  if (shot == nullptr) return "stalled";
  return hash::hex_of(record::simulation_digest(*shot));
}

TEST(GoldenShots, HaveTheSameBitsEverywhere) {
  const std::vector<Expected> all = all_expected();
  ASSERT_EQ(all.size(), 10 * golden::golden_physics.size());
  for (const auto& [name, physics, digest] : all) {
    EXPECT_EQ(digest_of_shot(name, physics), digest) << name << ", physics version " << physics;
  }
}

}  // namespace
}  // namespace breakshot
