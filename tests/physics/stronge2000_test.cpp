#include "common/physics/stronge2000.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/moving_balls.hpp"

namespace breakshot::physics {
namespace {

using support::Ball;
using support::Chance;

constexpr double radius = 0.028575;
constexpr Vec2 up{0, 1};

NoseLaw<double> any_law(Chance& chance, double most_friction) {
  return {radius, radius * chance.between(1, 1.9), chance.between(0, most_friction), 0.2,
          chance.between(1, 10)};
}

/// Stronge's closed forms for a nose at the height of the centre and a slip of `slip` at an
/// approach of 1, friction mu: where the contact sticks, slips, sticks and slips again.
double slip_after(double slip, double mu, double e, double ratio) {
  const double quarter = std::acos(0.0);
  const double eta = 3.5 / (ratio * ratio);
  const auto phase = [&](double t) { return t <= quarter ? t : quarter + (t - quarter) / e; };
  const auto force = [&](double t) { return std::sin(phase(t)); };
  const auto impulse = [&](double t) { return 1 - (t <= quarter ? 1 : e) * std::cos(phase(t)); };
  const double end = quarter * (1 + e);
  if (slip >= mu * 3.5 && slip > mu * (3.5 * (1 + e) - eta / e)) {
    return slip - 3.5 * mu * (1 + e);
  }
  double stick_at = 0;
  if (slip > mu * eta) {
    const double late = slip / mu - 3.5;
    stick_at = late < 0 ? std::acos(late / (eta - 3.5))
                        : quarter + e * (std::acos(late / (eta / e - 3.5 * e)) - quarter);
  }
  const double x0 = stick_at > 0 ? mu * eta * force(stick_at) : 0;
  const double v0 = slip - 3.5 * mu * (stick_at > 0 ? impulse(stick_at) : 0);
  const auto stretch = [&](double t) {
    return x0 * std::cos(ratio * (t - stick_at)) + v0 / ratio * std::sin(ratio * (t - stick_at));
  };
  double low = stick_at > quarter ? stick_at : quarter;
  double high = end;
  for (int i = 0; i < 200; ++i) {
    const double t = (low + high) / 2;
    (std::fabs(stretch(t)) < mu * eta * force(t) ? low : high) = t;
  }
  const double t = high;
  const double v =
      v0 * std::cos(ratio * (t - stick_at)) - ratio * x0 * std::sin(ratio * (t - stick_at));
  const double sign = stretch(t) < 0 ? -1 : 1;
  return v - sign * 3.5 * mu * (1 + e - impulse(t));
}

TEST(Stronge2000, AgreesWithTheClosedFormsOfEveryPhase) {
  for (const double ratio : {1.2, 1.7, 1.8}) {
    for (const double e : {0.7, 0.85, 1.0}) {
      for (double slip = 0.05; slip < 3; slip += 0.05) {
        const double mu = 0.2;
        const NoseLaw<double> law{radius, radius, mu, 0, ratio};
        const Ball ball{{slip, 1}, {}};
        const Ball after = after_stronge2000(ball, up, e, law);
        const double surface = after.velocity.x - after.spin.z * radius;
        ASSERT_NEAR(surface, slip_after(slip, mu, e, ratio), 2e-3)
            << slip << ' ' << e << ' ' << ratio;
        const Ball fine = after_stronge2000(ball, up, e, law, 4096);
        ASSERT_NEAR(fine.velocity.x - fine.spin.z * radius, slip_after(slip, mu, e, ratio), 1e-5)
            << slip << ' ' << e << ' ' << ratio;
      }
    }
  }
}

TEST(Stronge2000, ReversesTheSlipWhereItSticks) {
  // A high friction holds the contact until the end: half a turn of the tangential spring and more.
  const NoseLaw<double> law{radius, radius, 1e6, 0, 1.5};
  const Ball after = after_stronge2000<double>({{0.4, 1}, {}}, up, 0.8, law);
  const double turn = 1.5 * std::acos(0.0) * 1.8;
  EXPECT_NEAR(after.velocity.x - after.spin.z * radius, 0.4 * std::cos(turn), 1e-5);
}

TEST(Stronge2000, SlidingThroughoutIsCoulombsImpulse) {
  const NoseLaw<double> law{radius, radius, 0.1, 0, 1.8};
  const Ball after = after_stronge2000<double>({{5, 1}, {}}, up, 0.9, law);
  EXPECT_NEAR(after.velocity.x, 5 - 0.1 * 1.9, 1e-14);
  EXPECT_NEAR(after.spin.z * radius, 2.5 * 0.1 * 1.9, 1e-14);
  EXPECT_NEAR(after.velocity.y, -0.9, 1e-15);
}

TEST(Stronge2000, NeverGainsEnergyAndAlwaysLeaves) {
  constexpr std::uint64_t seed = 41;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 40'000; ++i) {
    const NoseLaw<double> law = any_law(chance, i % 3 == 0 ? 10 : 0.5);
    const Ball ball = support::random_ball(chance, radius, 1e-9, 100);
    const std::size_t kind = chance.below(6);
    const double e = kind < 2 ? static_cast<double>(kind) : chance.between(0, 1);
    const Ball after = after_stronge2000(ball, up, e, law);
    const double before = support::energy_of(ball, radius);
    ASSERT_LE(support::energy_of(after, radius), before * (1 + 1e-12)) << i;
    ASSERT_LE(after.velocity.y, 1e-15 * std::sqrt(before)) << i;
    if (!(ball.velocity.y > 0)) {
      ASSERT_EQ(support::difference(after, ball, radius), 0) << i;
    }
  }
}

TEST(Stronge2000, WithoutFrictionAtTheCentreIsPlainRestitution) {
  constexpr std::uint64_t seed = 42;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 2'000; ++i) {
    const double e = chance.between(0, 1);
    Ball ball = support::random_ball(chance, radius, 1e-9, 100);
    if (ball.velocity.y < 0) ball.velocity.y = -ball.velocity.y;
    const double speed = ball.velocity.y;
    const Ball after = after_stronge2000(ball, up, e, {radius, radius, 0, 0.2, 1.8});
    ASSERT_NEAR(after.velocity.y, -e * speed, 1e-15 * speed) << i;
    ASSERT_EQ(after.velocity.x, ball.velocity.x);
    ASSERT_EQ(after.spin, ball.spin);
  }
}

