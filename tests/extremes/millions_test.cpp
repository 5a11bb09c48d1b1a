// Millions of events, and endless times with thousands.
#include <array>

#include "common/physics/simulation.hpp"
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

/// Where a ball between mirrors is, unfolded: the bed becomes endless, and the way straight.
double unfolded(double from, double velocity, double time_s, double half) {
  const double reach = half - radius_m;
  const long double along =
      static_cast<long double>(from) + reach + static_cast<long double>(velocity) * time_s;
  const long double period = 4 * static_cast<long double>(reach);
  long double rest = std::fmod(along, period);
  if (rest < 0) rest += period;
  return static_cast<double>((rest > 2 * static_cast<long double>(reach) ? period - rest : rest) -
                             reach);
}

TEST(Unfolded, TableIsWhereACreepingBallIsAfter1e12Seconds) {
  const Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  const Vec2 v{1.1e-9, 0.7e-9};
  const Shot shot = shot_of(scene, balls({ball(0, {0.1, 0.2}, v)}), std::nullopt, {}, until(1e12));
  EXPECT_GT(shot.events.size(), 900u);
  // An ulp of 1e12 s is 1.2e-4 s: 1e-13 m at this speed, at every hit.
  const double bound = 1.3e-13 * static_cast<double>(shot.events.size());
  EXPECT_NEAR(state_of(shot, 0).position.x, unfolded(0.1, v.x, 1e12, eight_foot_length_m / 2),
              bound);
  EXPECT_NEAR(state_of(shot, 0).position.y, unfolded(0.2, v.y, 1e12, eight_foot_width_m / 2),
              bound);
}

TEST(Unfolded, TableIsWhereABallIsAfterAMillionHits) {
  const Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  const Vec2 from{0.1, 0.2};
  const Vec2 v{1.234, 0.777};
  // About v.x / (L - 2R) + v.y / (W - 2R) hits a second.
  const double end = 1'000'000 / (v.x / (eight_foot_length_m - diameter_m) +
                                  v.y / (eight_foot_width_m - diameter_m));
  Limits limits = until(end);
  limits.max_events = 2'000'000;
  const Shot shot = shot_of(scene, balls({ball(0, from, v)}), std::nullopt, {}, limits);
  EXPECT_NEAR(static_cast<double>(shot.events.size()), 1e6, 10);
  EXPECT_EQ(
      length(Vec2{std::abs(state_of(shot, 0).velocity.x), std::abs(state_of(shot, 0).velocity.y)} -
             v),
      0);
  // Every hit rounds a time and a place: 1e6 times an ulp of 8e5 s at 1.5 m/s, if all fell one way.
  const double bound = 1e6 * 1.5 * ulp(end);
  EXPECT_NEAR(state_of(shot, 0).position.x, unfolded(from.x, v.x, end, eight_foot_length_m / 2),
              bound);
  EXPECT_NEAR(state_of(shot, 0).position.y, unfolded(from.y, v.y, end, eight_foot_width_m / 2),
              bound);
}

TEST(Millions, TenOfEventsWithoutFrictionKeepTheEnergy) {
  // Four discs in a small box; what happened is forgotten every now and then.
  Scene scene = gas();
  scene.bed.length_m = 0.3;
  scene.bed.width_m = 0.25;
  scene.cushions = RectangleCushions{Mirror{}};
  const State state = balls({ball(0, {-0.08, -0.06}, {3, 1}), ball(1, {0.08, -0.06}, {-1, 2}),
                             ball(2, {-0.08, 0.06}, {0.5, -2}), ball(3, {0.08, 0.06}, {1, 1})});
  std::array<Vec2, 4> velocities{};
  for (const Ball& b : state.balls) velocities[number(b.id)] = b.velocity;
  const auto energy = [&velocities] {
    long double sum = 0;
    for (const Vec2 v : velocities) {
      sum += static_cast<long double>(v.x) * v.x + static_cast<long double>(v.y) * v.y;
    }
    return sum;
  };
  const long double start = energy();
  Limits limits = until(1e9);
  limits.max_events = 20'000'000;
  Simulation simulation(scene, state, std::nullopt, {}, limits);
  std::size_t events = 0;
  for (double time_s = 0; events < 10'000'000; time_s += 100) {
    ASSERT_EQ(simulation.advance_to(time_s), Progress::paused);
    events += simulation.shot().events.size();
    for (const Segment& segment : simulation.shot().segments) {
      velocities[number(segment.ball)] = segment.velocity;
    }
    simulation.forget();
  }
  EXPECT_LT(std::abs(static_cast<double>(energy() / start - 1)), 1e-12);
}

}  // namespace
}  // namespace breakshot::physics
