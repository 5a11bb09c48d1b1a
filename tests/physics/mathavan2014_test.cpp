#include "common/physics/mathavan2014.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/moving_balls.hpp"

namespace breakshot::physics {
namespace {

using support::Ball;
using support::Chance;

constexpr double radius = 0.02625;
constexpr Vec2 up{0, 1};

struct Balls {
  Ball a;
  Ball b;
};

Balls after(const Balls& before, Vec2 normal, double e, const PairLaw<double>& law,
            int steps = impact_steps) {
  Balls balls = before;
  collide_mathavan2014(balls.a, balls.b, normal, e, law, steps);
  return balls;
}

double energy_of(const Balls& balls) {
  return support::energy_of(balls.a, radius) + support::energy_of(balls.b, radius);
}

double difference(const Balls& p, const Balls& q) {
  return std::hypot(support::difference(p.a, q.a, radius), support::difference(p.b, q.b, radius));
}

Balls any_balls(Chance& chance, double slowest, double fastest) {
  Balls balls{support::random_ball(chance, radius, slowest, fastest),
              support::random_ball(chance, radius, slowest, fastest)};
  if (chance.below(3) == 0) balls.b = {};
  return balls;
}

/// Where a sliding ball comes to roll: 5/7 of the velocity and 2/7 of what the spin would roll at.
Vec2 rolling_velocity(const Ball& ball) {
  const Vec2 roll{ball.spin.y * radius, -ball.spin.x * radius};
  return ball.velocity * (5.0 / 7) + roll * (2.0 / 7);
}

TEST(Mathavan2014, GivesThePublishedSpeedsAndAngles) {
  // Tables 1 and 2 of the paper: a rolling cue ball of this speed and cut angle; speeds when both
  // balls have come to roll, and the angles to the cue ball's path.
  struct Row {
    double speed, cut, cue_speed, object_speed, cue_angle, object_angle;
  };
  const Row rows[] = {{1.539, 33.83, 0.914, 0.831, 31.93, 32.20},
                      {1.032, 26.36, 0.520, 0.599, 32.45, 25.07},
                      {1.364, 40.52, 0.917, 0.676, 29.91, 38.62},
                      {1.731, 46.50, 1.280, 0.780, 27.32, 44.38},
                      {0.942, 18.05, 0.383, 0.579, 29.47, 17.15}};
  const double degree = std::acos(-1.0) / 180;
  for (const Row& row : rows) {
    const Vec2 way{std::sin(row.cut * degree), std::cos(row.cut * degree)};
    const Ball cue{way * row.speed, {-way.y * row.speed / radius, way.x * row.speed / radius, 0}};
    const Balls end = after({cue, {}}, up, 0.89, {radius, 0.05, 0, 0, 0.21});
    const Vec2 cue_end = rolling_velocity(end.a);
    const Vec2 object_end = rolling_velocity(end.b);
    const auto angle = [&](Vec2 v) { return std::acos(dot(v, way) / length(v)) / degree; };
    EXPECT_NEAR(length(cue_end), row.cue_speed, 0.01 * row.cue_speed);
    EXPECT_NEAR(length(object_end), row.object_speed, 0.01 * row.object_speed);
    EXPECT_NEAR(angle(cue_end), row.cue_angle, 0.01 * row.cue_angle);
    EXPECT_NEAR(angle(object_end), row.object_angle, 0.01 * row.object_angle);
  }
}

TEST(Mathavan2014, NeverGainsEnergyAndAlwaysSeparates) {
  constexpr std::uint64_t seed = 31;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 40'000; ++i) {
    const PairLaw<double> law{radius, chance.between(0, i % 3 == 0 ? 1 : 0.2), 0, 0,
                              chance.between(0, i % 5 == 0 ? 10 : 0.4)};
    const Balls before = any_balls(chance, 1e-9, 100);
    const double e = i % 4 == 0 ? 1 : chance.between(0, 1);
    const Balls end = after(before, up, e, law);
    const double energy = energy_of(before);
    ASSERT_LE(energy_of(end), energy * (1 + 1e-12)) << i;
    ASSERT_LE(end.a.velocity.y - end.b.velocity.y, 1e-15 * std::sqrt(energy)) << i;
    if (!(before.a.velocity.y > before.b.velocity.y)) {
      ASSERT_EQ(difference(before, end), 0) << i;
    }
  }
}

TEST(Mathavan2014, WithoutFrictionIsPlainRestitution) {
  constexpr std::uint64_t seed = 32;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 2'000; ++i) {
    const double e = chance.between(0, 1);
    Balls before = any_balls(chance, 1e-6, 100);
    if (before.a.velocity.y < before.b.velocity.y) std::swap(before.a, before.b);
    const Balls end = after(before, up, e, {radius, 0, 0, 0, 0.2});
    const double approach = before.a.velocity.y - before.b.velocity.y;
    const double sum = before.a.velocity.y + before.b.velocity.y;
    const double size = std::sqrt(energy_of(before));
    ASSERT_NEAR(end.a.velocity.y - end.b.velocity.y, -e * approach, 1e-14 * size) << i;
    ASSERT_NEAR(end.a.velocity.y + end.b.velocity.y, sum, 1e-14 * size) << i;
    ASSERT_EQ(end.a.velocity.x, before.a.velocity.x);
    ASSERT_EQ(end.a.spin, before.a.spin);
    ASSERT_EQ(end.b.spin, before.b.spin);
  }
}