TEST(Stronge2000, IsSymmetricAndKnowsNoDirection) {
  constexpr std::uint64_t seed = 43;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 4'000; ++i) {
    const NoseLaw<double> law = any_law(chance, 0.5);
    const double e = chance.between(0.1, 1);
    const Ball ball = support::random_ball(chance, radius, 1e-3, 10);
    const Ball after = after_stronge2000(ball, up, e, law);
    const double size = std::sqrt(support::energy_of(ball, radius));
    const Ball mirror = after_stronge2000(support::mirrored(ball), up, e, law);
    ASSERT_EQ(support::difference(mirror, support::mirrored(after), radius), 0) << i;
    const double angle = chance.between(0, 6.28);
    const Vec2 by{std::cos(angle), std::sin(angle)};
    const Ball turned =
        after_stronge2000(support::turned(ball, by), support::turned(up, by), e, law);
    ASSERT_LT(support::difference(turned, support::turned(after, by), radius), 1e-11 * size) << i;
  }
}

TEST(Stronge2000, HardlyDependsOnTheStep) {
  constexpr std::uint64_t seed = 44;
  SCOPED_TRACE(seed);
  Chance chance(seed);
  for (int i = 0; i < 5'000; ++i) {
    NoseLaw<double> law = any_law(chance, 0.4);
    const bool stiff = i % 2 == 0;
    if (!stiff) law.frequency_ratio = chance.between(1, 2);
    const Ball ball = support::random_ball(chance, radius, 0.1, 3);
    const double size = std::sqrt(2 * support::energy_of(ball, radius));
    const double e = chance.between(0, 1);
    const Ball coarse = after_stronge2000(ball, up, e, law);
    const Ball fine = after_stronge2000(ball, up, e, law, 2 * compliant_steps);
    ASSERT_LT(support::difference(coarse, fine, radius), (stiff ? 2e-3 : 2e-4) * size) << i;
  }
}

}  // namespace
}  // namespace breakshot::physics
