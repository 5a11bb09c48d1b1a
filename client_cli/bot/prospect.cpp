#include "client_cli/bot/prospect.hpp"

#include <algorithm>
#include <cmath>

#include "common/rules/groups.hpp"

namespace breakshot::bot {
namespace {

// An error of the cue's direction of this many radians is forgiven by a pot of ease one half. It is
// about what the perturbation of normals of the usual scenes amounts to, and orders pots by how far
// they are from missing.
constexpr double half_ease_rad = 0.01;
// Cuts finer than this send the ball with less than a sixth of the speed: not worth a look.
constexpr double least_cut_cos = 0.17;
/// From where one would shoot with the ball in hand, m.
constexpr double in_hand_distance_m = 0.3;

/// Half the angle under which a gate is seen from a place, rad: small gates and short sines.
double half_angle(const Gate& gate, Vec2 place) {
  const Vec2 a = towards(place, gate.from);
  const Vec2 b = towards(place, gate.to);
  return physics::length(a - b) / 2;
}

double ease_of(const Gate& gate, Vec2 object, double cue_distance_m, double cut_cos,
               double radius_m) {
  const double forgiven =
      half_angle(gate, object) * cut_cos * 2 * radius_m / std::max(cue_distance_m, 2 * radius_m);
  return forgiven / (forgiven + half_ease_rad);
}

void sort_by_ease(std::vector<Pot>& pots) {
  std::stable_sort(pots.begin(), pots.end(),
                   [](const Pot& a, const Pot& b) { return a.ease > b.ease; });
}

/// Calls `look` with every target ball and gate between which the way is free.
template <class Look>
void each_lane(const Position& position, const Look& look) {
  const auto gates = gates_of(position.scene);
  const double radius = position.scene.ball.radius_m;
  for (const BallId id : targets_of(position)) {
    const Vec2 object = rules::find(position.table, id)->position;
    for (std::size_t i = 0; i < gates.size(); ++i) {
      const Vec2 target = gates[i].middle();
      if (!corridor_free(position.table, radius, object, target, id, rules::cue_ball)) continue;
      look(id, object, static_cast<PocketId>(i), gates[i]);
    }
  }
}

}  // namespace

std::vector<Pot> pots_of(const Position& position) {
  std::vector<Pot> pots;
  const double radius = position.scene.ball.radius_m;
  const physics::Ball* cue = rules::find(position.table, rules::cue_ball);
  if (cue == nullptr) return pots;
  each_lane(position, [&](BallId id, Vec2 object, PocketId pocket, const Gate& gate) {
    const auto aim = aim_of(cue->position, object, towards(object, gate.middle()), radius);
    if (!aim || aim->cut_cos < least_cut_cos) return;
    if (!corridor_free(position.table, radius, cue->position, aim->ghost, rules::cue_ball, id)) {
      return;
    }
    const double distance = physics::length(aim->ghost - cue->position);
    pots.push_back(
        {id, pocket, gate.middle(), ease_of(gate, object, distance, aim->cut_cos, radius)});
  });
  sort_by_ease(pots);
  return pots;
}

std::vector<Pot> lanes_of(const Position& position) {
  std::vector<Pot> lanes;
  const double radius = position.scene.ball.radius_m;
  each_lane(position, [&](BallId id, Vec2 object, PocketId pocket, const Gate& gate) {
    lanes.push_back(
        {id, pocket, gate.middle(), ease_of(gate, object, in_hand_distance_m, 1, radius)});
  });
  sort_by_ease(lanes);
  return lanes;
}

double prospect_of(const Position& position) {
  const bool in_hand = position.status.ball_in_hand != rules::BallInHand::none;
  const auto pots = in_hand ? lanes_of(position) : pots_of(position);
  if (pots.empty()) return -0.1;
  double second = 0;
  for (const Pot& pot : pots) {
    if (pot.ball != pots.front().ball) second = std::max(second, pot.ease);
  }
  return 0.1 + 0.5 * pots.front().ease + 0.15 * second;
}

}  // namespace breakshot::bot