TEST(Mathavan2014, WithoutClothFrictionKeepsMomentum) {
  constexpr std::uint64_t seed = 33;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 2'000; ++i) {
    const Balls before = any_balls(chance, 1e-3, 10);
    const Balls end = after(before, up, 0.9, {radius, chance.between(0, 0.5), 0, 0, 0});
    const Vec2 gained = end.a.velocity + end.b.velocity - before.a.velocity - before.b.velocity;
    ASSERT_LT(length(gained), 1e-14 * std::sqrt(energy_of(before))) << i;
  }
}

TEST(Mathavan2014, IsSymmetricAndKnowsNoDirectionAndNoOrder) {
  constexpr std::uint64_t seed = 34;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 4'000; ++i) {
    const PairLaw<double> law{radius, chance.between(0, 0.3), 0, 0, chance.between(0, 0.4)};
    const double e = chance.between(0.1, 1);
    const Balls before = any_balls(chance, 1e-2, 10);
    const double size = std::sqrt(energy_of(before));
    const Balls end = after(before, up, e, law);
    const Balls mirror =
        after({support::mirrored(before.a), support::mirrored(before.b)}, up, e, law);
    ASSERT_EQ(difference(mirror, {support::mirrored(end.a), support::mirrored(end.b)}), 0) << i;
    const Balls swapped = after({before.b, before.a}, {0, -1}, e, law);
    ASSERT_LT(difference({swapped.b, swapped.a}, end), 1e-14 * size) << i;
    const double angle = chance.between(0, 6.28);
    const Vec2 by{std::cos(angle), std::sin(angle)};
    const Balls turned = after({support::turned(before.a, by), support::turned(before.b, by)},
                               support::turned(up, by), e, law);
    ASSERT_LT(difference(turned, {support::turned(end.a, by), support::turned(end.b, by)}),
              1e-11 * size)
        << i;
  }
}

TEST(Mathavan2014, HardlyDependsOnTheStep) {
  constexpr std::uint64_t seed = 35;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  double total = 0;
  for (int i = 0; i < 5'000; ++i) {
    const PairLaw<double> law{radius, chance.between(0, 0.2), 0, 0, chance.between(0, 0.4)};
    const double e = chance.between(0, 1);
    const Balls before = any_balls(chance, 0.1, 3);
    const double size = std::sqrt(2 * energy_of(before));
    const Balls end = after(before, up, e, law);
    const double off = difference(end, after(before, up, e, law, 2 * impact_steps)) / size;
    ASSERT_LT(off, 4e-3) << i;
    total += off;
  }
  EXPECT_LT(total / 5'000, 4e-5);
}

}  // namespace
}  // namespace breakshot::physics
