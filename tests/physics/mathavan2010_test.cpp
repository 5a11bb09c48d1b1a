#include "common/physics/mathavan2010.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/moving_balls.hpp"

namespace breakshot::physics {
namespace {

using support::Ball;
using support::Chance;

constexpr double radius = 0.02625;
constexpr Vec2 up{0, 1};

NoseLaw<double> published() {
  return {radius, radius * 7 / 5, 0.14, 0.212, 0};
}

NoseLaw<double> any_law(Chance& chance, double most_friction) {
  return {radius, radius * chance.between(1, 1.9), chance.between(0, most_friction),
          chance.between(0, most_friction), 0};
}

double any_restitution(Chance& chance) {
  const std::size_t kind = chance.below(6);
  return kind < 2 ? static_cast<double>(kind) : chance.between(0, 1);
}

/// The paper's equations as they stand, by Euler's method: a ball that rolls or slides into the
/// cushion at +y.
Ball by_the_paper(const Ball& ball, const NoseLaw<double>& law, double e, int steps) {
  const double s = (law.height - radius) / radius;
  const double c = std::sqrt(1 - s * s);
  double vx = ball.velocity.x, vy = ball.velocity.y;
  double wx = ball.spin.x * radius, wy = ball.spin.y * radius, wz = ball.spin.z * radius;
  const double dp = vy / steps;
  double work = 0;
  double due = -1;
  while (due < 0 || work < due) {
    const double slip_x = vx + wy * s - wz * c, slip_y = -vy * s + wx;
    const double bed_x = vx - wy, bed_y = vy + wx;
    const double phi = std::atan2(slip_y, slip_x), psi = std::atan2(bed_y, bed_x);
    const double rub = law.cloth_friction * (s + law.friction * std::sin(phi) * c);
    const double before = vy;
    vx -= (law.friction * std::cos(phi) + rub * std::cos(psi)) * dp;
    vy -= (c - law.friction * s * std::sin(phi) + rub * std::sin(psi)) * dp;
    wx -= 2.5 * (law.friction * std::sin(phi) + rub * std::sin(psi)) * dp;
    wy -= 2.5 * (law.friction * std::cos(phi) * s - rub * std::cos(psi)) * dp;
    wz += 2.5 * law.friction * std::cos(phi) * c * dp;
    work += std::fabs(before + vy) / 2 * c * dp;
    if (due < 0 && vy <= 0) {
      due = e * e * work;
      work = 0;
    }
  }
  return {{vx, vy}, {wx / radius, wy / radius, wz / radius}};
}

TEST(Mathavan2010, AgreesWithThePublishedEquationsInSmallSteps) {
  constexpr std::uint64_t seed = 21;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  double total = 0;
  for (int i = 0; i < 60; ++i) {
    const double speed = chance.between(0.3, 2.5);
    const double angle = chance.between(0.1, 1.55);
    const double follow = chance.between(-1, 2) * speed / radius;
    const Ball ball{{speed * std::cos(angle), speed * std::sin(angle)},
                    {-follow * std::sin(angle), follow * std::cos(angle),
                     chance.between(-2, 2) * speed / radius}};
    const Ball ours = after_mathavan2010(ball, up, 0.98, published());
    const Ball theirs = by_the_paper(ball, published(), 0.98, 100'000);
    const double off = support::difference(ours, theirs, radius) / speed;
    ASSERT_LT(off, 4e-3) << i;
    total += off;
  }
  EXPECT_LT(total / 60, 5e-4);
}

TEST(Mathavan2010, NeverGainsEnergyAndAlwaysLeaves) {
  constexpr std::uint64_t seed = 22;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 40'000; ++i) {
    const NoseLaw<double> law = any_law(chance, i % 3 == 0 ? 10 : 0.5);
    const Ball ball = support::random_ball(chance, radius, 1e-9, 100);
    const Ball after = after_mathavan2010(ball, up, any_restitution(chance), law);
    const double before = support::energy_of(ball, radius);
    ASSERT_LE(support::energy_of(after, radius), before * (1 + 1e-12)) << i;
    ASSERT_LE(after.velocity.y, 1e-15 * std::sqrt(before)) << i;
    if (!(ball.velocity.y > 0)) {
      ASSERT_EQ(after.velocity, ball.velocity);
      ASSERT_EQ(after.spin, ball.spin);
    }
  }
}

TEST(Mathavan2010, WithoutFrictionOrHeightIsPlainRestitution) {
  constexpr std::uint64_t seed = 23;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 2'000; ++i) {
    const double e = any_restitution(chance);
    const double height = i % 2 == 0 ? radius : radius * chance.between(1, 1.9);
    Ball ball = support::random_ball(chance, radius, 1e-9, 100);
    if (ball.velocity.y < 0) ball.velocity.y = -ball.velocity.y;
    const double speed = ball.velocity.y;
    const Ball after = after_mathavan2010(ball, up, e, {radius, height, 0, 0, 0});
    ASSERT_NEAR(after.velocity.y, -e * speed, 1e-14 * speed) << i;
    ASSERT_EQ(after.velocity.x, ball.velocity.x);
    ASSERT_EQ(after.spin, ball.spin);
  }
}

TEST(Mathavan2010, IsSymmetricAndKnowsNoDirection) {
  constexpr std::uint64_t seed = 24;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 4'000; ++i) {
    const NoseLaw<double> law = any_law(chance, 0.5);
    const double e = chance.between(0.1, 1);
    const Ball ball = support::random_ball(chance, radius, 1e-3, 10);
    const Ball after = after_mathavan2010(ball, up, e, law);
    const double size = std::sqrt(support::energy_of(ball, radius));
    const Ball mirror = after_mathavan2010(support::mirrored(ball), up, e, law);
    ASSERT_EQ(support::difference(mirror, support::mirrored(after), radius), 0) << i;
    const double angle = chance.between(0, 6.28);
    const Vec2 by{std::cos(angle), std::sin(angle)};
    const Ball turned =
        after_mathavan2010(support::turned(ball, by), support::turned(up, by), e, law);
    ASSERT_LT(support::difference(turned, support::turned(after, by), radius), 1e-11 * size) << i;
  }
}

