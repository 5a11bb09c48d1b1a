// Contacts that rub: throw and transfer of spin between balls, and cushions after Han 2005.
#include <gtest/gtest.h>

#include <cmath>

#include "common/physics/han2005.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

constexpr double radius = 0.028575;
constexpr PairLaw<double> balls_rub{radius, 0.009951, 0.108, 1.088, 0.2};

Moving<double> moving(Vec2 velocity, Vec3 spin = {}) {
  return {velocity, spin};
}

double energy(const Moving<double>& ball) {
  return dot(ball.velocity, ball.velocity) + 0.4 * radius * radius * dot(ball.spin, ball.spin);
}

/// Both balls after an impact of the frictional model, the normal part included.
void collide(Moving<double>& a, Moving<double>& b, Vec2 normal, double restitution) {
  const double impulse = (1 + restitution) / 2 * dot(a.velocity - b.velocity, normal);
  a.velocity = a.velocity - normal * impulse;
  b.velocity = b.velocity + normal * impulse;
  const Vec3 friction = pair_friction(a, b, normal, impulse, 1.0, balls_rub);
  const Vec3 to_contact{normal.x * radius, normal.y * radius, 0};
  push(a, to_contact, friction, radius);
  push(b, to_contact * -1.0, friction * -1.0, radius);
}

/// The angle in degrees by which the object ball leaves the line of centres.
double throw_deg(double cut_deg, double speed_m_s, Vec3 spin) {
  const double cut = cut_deg * std::acos(-1) / 180;
  Moving<double> cue = moving({speed_m_s * std::cos(cut), speed_m_s * std::sin(cut)}, spin);
  Moving<double> object = moving({});
  collide(cue, object, {1, 0}, 1.0);
  return std::atan2(object.velocity.y, object.velocity.x) * 180 / std::acos(-1);
}

// Alciatore, "Pool and billiards physics principles", TP A.14: a slow stun shot at half a ball
// throws by about 5 degrees, a fast one by about 2.
TEST(Throw, OfAStunShotIsAsMeasured) {
  EXPECT_NEAR(throw_deg(30, 0.447, {}), 5.0, 0.7);
  EXPECT_LT(throw_deg(30, 3.13, {}), 2.7);
  EXPECT_GT(throw_deg(30, 3.13, {}), 1.0);
}

TEST(Throw, VanishesWithGearingOutsideSpin) {
  const double v = 1;
  const double cut = std::acos(-1) / 6;
  // Surface velocities agree where R w = v sin(cut).
  const Vec3 gearing{0, 0, -v * std::sin(cut) / radius};
  EXPECT_NEAR(throw_deg(30, v, gearing), 0, 1e-12);
}

TEST(Throw, GivesTheObjectBallOppositeSpinAndTheSameOnBothSides) {
  Moving<double> cue = moving({1, 0}, {0, 0, 50});
  Moving<double> object = moving({});
  collide(cue, object, {1, 0}, 0.95);
  EXPECT_LT(object.spin.z, 0);
  EXPECT_NEAR(throw_deg(30, 1, {0, 0, 20}), -throw_deg(-30, 1, {0, 0, -20}), 1e-12);
}

TEST(Throw, NeverGivesEnergy) {
  for (std::uint32_t seed = 0; seed < 20'000; ++seed) {
    Chance chance(seed);
    const auto speed = [&] { return chance.between(-5, 5); };
    const auto spin = [&] { return chance.between(-300, 300); };
    Moving<double> a = moving({speed(), speed()}, {spin(), spin(), spin()});
    Moving<double> b = moving({speed(), speed()}, {spin(), spin(), spin()});
    if (a.velocity.x <= b.velocity.x) continue;
    const double before = energy(a) + energy(b);
    collide(a, b, {1, 0}, chance.between(0, 1));
    ASSERT_LE(energy(a) + energy(b), before * (1 + 1e-14)) << "seed " << seed;
    ASSERT_GE(b.velocity.x - a.velocity.x, -1e-13) << "seed " << seed;
  }
}

constexpr NoseLaw<double> nose{radius, 0.0357, 0.2, 0.2, 0};

TEST(Han, WithoutFrictionOrHeightIsRestitution) {
  const NoseLaw<double> plain{radius, radius, 0, 0, 0};
  const Moving<double> after = after_han2005(moving({2, 1}, {3, 4, 5}), {1, 0}, 0.85, plain);
  EXPECT_NEAR(after.velocity.x, -1.7, 1e-15);
  EXPECT_EQ(after.velocity.y, 1);
  EXPECT_NEAR(after.spin.x - 3, 0, 1e-12);
  EXPECT_NEAR(after.spin.z - 5, 0, 1e-12);
}

TEST(Han, RunningSpinWidensTheReboundAndReverseSpinNarrowsIt) {
  const Vec2 in{2, 2};
  const auto slope = [&](double spin) {
    const Moving<double> after = after_han2005(moving(in, {0, 0, spin}), {1, 0}, 0.85, nose);
    return after.velocity.y / -after.velocity.x;
  };
  // Towards +x with the cushion ahead, clockwise spin drives the ball on along it.
  EXPECT_GT(slope(-100), slope(0));
  EXPECT_LT(slope(100), slope(0));
}

TEST(Han, NeverGivesEnergyAndIsTheSameOnBothSides) {
  for (std::uint32_t seed = 0; seed < 20'000; ++seed) {
    Chance chance(seed);
    const Moving<double> ball =
        moving({chance.between(0, 8), chance.between(-8, 8)},
               {chance.between(-300, 300), chance.between(-300, 300), chance.between(-300, 300)});
    const NoseLaw<double> law{radius, radius * chance.between(1, 1.5), chance.between(0, 1), 0.2,
                              0};
    const double e = chance.between(0, 1);
    const Moving<double> after = after_han2005(ball, {1, 0}, e, law);
    ASSERT_LE(energy(after), energy(ball) * (1 + 1e-14)) << "seed " << seed;
    const Moving<double> mirrored = after_han2005(
        moving({ball.velocity.x, -ball.velocity.y}, {-ball.spin.x, ball.spin.y, -ball.spin.z}),
        {1, 0}, e, law);
    ASSERT_EQ(mirrored.velocity, (Vec2{after.velocity.x, -after.velocity.y})) << "seed " << seed;
  }
}

}  // namespace
}  // namespace breakshot::physics
