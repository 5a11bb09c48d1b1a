#include "common/physics/perturbation.hpp"

#include <cmath>

#include "common/physics/audit.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

// Known answers of the generator's authors (Random123, kat_vectors).
TEST(Philox, GivesTheAuthorsKnownAnswers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
            (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Key, DiffersBetweenShotsAndStreams) {
  ShotSeed seed = seed_of(5);
  const PhiloxKey collisions = key_of(seed, Stream::collisions);
  EXPECT_NE(collisions, key_of(seed, Stream::rack));
  seed.shot = 1;
  EXPECT_NE(collisions, key_of(seed, Stream::collisions));
}

TEST(Symmetric, IsBoundedWithMeanZero) {
  EXPECT_EQ(symmetric({0xffffffff, 0xffffffff, 0, 0}), 0xffffffffp0 / 0x1p32);
  EXPECT_EQ(symmetric({0, 0, 0xffffffff, 0xffffffff}), -0xffffffffp0 / 0x1p32);
  double sum = 0;
  double squares = 0;
  constexpr int draws = 100'000;
  for (std::uint32_t i = 0; i < draws; ++i) {
    const double s = symmetric(philox({i, 0, 0, 0}, {1, 2}));
    sum += s;
    squares += s * s;
  }
  // Variance of (u0 + u1 - u2 - u3) / 2 with u uniform on [0, 1]: 1 / 12.
  EXPECT_NEAR(sum / draws, 0, 5 * std::sqrt(1.0 / 12 / draws));
  EXPECT_NEAR(squares / draws, 1.0 / 12, 0.002);
}

TEST(Perturbation, OfScaleZeroGivesTheSameBitsAsNone) {
  Scene scene = table(Straight{}, CushionRestitution{}, BallRestitution{});
  const State state = racked(scene, rack_gap_m);
  const Strike strike{BallId{0}, {1, 0}, 8};
  const Shot absent = shot_of(scene, state, strike, seed_of(3));
  scene.perturbation = Perturbation{0, 0};
  EXPECT_EQ(shot_of(scene, state, strike, seed_of(3)), absent);
}

TEST(Perturbation, DependsOnTheSeedAndOnlyOnIt) {
  Scene scene = table(Straight{}, CushionRestitution{}, BallRestitution{});
  scene.perturbation = Perturbation{1e-3, 1e-3};
  const State state = racked(scene, rack_gap_m);
  const Strike strike{BallId{0}, {1, 0}, 8};
  EXPECT_EQ(shot_of(scene, state, strike, seed_of(3)), shot_of(scene, state, strike, seed_of(3)));
  EXPECT_NE(shot_of(scene, state, strike, seed_of(3)), shot_of(scene, state, strike, seed_of(4)));
}

TEST(Perturbation, TurnsTheNormalByAtMostItsTangent) {
  Scene scene = gas();
  scene.perturbation = Perturbation{0.05, 0};
  bool turned_both_ways[2] = {false, false};
  for (std::uint32_t i = 0; i < 500; ++i) {
    const Shot shot = shot_of(scene, balls({ball(0, {0, 0}, {1, 0}), ball(1, {1, 0})}),
                              std::nullopt, seed_of(i), until(2));
    const Vec2 velocity = Timeline(shot).state(BallId{1}, 2).velocity;
    ASSERT_LE(std::abs(velocity.y / velocity.x), 0.05);
    turned_both_ways[velocity.y > 0] = true;
  }
  EXPECT_TRUE(turned_both_ways[0] && turned_both_ways[1]);
}

TEST(Perturbation, NeverLeavesAGrazingPairApproaching) {
  Chance chance(11);
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    Scene scene = gas();
    scene.perturbation = Perturbation{i % 3 == 0 ? 1.0 : 0.1, 0};
    // Impact parameters within 1e-12 .. 1e-3 of a miss.
    const double miss = std::pow(10.0, chance.between(-12, -3));
    const double offset = 2 * scene.ball.radius_m * (1 - miss);
    const Shot shot = shot_of(scene, balls({ball(0, {0, offset}, {2, 0}), ball(1, {0.5, 0})}),
                              std::nullopt, seed_of(i), until(5));
    const auto hits = all_of<BallBall>(shot);
    ASSERT_EQ(hits.size(), 1u) << "draw " << i;
    const Timeline timeline(shot);
    const BallState a = timeline.state(BallId{0}, hits[0].time_s);
    const BallState b = timeline.state(BallId{1}, hits[0].time_s);
    ASSERT_GE(dot(b.position - a.position, b.velocity - a.velocity), -1e-15) << "draw " << i;
    const Audit found = audit(scene, shot);
    ASSERT_LE(found.worst_rise_J, 1e-15);
    ASSERT_LE(found.worst_penetration_m, 1e-14);
  }
}

}  // namespace
}  // namespace breakshot::physics
