#include "tests/golden/starts.hpp"

#include <cmath>

namespace breakshot::golden {
namespace {

using namespace physics;

double distance(Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  return std::sqrt(d.x * d.x + d.y * d.y);
}

/// Puts balls where nothing is yet, numbered as they come.
class Placing {
 public:
  Placing(const Scene& scene, Draws& draws)
      : draws_(draws),
        radius_m_(scene.ball.radius_m),
        spins_(std::holds_alternative<Spinning>(scene.bed.motion)),
        half_{*scene.bed.length_m / 2 - radius_m_, *scene.bed.width_m / 2 - radius_m_} {
    const bool box = scene.cushions && std::holds_alternative<FreeCushions>(*scene.cushions);
    if (!box) return;
    half_ = {0.4 * *scene.bed.length_m, 0.375 * *scene.bed.width_m};
    arcs_ = std::get<FreeCushions>(*scene.cushions).arcs;
  }

  double diameter_m() const { return 2 * radius_m_; }
  Vec2 half() const { return half_; }
  State& state() { return state_; }
  std::size_t count() const { return state_.balls.size(); }

  bool add(Vec2 place, Vec2 velocity = {}) {
    if (!(std::abs(place.x) <= half_.x && std::abs(place.y) <= half_.y)) return false;
    for (const Ball& other : state_.balls) {
      if (distance(other.position, place) < diameter_m() - 1e-13) return false;
    }
    for (const CushionArc& arc : arcs_) {
      if (distance(arc.centre, place) < arc.radius_m + radius_m_) return false;
    }
    const bool moves = velocity.x != 0 || velocity.y != 0;
    const BallId id{static_cast<std::uint32_t>(count())};
    state_.balls.push_back({id, place, velocity, moves && spins_ ? spin() : Vec3{}});
    return true;
  }

  /// A ball anywhere, now and then frozen to a long cushion.
  bool add_anywhere(Vec2 velocity = {}) {
    Vec2 place{draws_.between(-half_.x, half_.x), draws_.between(-half_.y, half_.y)};
    if (arcs_.empty() && draws_.one_in(10)) place.y = half_.y;
    return add(place, velocity);
  }

  Vec2 velocity() { return draws_.vector(0.05, 6); }

 private:
  Vec3 spin() {
    const double most = 2 / radius_m_;
    return {draws_.between(-most, most), draws_.between(-most, most), draws_.between(-most, most)};
  }

  Draws& draws_;
  double radius_m_;
  bool spins_;
  Vec2 half_;
  std::vector<CushionArc> arcs_;
  State state_;
};

Strike stroke(const Scene& scene, Vec2 direction, Draws& draws) {
  Strike strike;
  strike.direction = direction;
  strike.speed_m_s = draws.one_of({0.1, 1.0, 3.0, 5.0, 8.0, 12.0});
  strike.speed_m_s *= draws.between(0.7, 1);
  if (std::holds_alternative<Spinning>(scene.bed.motion) && draws.one_in(2)) {
    const Vec2 tip = draws.vector(0, 0.49);
    strike.tip = {tip.x, tip.y};
  }
  return strike;
}

/// Ball 0 towards the second one, at most a ball beside its middle.
Strike stroke_at_next(const Scene& scene, const State& state, Draws& draws) {
  const Vec2 cue = state.balls[0].position;
  const Vec2 beside = draws.vector(0, 2 * scene.ball.radius_m);
  const Vec2 target = state.balls[1].position + beside;
  const double away = distance(cue, target);
  if (!(away > 0)) return stroke(scene, draws.direction(), draws);
  return stroke(scene, {(target.x - cue.x) / away, (target.y - cue.y) / away}, draws);
}

/// Triangle rows from an apex right of the middle, until there are so many balls.
void add_rack(Placing& placing, std::size_t balls, Draws& draws) {
  const double spacing = placing.diameter_m() + draws.one_of({0.0, 0.0, 1e-9, 1e-4, 0.00254});
  for (int row = 0; row < 16; ++row) {
    for (int place = 0; place <= row && placing.count() < balls; ++place) {
      placing.add({placing.half().x / 4 + row * (spacing * 0.8660254037844386),
                   (place - row / 2.0) * spacing});
    }
  }
}

/// A row of balls that touch, in any direction, and the cue ball behind it.
void add_row(Placing& placing, Draws& draws) {
  const Vec2 along = draws.direction();
  const std::size_t balls = 2 + draws.below(5);
  placing.add(along * (-2.5 * placing.diameter_m()));
  for (std::size_t i = 0; i < balls; ++i) {
    placing.add(along * (static_cast<double>(i) * placing.diameter_m() * (1 + 1e-15)));
  }
}

void scatter(Placing& placing, std::size_t balls, bool moving) {
  for (int tries = 0; tries < 2000 && placing.count() < balls; ++tries) {
    placing.add_anywhere(moving ? placing.velocity() : Vec2{});
  }
}

std::string counted(const char* name, const State& state) {
  return std::string("-") + name + std::to_string(state.balls.size());
}

}  // namespace

Start start_of(const Scene& scene, Draws& draws) {
  Placing placing(scene, draws);
  State& state = placing.state();
  switch (draws.below(5)) {
    case 0:
      scatter(placing, 2, false);
      return {counted("pair", state), state, stroke_at_next(scene, state, draws)};
    case 1:
      add_row(placing, draws);
      return {counted("row", state), state, stroke_at_next(scene, state, draws)};
    case 2:
      placing.add({-placing.half().x / 2, 0});
      add_rack(placing, 16, draws);
      return {counted("rack", state), state, stroke_at_next(scene, state, draws)};
    case 3:
      scatter(placing, 4 + draws.below(12), false);
      return {counted("scattered", state), state, stroke_at_next(scene, state, draws)};
    default:
      scatter(placing, 4 + draws.below(12), true);
      return {counted("moving", state), state, std::nullopt};
  }
}

Start crowd_of(const Scene& scene, std::size_t balls, Draws& draws) {
  Placing placing(scene, draws);
  State& state = placing.state();
  if (draws.one_in(2)) {
    placing.add({-placing.half().x / 2, 0});
    add_rack(placing, balls, draws);
    return {counted("rack", state), state, stroke_at_next(scene, state, draws)};
  }
  scatter(placing, balls, true);
  return {counted("moving", state), state, std::nullopt};
}

}  // namespace breakshot::golden
