// Two hundred shots and the stored matches have the bits that set.digests says, here as this build
// was compiled; ./run check determinism asks the same of other compilers, flags and processors. A
// change to set.digests states why in its commit.
#include "tests/golden/set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "common/physics/simulation.hpp"
#include "tests/golden/stored_match.hpp"

namespace breakshot::golden {
namespace {

using namespace physics;
using Digests = std::map<std::string, std::string>;

const std::string folder = BREAKSHOT_GOLDEN_DIR;

Digests stored_digests() {
  Digests digests;
  std::ifstream file(folder + "/set.digests");
  for (std::string name, digest; file >> name >> digest;) digests[name] = digest;
  return digests;
}

std::vector<std::string> match_paths() {
  std::vector<std::string> paths;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const std::string name = file.path().filename().string();
    if (name.starts_with("match_") && name.ends_with(".breakshot")) {
      paths.push_back(file.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<GoldenShot> all_shots() {
  std::vector<GoldenShot> shots;
  for (std::size_t i = 0; i < golden_shots; ++i) shots.push_back(golden_shot(i));
  return shots;
}

Shot simulated(const GoldenShot& shot) {
  auto outcome = simulate(shot.scene, shot.state, shot.strike, shot.seed, shot.limits);
  if (auto* ended = std::get_if<Shot>(&outcome)) return std::move(*ended);
  ADD_FAILURE() << shot.name << " has more than " << most_golden_events << " events";
  return {};
}

/// 0 for none, else one more than the alternative.
template <class Variant>
std::size_t which(const std::optional<Variant>& choice) {
  return choice ? 1 + choice->index() : 0;
}

/// 0 for none, 1 to 5 for a rectangle's model, 6 to 10 for a box's.
std::size_t which_cushions(const Scene& scene) {
  if (!scene.cushions) return 0;
  if (const auto* rectangle = std::get_if<RectangleCushions>(&*scene.cushions)) {
    return 1 + rectangle->model.index();
  }
  return 6 + std::get<FreeCushions>(*scene.cushions).arcs.front().model.index();
}

TEST(GoldenSet, HasTheStoredBits) {
  Digests digests;
  for (const GoldenShot& shot : all_shots()) {
    for (const std::uint32_t physics : golden_physics) {
      digests[name_of(shot, physics)] = digest_of(shot, physics);
    }
  }
  for (const std::string& path : match_paths()) digests[name_of(path)] = digest_of_match(path);
  const Digests stored = stored_digests();
  for (const auto& [name, digest] : digests) {
    ASSERT_TRUE(stored.contains(name)) << name << ' ' << digest << " is not in set.digests";
    EXPECT_EQ(digest, stored.at(name)) << name;
  }
  EXPECT_EQ(stored.size(), digests.size()) << "set.digests names what is no shot and no match";
}

TEST(GoldenSet, IsFreeOfFaults) {
  for (const GoldenShot& shot : all_shots()) {
    ASSERT_EQ(faults_of(shot.scene), std::vector<Fault>{}) << shot.name;
    EXPECT_EQ(faults_of(shot.scene, shot.state), std::vector<Fault>{}) << shot.name;
    if (shot.strike) {
      EXPECT_EQ(faults_of(shot.scene, shot.state, *shot.strike), std::vector<Fault>{}) << shot.name;
    }
  }
}

TEST(GoldenSet, HasEveryCombinationOfMotionContactAndCushions) {
  std::set<std::array<std::size_t, 3>> seen;
  for (const GoldenShot& shot : all_shots()) {
    seen.insert(
        {shot.scene.bed.motion.index(), which(shot.scene.ball_ball), which_cushions(shot.scene)});
  }
  EXPECT_EQ(seen.size(), combinations);
  EXPECT_EQ(*seen.rbegin(), (std::array<std::size_t, 3>{2, 4, 10}));
}

TEST(GoldenSet, HasPocketsAndPerturbationWithEveryModelThatMeetsThem) {
  std::set<std::array<std::size_t, 2>> pockets_by_cushions, pockets_by_motion;
  std::set<std::array<std::size_t, 2>> perturbed_contacts, perturbed_cushions;
  for (const auto& [name, scene, state, strike, seed, limits] : all_shots()) {
    const std::size_t pockets = which(scene.pockets);
    const std::size_t perturbed = scene.perturbation ? 1 : 0;
    pockets_by_motion.insert({pockets, scene.bed.motion.index()});
    perturbed_contacts.insert({perturbed, which(scene.ball_ball)});
    perturbed_cushions.insert({perturbed, which_cushions(scene)});
    const std::size_t cushions = which_cushions(scene);
    if (cushions >= 1 && cushions <= 5) pockets_by_cushions.insert({pockets, cushions});
  }
  EXPECT_EQ(pockets_by_cushions.size(), 3u * 5);
  EXPECT_EQ(pockets_by_motion.size(), 3u * 3);
  EXPECT_EQ(perturbed_contacts.size(), 2u * 5);
  EXPECT_EQ(perturbed_cushions.size(), 2u * 11);
}

TEST(GoldenSet, HasTipsTablesOfEverySizeAndTwoToManyBalls) {
  std::set<double> lengths_m;
  std::set<std::size_t> counts;
  int tips = 0, spinning = 0;
  for (const GoldenShot& shot : all_shots()) {
    lengths_m.insert(*shot.scene.bed.length_m);
    counts.insert(shot.state.balls.size());
    tips += shot.strike && !(shot.strike->tip == Tip{});
    spinning += std::any_of(shot.state.balls.begin(), shot.state.balls.end(),
                            [](const Ball& ball) { return !(ball.spin == Vec3{}); });
  }
  EXPECT_EQ(lengths_m, (std::set<double>{0.6, 1.9812, 2.3368, 2.54, 2.84, 3.569, 40}));
  EXPECT_EQ(*counts.begin(), 2u);
  EXPECT_GE(*counts.rbegin(), most_balls_at_a_table + 10) << "the cells keep too few of the shots";
  EXPECT_GE(tips, 10);
  EXPECT_GE(spinning, 10);
}

TEST(GoldenSet, HasEveryKindOfEventManyTimes) {
  std::map<std::size_t, std::size_t> kinds;
  for (const GoldenShot& shot : all_shots()) {
    for (const Event& event : simulated(shot).events) ++kinds[event.index()];
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Event>);
  for (const auto& [kind, count] : kinds) EXPECT_GE(count, 50u) << "kind " << kind;
}

TEST(StoredMatches, AreOfEveryFormatAndPhysicsThatThereHasBeen) {
  std::set<std::uint32_t> formats, versions;
  for (const std::string& path : match_paths()) {
    const record::Reading reading = read_match(path);
    ASSERT_TRUE(reading.record && !reading.damage) << path;
    formats.insert(reading.record->header.format);
    versions.insert(reading.record->header.physics);
    EXPECT_TRUE(reading.record->entries.back().secret) << path << " is not finished";
  }
  for (std::uint32_t format = 1; format <= record::format_version; ++format) {
    EXPECT_TRUE(formats.contains(format)) << "keep a match of format " << format;
  }
  for (std::uint32_t version = 1; version <= physics_version; ++version) {
    EXPECT_TRUE(versions.contains(version)) << "keep a match of physics version " << version;
  }
}

TEST(StoredMatches, AreNamedByTheEntryThatDiverges) {
  const std::string path = testing::TempDir() + "match_changed.breakshot";
  record::Record record = *read_match(match_paths().front()).record;
  hash::Digest before = record::digest_of(record.header);
  for (record::Entry& entry : record.entries) {
    if (entry.outcome.shot) entry.outcome.shot->end_s += 1;
    entry.digest = before = record::digest_of(before, entry);
  }
  const record::ByteVector bytes = record::file_of(record);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  EXPECT_TRUE(digest_of_match(path).starts_with("diverged at entry ")) << digest_of_match(path);
  std::ofstream(path, std::ios::binary).write("no match", 8);
  EXPECT_TRUE(digest_of_match(path).starts_with("damaged: ")) << digest_of_match(path);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace breakshot::golden
