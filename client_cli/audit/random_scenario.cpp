#include "client_cli/audit/random_scenario.hpp"

#include <array>
#include <initializer_list>

#include "common/physics/angle.hpp"
#include "common/physics/table.hpp"

namespace breakshot::client {
namespace {

using namespace physics;

/// Draws of one scenario: the generator of the physics, which is the same everywhere.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint32_t number)
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
        number_(number) {}

  std::uint32_t below(std::uint32_t n) { return next() % n; }
  bool one_in(std::uint32_t n) { return below(n) == 0; }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next()) / 4294967296.0);
  }
  /// In [low, 2 high), evenly among orders of magnitude.
  double scale(double low, double high) {
    std::uint32_t doublings = 1;
    for (double top = 2 * low; top < high; top *= 2) ++doublings;
    double value = low;
    for (std::uint32_t left = below(doublings); left > 0; --left) value *= 2;
    return value * between(1, 2);
  }
  double one_of(std::initializer_list<double> values) {
    return values.begin()[below(static_cast<std::uint32_t>(values.size()))];
  }

 private:
  std::uint32_t next() { return philox({number_, count_++, 0, 0}, key_)[0]; }

  PhiloxKey key_;
  std::uint32_t number_;
  std::uint32_t count_ = 0;
};

Motion motion(Draws& draws) {
  switch (draws.below(4)) {
    case 0:
      return Frictionless{};
    case 1:
      return Straight{draws.between(0.05, 0.5), draws.between(0.005, 0.05), draws.between(0, 2)};
    default:
      return Spinning{draws.between(0.05, 0.5), draws.between(0.005, 0.05),
                      draws.between(0.002, 0.05)};
  }
}

CushionModel cushion(Draws& draws, const BallKind& ball) {
  const double e = draws.one_of({0, 0.01, draws.between(0, 1), 0.85, 1});
  const double friction = draws.one_of({0, 0.2, draws.between(0, 1)});
  const double height = ball.radius_m * draws.between(1, 1.4);
  switch (draws.below(5)) {
    case 0:
      return Mirror{};
    case 1:
      return CushionRestitution{e, draws.between(0, 1), default_elastic_below_m_s};
    case 2:
      return Mathavan2010{e, friction, height};
    case 3:
      return Stronge2000{e, friction, height, draws.between(1, 3)};
    default:
      return Han2005{e, friction, height};
  }
}

BallBallModel contact(Draws& draws) {
  const double e = draws.one_of({0, 0.01, draws.between(0, 1), 0.95, 1});
  switch (draws.below(4)) {
    case 0:
      return Elastic{};
    case 1:
      return BallRestitution{e, default_elastic_below_m_s};
    case 2:
      return Mathavan2014{e, draws.between(0, 0.2), default_elastic_below_m_s};
    default: {
      BallFriction model;
      model.restitution = e;
      return model;
    }
  }
}

Scene scene(Draws& draws) {
  const auto& all = tables();
  Scene scene = all[draws.below(static_cast<std::uint32_t>(all.size()))].scene;
  scene.bed.motion = motion(draws);
  scene.cushions = RectangleCushions{cushion(draws, scene.ball)};
  scene.ball_ball = contact(draws);
  const std::uint32_t pockets = draws.below(4);
  if (pockets == 0) scene.pockets.reset();
  if (pockets == 1) scene.pockets = StandardPockets{};
  const double scale = draws.one_of({0, 0, 0.0005, 0.01, 1});
  scene.perturbation = Perturbation{scale, scale};
  if (scale == 0) scene.perturbation.reset();
  return scene;
}

Ball ball_at(std::size_t id, Vec2 position) {
  return {BallId{static_cast<std::uint32_t>(id)}, position, {}, {}};
}

bool fits(const Scene& scene, const State& state, Ball ball) {
  for (const Ball& other : state.balls) {
    if (length(other.position - ball.position) < 2 * scene.ball.radius_m) return false;
  }
  return faults_of(scene, State{{ball}}).empty();
}

/// A cue ball on its spot and a rack, tight or with gaps.
State rack(Draws& draws, const Scene& scene) {
  const double gap = draws.one_of({0, 1e-15, 1e-12, draws.scale(1e-12, 1e-2), 0.00254, 1e-4});
  State state{{ball_at(0, head_spot(scene.bed))}};
  for (const Vec2 place : triangle_rack(scene.bed, scene.ball, gap)) {
    state.balls.push_back(ball_at(state.balls.size(), place));
  }
  return state;
}

/// Balls here and there; some frozen to the one before or to a cushion.
State scattered(Draws& draws, const Scene& scene) {
  const Vec2 free{*scene.bed.length_m / 2 - scene.ball.radius_m,
                  *scene.bed.width_m / 2 - scene.ball.radius_m};
  State state;
  const std::size_t wanted = 1 + draws.below(15);
  for (int tries = 0; tries < 200 && state.balls.size() < wanted; ++tries) {
    Vec2 place{draws.between(-free.x, free.x), draws.between(-free.y, free.y)};
    if (!state.balls.empty() && draws.one_in(4)) {
      const Vec2 away = direction_of(draws.between(0, 2 * pi));
      place = state.balls.back().position + away * (2 * scene.ball.radius_m * (1 + 1e-15));
    } else if (draws.one_in(8)) {
      place.y = free.y;
    }
    const Ball ball = ball_at(state.balls.size(), place);
    if (fits(scene, state, ball)) state.balls.push_back(ball);
  }
  if (state.balls.empty()) state.balls.push_back(ball_at(0, {0, 0}));
  return state;
}

Strike stroke(Draws& draws, const Scene& scene, bool breaks) {
  Strike strike;
  const double angle =
      breaks ? draws.one_of({0, draws.between(-0.1, 0.1)}) : draws.between(-pi, pi);
  strike.direction = direction_of(angle);
  strike.speed_m_s = draws.scale(breaks ? 1 : 0.01, 12);
  if (std::holds_alternative<Spinning>(scene.bed.motion) && draws.one_in(2)) {
    const double offset = draws.between(0, 0.499);
    const Vec2 tip = direction_of(draws.between(-pi, pi)) * offset;
    strike.tip = {tip.x, tip.y};
  }
  return strike;
}

}  // namespace

wire::Scenario random_scenario(std::uint64_t seed, std::uint32_t number) {
  Draws draws(seed, number);
  wire::Scenario scenario;
  scenario.scene = scene(draws);
  const bool breaks = draws.one_in(2);
  scenario.state = breaks ? rack(draws, scenario.scene) : scattered(draws, scenario.scene);
  scenario.strike = stroke(draws, scenario.scene, breaks);
  for (std::size_t i = 0; i < 8; ++i) {
    scenario.seed.seed[i] = static_cast<std::uint8_t>(seed >> 8 * i);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    scenario.seed.seed[8 + i] = static_cast<std::uint8_t>(number >> 8 * i);
  }
  if (may_never_rest(scenario.scene)) scenario.limits.horizon_s = 3;
  return scenario;
}

}  // namespace breakshot::client
