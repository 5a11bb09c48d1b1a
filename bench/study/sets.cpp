#include "bench/study/sets.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/physics/angle.hpp"
#include "common/physics/table.hpp"
#include "tests/support/gases.hpp"

namespace breakshot::bench {
namespace {

using namespace physics;
using support::Chance;

/// A named table. What is studied is the method: normals are not perturbed.
Scene table(std::string_view name) {
  for (const Preset& preset : presets()) {
    if (preset.name != name) continue;
    Scene scene = preset.scene;
    scene.perturbation.reset();
    return scene;
  }
  throw std::logic_error("there is no such table");
}

Ball ball(std::size_t id, Vec2 position) {
  return {BallId{static_cast<std::uint32_t>(id)}, position, {}, {}};
}

Strike stroke(Vec2 direction, double speed_m_s, Tip tip = {}) {
  return {BallId{0}, direction / length(direction), speed_m_s, tip};
}

wire::Scenario shot_of(Scene scene, State state, Strike strike) {
  wire::Scenario shot;
  shot.scene = std::move(scene);
  shot.state = std::move(state);
  shot.strike = strike;
  return shot;
}

/// Anywhere on the bed, `margin_m` clear of the cushions.
Vec2 place(Chance& chance, const Scene& scene, double margin_m) {
  const double x = *scene.bed.length_m / 2 - margin_m;
  const double y = *scene.bed.width_m / 2 - margin_m;
  return {chance.between(-x, x), chance.between(-y, y)};
}

/// Adds `count` balls anywhere, a finger apart from one another.
void scatter(Chance& chance, const Scene& scene, State& state, std::size_t count) {
  while (count > 0) {
    const Vec2 at = place(chance, scene, 0.1);
    const bool free = std::all_of(state.balls.begin(), state.balls.end(), [&](const Ball& other) {
      return length(other.position - at) > 0.08;
    });
    if (!free) continue;
    state.balls.push_back(ball(state.balls.size(), at));
    --count;
  }
}

wire::Scenario break_on(std::string_view name, double gap_m, double slowest, double fastest,
                        std::uint32_t number) {
  Chance chance(1000 + number);
  Scene scene = table(name);
  State state{{ball(0, head_spot(scene.bed) + Vec2{0, chance.between(-0.1, 0.1)})}};
  for (const Vec2 at : triangle_rack(scene.bed, scene.ball, gap_m)) {
    state.balls.push_back(ball(state.balls.size(), at));
  }
  const Vec2 aim =
      foot_spot(scene.bed) - state.balls[0].position + Vec2{0, chance.between(-0.01, 0.01)};
  return shot_of(scene, state, stroke(aim, chance.between(slowest, fastest)));
}

wire::Scenario plain_break(std::uint32_t number) {
  return break_on("plain", rack_gap_m, 6, 9, number);
}
wire::Scenario full_break(std::uint32_t number) {
  return break_on("club", rack_gap_m, 6, 9, number);
}
/// Every ball touches its neighbours: sets of many contacts.
wire::Scenario tight_rack(std::uint32_t number) {
  return break_on("club", 0, 2, 9, number);
}

/// The cue ball is sent to where it would have to be for the object ball to go to the pocket.
wire::Scenario cut_shot(std::uint32_t number) {
  Chance chance(2000 + number);
  const Scene scene = table("club");
  const auto pockets = pocket_targets(scene.bed);
  for (;;) {
    State state;
    scatter(chance, scene, state, 2);
    const Vec2 object = state.balls[1].position;
    const Vec2 to_pocket = pockets[chance.below(6)] - object;
    const Vec2 ghost = object - to_pocket * (2 * scene.ball.radius_m / length(to_pocket));
    const Vec2 aim = ghost - state.balls[0].position;
    const double fullness = dot(aim, to_pocket) / (length(aim) * length(to_pocket));
    if (fullness < 0.3 || length(aim) < 0.2) continue;
    const Tip tip{chance.between(-0.3, 0.3), chance.between(-0.3, 0.3)};
    return shot_of(scene, state, stroke(aim, chance.between(1, 4), tip));
  }
}

/// Softly and thinly at one of eight balls.
wire::Scenario safety(std::uint32_t number) {
  Chance chance(3000 + number);
  const Scene scene = table("club");
  State state;
  scatter(chance, scene, state, 9);
  const Vec2 aim = state.balls[1 + chance.below(8)].position - state.balls[0].position;
  const double aside = (chance.coin() ? 1 : -1) * chance.between(0.6, 0.95);
  const Vec2 thin = aim + perp(aim) * (aside * 2 * scene.ball.radius_m / length(aim));
  return shot_of(scene, state, stroke(thin, chance.between(0.6, 1.6)));
}

/// Off cushions, anywhere, among three balls.
wire::Scenario kick(std::uint32_t number) {
  Chance chance(4000 + number);
  const Scene scene = table("club");
  State state;
  scatter(chance, scene, state, 4);
  const Tip tip{chance.between(-0.4, 0.4), chance.between(-0.2, 0.2)};
  return shot_of(scene, state,
                 stroke(direction_of(chance.between(-pi, pi)), chance.between(3, 7), tip));
}

/// A slow ball with follow that pushes on through a row of two that touch.
wire::Scenario push_shot(std::uint32_t number) {
  Chance chance(5000 + number);
  const Scene scene = table("club");
  const double diameter = 2 * scene.ball.radius_m;
  State state{
      {ball(0, {-0.3, chance.between(-0.01, 0.01)}), ball(1, {0, 0}), ball(2, {diameter, 0})}};
  return shot_of(scene, state, stroke({1, 0}, chance.between(0.5, 2), Tip{0, 0.4}));
}

wire::Scenario gas(std::size_t discs, double cover, double horizon_s, std::uint32_t number) {
  const support::Gas made = support::gas_in_a_box(discs, cover, 6000 + number);
  wire::Scenario shot;
  shot.scene = made.scene;
  shot.state = made.state;
  shot.limits.horizon_s = horizon_s;
  return shot;
}

wire::Scenario gas_of_100(std::uint32_t number) {
  return gas(100, 0.2, 1.5, number);
}
wire::Scenario gas_of_1000(std::uint32_t number) {
  return gas(1000, 0.2, 1, number);
}
wire::Scenario dense_gas(std::uint32_t number) {
  return gas(1000, 0.7, 0.5, number);
}

}  // namespace

const std::vector<Set>& sets() {
  static const std::vector<Set> all = {
      {"break", "breaks at 6 to 9 m/s, straight paths, pockets without jaws", 10, 100, plain_break},
      {"break_full", "breaks with all that is modelled", 10, 100, full_break},
      {"rack", "breaks of a rack without gaps at 2 to 9 m/s", 10, 100, tight_rack},
      {"cut", "cut shots at a pocket with any tip", 20, 200, cut_shot},
      {"safety", "soft thin hits among eight balls", 20, 200, safety},
      {"kick", "long shots off cushions among three balls", 20, 200, kick},
      {"push", "a slow ball with follow pushes two that touch", 10, 100, push_shot},
      {"gas_100", "100 discs without friction, a fifth of the bed covered, 1.5 s", 3, 20,
       gas_of_100},
      {"gas_1000", "1,000 discs without friction, a fifth of the bed covered, 1 s", 1, 4,
       gas_of_1000},
      {"gas_dense", "1,000 discs that cover seven tenths of the bed, 0.5 s", 1, 4, dense_gas},
  };
  return all;
}

const Set& set_of(std::string_view name) {
  const auto found = std::find_if(sets().begin(), sets().end(),
                                  [name](const Set& set) { return set.name == name; });
  if (found == sets().end()) throw std::runtime_error("there is no set " + std::string(name));
  return *found;
}

}  // namespace breakshot::bench
