// Millions of events, and endless times with thousands.
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
  // Four discs in a small box. A shot keeps everything that happened: the ten million are taken in
  // pieces, each from the state that the last one ended with.
  Scene scene = gas();
  scene.bed.length_m = 0.3;
  scene.bed.width_m = 0.25;
  scene.cushions = RectangleCushions{Mirror{}};
  State state = balls({ball(0, {-0.08, -0.06}, {3, 1}), ball(1, {0.08, -0.06}, {-1, 2}),
                       ball(2, {-0.08, 0.06}, {0.5, -2}), ball(3, {0.08, 0.06}, {1, 1})});
  const auto energy = [](const State& s) {
    long double sum = 0;
    for (const Ball& b : s.balls) {
      sum += static_cast<long double>(b.velocity.x) * b.velocity.x +
             static_cast<long double>(b.velocity.y) * b.velocity.y;
    }
    return sum;
  };
  const long double start = energy(state);
  std::size_t events = 0;
  while (events < 10'000'000) {
    Limits limits = until(1e9);
    limits.max_events = 100'000;
    const auto outcome = simulate(scene, state, std::nullopt, {}, limits);
    const auto* full = std::get_if<Stalled>(&outcome);
    ASSERT_NE(full, nullptr);
    ASSERT_EQ(full->cause, StallCause::events);
    events += full->so_far.events.size();
    const double end = full->so_far.end_s;
    for (const BallState& b : Timeline(full->so_far).states(end)) {
      Ball& next = state.balls[number(b.id)];
      next.position = b.position;
      next.velocity = b.velocity;
    }
  }
  EXPECT_LT(std::abs(static_cast<double>(energy(state) / start - 1)), 1e-12);
}

}  // namespace
}  // namespace breakshot::physics