TEST(Mathavan2010, HardlyDependsOnTheStep) {
  constexpr std::uint64_t seed = 25;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  double total = 0;
  for (int i = 0; i < 5'000; ++i) {
    Ball ball = support::random_ball(chance, radius, 0.1, 3);
    const NoseLaw<double> law{radius, radius * chance.between(1, 1.45), chance.between(0, 0.4),
                              chance.between(0, 0.4), 0};
    const double size = std::sqrt(2 * support::energy_of(ball, radius));
    const double e = chance.between(0, 1);
    const Ball coarse = after_mathavan2010(ball, up, e, law);
    const Ball fine = after_mathavan2010(ball, up, e, law, 2 * impact_steps);
    const double off = support::difference(coarse, fine, radius) / size;
    ASSERT_LT(off, 1.2e-2) << i;
    total += off;
  }
  EXPECT_LT(total / 5'000, 2e-4);
}

TEST(Mathavan2010, ScalesWithSpeed) {
  const Ball ball{{0.3, 1}, {-20, 10, 30}};
  const Ball after = after_mathavan2010(ball, up, 0.98, published());
  const double slow = 0x1p-600;
  const Ball slower =
      after_mathavan2010<double>({ball.velocity * slow, ball.spin * slow}, up, 0.98, published());
  EXPECT_NEAR(slower.velocity.x / slow, after.velocity.x, 1e-14);
  EXPECT_NEAR(slower.velocity.y / slow, after.velocity.y, 1e-14);
  EXPECT_NEAR(slower.spin.z / slow, after.spin.z, 1e-12);
}

TEST(Mathavan2010, StaysFiniteWhereFrictionDrawsAHardlyMovingBallIn) {
  const NoseLaw<double> law{radius, radius * 1.9, 10, 10, 0};
  for (const double speed : {1e-3, 1e-9, 1e-100, 1e-300}) {
    const Ball ball{{0, speed}, {100 / radius, 0, 0}};
    const Ball after = after_mathavan2010(ball, up, 1.0, law);
    EXPECT_LE(support::energy_of(after, radius), support::energy_of(ball, radius));
    EXPECT_LE(after.velocity.y, 0);
  }
}

TEST(Mathavan2010, HoldsForEveryScalar) {
  const Ball ball{{0.3, 1}, {-20, 10, 30}};
  const Ball after = after_mathavan2010(ball, up, 0.98, published());
  const NoseLaw<float> law{0.02625F, 0.03675F, 0.14F, 0.212F, 0};
  const auto single = after_mathavan2010<float>({{0.3F, 1}, {-20, 10, 30}}, {0, 1}, 0.98F, law);
  EXPECT_NEAR(static_cast<double>(single.velocity.y), after.velocity.y, 1e-4);
  const NoseLaw<long double> wide{0.02625L, 0.03675L, 0.14L, 0.212L, 0};
  const auto extended =
      after_mathavan2010<long double>({{0.3L, 1}, {-20, 10, 30}}, {0, 1}, 0.98L, wide);
  EXPECT_NEAR(static_cast<double>(extended.velocity.y), after.velocity.y, 1e-13);
}

}  // namespace
}  // namespace breakshot::physics
