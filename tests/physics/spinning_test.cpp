// Motion with spin against its closed forms (Marlow 1995; Alciatore, "Pool and billiards physics
// principles"): sliding, rolling, spinning in place, and the stroke that starts them.
#include <gtest/gtest.h>

#include <cmath>

#include "common/physics/simulation.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

constexpr double radius = 0.028575;
constexpr double gravity = 9.81;
constexpr Spinning friction{0.2, 0.01, 0.0127};

Scene carpet() {
  Scene scene = gas();
  scene.gravity_m_s2 = gravity;
  scene.bed.motion = friction;
  return scene;
}

Strike stroke(double speed_m_s, Tip tip = {}) {
  return {BallId{0}, {1, 0}, speed_m_s, tip};
}

BallState at(const Shot& shot, double time_s) {
  return Timeline(shot).state(BallId{0}, time_s);
}

TEST(Slide, OfACentreBallHitEndsInRollAtFiveSeventhsOfTheSpeed) {
  const double v = 3;
  const Shot shot = shot_of(carpet(), balls({ball(0, {0, 0})}), stroke(v));
  const double t = 2 * v / (7 * friction.sliding_friction * gravity);
  ASSERT_EQ(all_of<Rolls>(shot).size(), 1U);
  EXPECT_NEAR(all_of<Rolls>(shot)[0].time_s, t, 1e-15);
  const BallState rolling = at(shot, t);
  EXPECT_NEAR(rolling.velocity.x, 5 * v / 7, 1e-15);
  EXPECT_NEAR(rolling.position.x, 12 * v * v / (49 * friction.sliding_friction * gravity), 1e-14);
  EXPECT_NEAR(rolling.spin.y, rolling.velocity.x / radius, 1e-12);
}

TEST(Slide, EndsWhenThePointOfContactNoLongerSlips) {
  const Shot shot =
      shot_of(carpet(), balls({ball(0, {0, 0})}), Strike{BallId{0}, {0.6, 0.8}, 4, {0.3, -0.35}});
  ASSERT_GE(all_of<Rolls>(shot).size(), 1U);
  const double t = all_of<Rolls>(shot)[0].time_s;
  const BallState before = at(shot, t * (1 - 1e-9));
  const BallState after = at(shot, t);
  EXPECT_NEAR(before.velocity.x - radius * before.spin.y, 0, 1e-7);
  EXPECT_NEAR(before.velocity.y + radius * before.spin.x, 0, 1e-7);
  EXPECT_NEAR(after.spin.z, before.spin.z, 1e-5);
}

TEST(Stroke, AtTwoFifthsAboveTheCentreRollsAtOnce) {
  const Shot shot = shot_of(carpet(), balls({ball(0, {0, 0})}), stroke(2, {0, 0.4}));
  EXPECT_EQ(shot.segments[0].phase, Phase::roll);
  EXPECT_TRUE(all_of<Rolls>(shot).empty());
}

TEST(Stroke, BelowTheCentreTurnsTheBallBackwards) {
  const Shot shot = shot_of(carpet(), balls({ball(0, {0, 0})}), stroke(2, {0, -0.5}));
  EXPECT_NEAR(shot.segments[0].spin.y, -2.5 * 0.5 * 2 / radius, 1e-12);
  const double t = all_of<Rolls>(shot).at(0).time_s;
  EXPECT_NEAR(at(shot, t).velocity.x, 2 * (5 - 2.5) / 7, 1e-15);
}

TEST(Stroke, OnTheLeftTurnsTheBallClockwise) {
  const Shot left = shot_of(carpet(), balls({ball(0, {0, 0})}), stroke(2, {0.5, 0}));
  EXPECT_NEAR(left.segments[0].spin.z, -2.5 * 0.5 * 2 / radius, 1e-12);
  const Shot right = shot_of(carpet(), balls({ball(0, {0, 0})}), stroke(2, {-0.5, 0}));
  EXPECT_EQ(right.segments[0].spin.z, -left.segments[0].spin.z);
}

TEST(Spin, AboutTheVerticalDecaysEvenlyAndOutlastsTheRoll) {
  Ball top = ball(0, {0, 0});
  top.spin = {0, 0, 40};
  const Shot shot = shot_of(carpet(), balls({top}));
  const double decay = 5 * friction.spin_friction * gravity / (2 * radius);
  EXPECT_EQ(shot.segments[0].phase, Phase::spin);
  EXPECT_NEAR(all_of<Rests>(shot).at(0).time_s, 40 / decay, 1e-13);
  EXPECT_NEAR(at(shot, 1).spin.z, 40 - decay, 1e-13);
  EXPECT_EQ(at(shot, 1).position, (Vec2{0, 0}));

  Ball rolling = ball(0, {0, 0}, {0.1, 0});
  rolling.spin = {0, 0.1 / radius, 40};
  const Shot longer = shot_of(carpet(), balls({rolling}));
  EXPECT_EQ(all_of<Spins>(longer).size(), 1U);
  EXPECT_NEAR(all_of<Spins>(longer)[0].time_s, 0.1 / (friction.rolling_friction * gravity), 1e-14);
  EXPECT_NEAR(all_of<Rests>(longer).at(0).time_s, 40 / decay, 1e-12);
}

TEST(Spin, ThatIsOverBeforeTheRollStaysAtZero) {
  Ball rolling = ball(0, {0, 0}, {1, 0});
  rolling.spin = {0, 1 / radius, -1};
  const Shot shot = shot_of(carpet(), balls({rolling}));
  EXPECT_TRUE(all_of<Spins>(shot).empty());
  EXPECT_LT(at(shot, 0.05).spin.z, 0);
  EXPECT_EQ(at(shot, 1).spin.z, 0);
}

TEST(Slide, CurvesWithSpinAcrossTheWay) {
  // A masse: the slip of the point of contact, not the velocity, gives the direction of friction.
  Ball masse = ball(0, {0, 0}, {1, 0});
  masse.spin = {-60, 0, 0};
  const Shot shot = shot_of(carpet(), balls({masse}));
  const double slip_y = -60 * radius;
  const double slip = std::hypot(1, slip_y);
  const Vec2 a{-friction.sliding_friction * gravity * 1 / slip,
               -friction.sliding_friction * gravity * slip_y / slip};
  const BallState later = at(shot, 0.2);
  EXPECT_NEAR(later.position.x, 0.2 + a.x * 0.02, 1e-15);
  EXPECT_NEAR(later.position.y, a.y * 0.02, 1e-15);
  EXPECT_GT(later.position.y, 0);
}

TEST(Slide, OfASpinningShotIsTheSameInAnySlices) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    Chance chance(seed);
    Scene scene = table(friction, Han2005{}, BallFriction{});
    scene.pockets = JawedPockets{};
    scene.perturbation = Perturbation{0.001, 0.001};
    const State state = racked(scene, 1e-4);
    const Strike strike{BallId{0},
                        {1, 0},
                        chance.between(1, 9),
                        {chance.between(-0.3, 0.3), chance.between(-0.3, 0.3)}};
    const Shot whole = shot_of(scene, state, strike, seed_of(seed));
    Simulation sliced(scene, state, strike, seed_of(seed), Limits{});
    double t = 0;
    while (sliced.advance_to(t) == Progress::paused) t += chance.between(0, 0.3);
    EXPECT_EQ(std::get<Shot>(std::move(sliced).take()), whole) << "seed " << seed;
  }
}

}  // namespace
}  // namespace breakshot::physics
