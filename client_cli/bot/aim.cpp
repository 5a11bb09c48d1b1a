#include "client_cli/bot/aim.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace breakshot::bot {
namespace {

/// The line that centres of balls can reach in front of a cushion, as a point, the unit vector
/// along it and the unit normal into the table.
struct Rail {
  Vec2 from;
  Vec2 along;
  Vec2 inward;
  double length_m;
};

Rail rail_of(const physics::CushionSegment& cushion, double radius_m) {
  const Vec2 along = towards(cushion.from, cushion.to);
  const Vec2 inward = physics::perp(along);
  return {cushion.from + inward * radius_m, along, inward,
          physics::length(cushion.to - cushion.from)};
}

/// How far a ball at `from` goes along `direction` until it touches a ball at `other`, m.
std::optional<double> distance_to_ball(Vec2 from, Vec2 direction, Vec2 other, double radius_m) {
  const Vec2 gap = other - from;
  const double along = physics::dot(gap, direction);
  if (along <= 0) return std::nullopt;
  const double beside = physics::cross(direction, gap);
  const double reach_squared = 4 * radius_m * radius_m - beside * beside;
  if (reach_squared <= 0) return std::nullopt;
  return std::max(0.0, along - std::sqrt(reach_squared));
}

std::optional<double> distance_to_rail(Vec2 from, Vec2 direction, const Rail& rail) {
  const double approach = -physics::dot(direction, rail.inward);
  if (approach <= 0) return std::nullopt;
  const double distance = physics::dot(from - rail.from, rail.inward) / approach;
  if (distance < 0) return std::nullopt;
  const double along = physics::dot(from + direction * distance - rail.from, rail.along);
  if (along < 0 || along > rail.length_m) return std::nullopt;
  return distance;
}

/// The shares of a ball's speed across and along a cushion that it keeps.
struct Kept {
  double normal = 1;
  double tangential = 1;
};

Kept kept_by(const physics::Mirror&) {
  return {};
}
Kept kept_by(const physics::CushionRestitution& model) {
  return {model.normal, model.tangential};
}
/// Friction at the nose depends on the spin, which nobody knows when aiming.
template <class SpinningModel>
Kept kept_by(const SpinningModel& model) {
  return {model.restitution, 1};
}

/// Gates of six pockets from those of a corner and a side, each as the places of its ends for the
/// corner or side where x and y are positive.
std::vector<Gate> six_gates(const Gate& corner, const Gate& side) {
  const auto turned = [](const Gate& gate, double sx, double sy) {
    return Gate{{sx * gate.from.x, sy * gate.from.y}, {sx * gate.to.x, sy * gate.to.y}};
  };
  return {turned(corner, -1, -1), turned(side, 1, -1), turned(corner, 1, -1),
          turned(corner, 1, 1),   turned(side, 1, 1),  turned(corner, -1, 1)};
}

/// A contact with a cushion near enough to the pocket drops the ball: the gates lie on the
/// rectangle that centres can reach, whose corner is at `reach`.
std::vector<Gate> gates_of(const physics::StandardPockets& pockets, Vec2 reach, double radius_m) {
  // The contact is measured from the corner of the cushions, the centre from that of its rectangle.
  const double corner = pockets.corner_mouth_m / std::sqrt(2.0) - radius_m;
  const double side = pockets.side_mouth_m / 2;
  return six_gates({{reach.x, reach.y - corner}, {reach.x - corner, reach.y}},
                   {{-side, reach.y}, {side, reach.y}});
}

/// A ball goes between the points of the noses: the gates are the mouths, a radius shorter at
/// either end.
std::vector<Gate> gates_of(const physics::JawedPockets& pockets, Vec2 reach, double radius_m) {
  const double leg = pockets.corner_mouth_m / std::sqrt(2.0);
  const double in = radius_m / std::sqrt(2.0);
  const Vec2 corner{reach.x + radius_m, reach.y + radius_m};
  const double side = pockets.side_mouth_m / 2 - radius_m;
  return six_gates({{corner.x - in, corner.y - leg + in}, {corner.x - leg + in, corner.y - in}},
                   {{-side, corner.y}, {side, corner.y}});
}

}  // namespace

Vec2 towards(Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  const double distance = physics::length(way);
  if (!(distance > 0)) return {1, 0};
  return way / distance;
}

std::vector<Gate> gates_of(const physics::Scene& scene) {
  if (!scene.pockets || !scene.bed.length_m || !scene.bed.width_m) return {};
  const double radius = scene.ball.radius_m;
  const Vec2 reach{*scene.bed.length_m / 2 - radius, *scene.bed.width_m / 2 - radius};
  return std::visit([&](const auto& pockets) { return gates_of(pockets, reach, radius); },
                    *scene.pockets);
}

std::optional<Aim> aim_of(Vec2 cue, Vec2 object, Vec2 way, double radius_m) {
  if (physics::length(object - cue) <= 2 * radius_m) return std::nullopt;
  const Vec2 ghost = object - way * (2 * radius_m);
  const Vec2 direction = towards(cue, ghost);
  const double cut_cos = physics::dot(direction, way);
  if (cut_cos <= 0) return std::nullopt;
  return Aim{ghost, direction, cut_cos};
}

bool corridor_free(const physics::State& table, double radius_m, Vec2 from, Vec2 to, BallId mover,
                   std::optional<BallId> target) {
  const Vec2 way = towards(from, to);
  const double distance = physics::length(to - from);
  return std::none_of(table.balls.begin(), table.balls.end(), [&](const physics::Ball& ball) {
    if (ball.id == mover || ball.id == target) return false;
    const double along = std::clamp(physics::dot(ball.position - from, way), 0.0, distance);
    return physics::length(ball.position - from - way * along) < 2 * radius_m;
  });
}

FirstContact first_contact(const physics::Scene& scene, const physics::State& table, BallId mover,
                           Vec2 direction, double reach_m) {
  const double radius = scene.ball.radius_m;
  const auto cue = std::find_if(table.balls.begin(), table.balls.end(),
                                [&](const physics::Ball& ball) { return ball.id == mover; });
  if (cue == table.balls.end()) return {};
  const Vec2 from = cue->position;
  double nearest = reach_m;
  const physics::Ball* hit = nullptr;
  for (const auto& cushion : physics::segments_of(scene)) {
    nearest = std::min(
        nearest, distance_to_rail(from, direction, rail_of(cushion, radius)).value_or(nearest));
  }
  for (const auto& ball : table.balls) {
    if (ball.id == mover) continue;
    const auto distance = distance_to_ball(from, direction, ball.position, radius);
    if (!distance || *distance >= nearest) continue;
    nearest = *distance;
    hit = &ball;
  }
  const Vec2 place = from + direction * nearest;
  if (hit == nullptr) return {place, std::nullopt, {}};
  return {place, hit->id, towards(place, hit->position)};
}

Vec2 image_in(const physics::CushionSegment& cushion, double radius_m, Vec2 place) {
  const Rail rail = rail_of(cushion, radius_m);
  double depth = physics::dot(place - rail.from, rail.inward);
  // After the rebound the ball needs depth / normal as long, and drifts along the cushion at
  // `tangential` of its speed meanwhile. A cushion that returns nothing has no image; half the
  // speed is the least for which aiming at one makes sense.
  const Kept kept = std::visit([](const auto& model) { return kept_by(model); }, cushion.model);
  depth *= kept.tangential / std::max(kept.normal, 0.5);
  const double along = physics::dot(place - rail.from, rail.along);
  return rail.from + rail.along * along - rail.inward * depth;
}

}  // namespace breakshot::bot
