#include "client_cli/draw/picture.hpp"

#include <algorithm>
#include <cmath>

#include "common/physics/table.hpp"

namespace breakshot::client {
namespace {

using physics::Vec2;

constexpr double sqrt_half = 0.70710678118654752;

void include(std::optional<Box>& box, Vec2 low, Vec2 high) {
  if (!box) {
    box = Box{low, high};
    return;
  }
  box->low = {std::min(box->low.x, low.x), std::min(box->low.y, low.y)};
  box->high = {std::max(box->high.x, high.x), std::max(box->high.y, high.y)};
}

/// The bed where the scene states it, else what holds every cushion and ball.
Box bed_of(const physics::Scene& scene, const std::vector<physics::CushionSegment>& cushions,
           const std::vector<physics::BallState>& balls) {
  const double radius = scene.ball.radius_m;
  std::optional<Box> box;
  if (scene.bed.length_m && scene.bed.width_m) {
    const Vec2 corner{*scene.bed.length_m / 2, *scene.bed.width_m / 2};
    box = Box{-corner, corner};
  }
  for (const auto& cushion : cushions) {
    include(box, cushion.from, cushion.from);
    include(box, cushion.to, cushion.to);
  }
  const bool bounded = scene.cushions.has_value();
  for (const auto& ball : balls) {
    if (bounded) break;
    const Vec2 reach{2 * radius, 2 * radius};
    include(box, ball.position - reach, ball.position + reach);
  }
  const Vec2 least{10 * radius, 10 * radius};
  return box.value_or(Box{-least, least});
}

/// Chords of an arc, so fine that it looks round. An arc runs counter-clockwise with the table
/// outside; its chords run the other way, with the table to their left like that of any cushion.
void add_chords(std::vector<physics::CushionSegment>& cushions, const physics::CushionArc& arc) {
  constexpr int chords = 24;
  const double begin = std::atan2(arc.from.y, arc.from.x);
  const double turn = std::atan2(physics::cross(arc.from, arc.to), physics::dot(arc.from, arc.to));
  const auto place = [&](int i) {
    const double angle = begin + turn * i / chords;
    return arc.centre + Vec2{std::cos(angle), std::sin(angle)} * arc.radius_m;
  };
  for (int i = 0; i < chords; ++i) cushions.push_back({place(i + 1), place(i), arc.model});
}

/// The noses as straight pieces: all that are drawn.
std::vector<physics::CushionSegment> noses_of(const physics::Scene& scene) {
  std::vector<physics::CushionSegment> cushions = physics::segments_of(scene);
  if (!scene.cushions) return cushions;
  if (const auto* free = std::get_if<physics::FreeCushions>(&*scene.cushions)) {
    for (const physics::CushionArc& arc : free->arcs) add_chords(cushions, arc);
  }
  return cushions;
}

DrawnPocket corner_pocket(Vec2 corner, double mouth_m) {
  const Vec2 inward{corner.x > 0 ? -1.0 : 1.0, corner.y > 0 ? -1.0 : 1.0};
  const double reach = mouth_m * sqrt_half;
  DrawnPocket pocket;
  pocket.mouth_from = {corner.x + inward.x * reach, corner.y};
  pocket.mouth_to = {corner.x, corner.y + inward.y * reach};
  pocket.radius_m = 0.52 * mouth_m;
  pocket.centre = corner - inward * (0.12 * mouth_m);
  return pocket;
}

DrawnPocket side_pocket(Vec2 middle, double mouth_m) {
  const double outward = middle.y > 0 ? 1.0 : -1.0;
  DrawnPocket pocket;
  pocket.mouth_from = {-mouth_m / 2, middle.y};
  pocket.mouth_to = {mouth_m / 2, middle.y};
  pocket.radius_m = 0.42 * mouth_m;
  pocket.centre = {0, middle.y + outward * 0.48 * mouth_m};
  return pocket;
}

std::vector<DrawnPocket> pockets_of(const Box& bed, double corner_mouth_m, double side_mouth_m) {
  const auto corner = [&](double x, double y) { return corner_pocket({x, y}, corner_mouth_m); };
  const auto side = [&](double y) { return side_pocket({0, y}, side_mouth_m); };
  return {corner(bed.low.x, bed.low.y),   side(bed.low.y),  corner(bed.high.x, bed.low.y),
          corner(bed.high.x, bed.high.y), side(bed.high.y), corner(bed.low.x, bed.high.y)};
}

/// Where a ball that dropped at `position` falls to.
Vec2 nearest_hole(const Table& table, Vec2 position) {
  Vec2 nearest = position;
  double best = -1;
  for (const DrawnPocket& pocket : table.pockets) {
    const double distance = physics::length(pocket.centre - position);
    if (best >= 0 && distance >= best) continue;
    best = distance;
    nearest = pocket.centre;
  }
  return nearest;
}

}  // namespace

Table table_of(const physics::Scene& scene, const std::vector<physics::BallState>& balls) {
  Table table;
  table.cushions = noses_of(scene);
  table.bed = bed_of(scene, table.cushions, balls);
  table.ball_radius_m = scene.ball.radius_m;
  table.has_rails =
      scene.cushions && std::holds_alternative<physics::RectangleCushions>(*scene.cushions);
  if (scene.pockets) {
    std::visit(
        [&](const auto& pockets) {
          table.pockets = pockets_of(table.bed, pockets.corner_mouth_m, pockets.side_mouth_m);
        },
        *scene.pockets);
  }
  if (table.has_rails) {
    table.head_spot = physics::head_spot(scene.bed);
    table.foot_spot = physics::foot_spot(scene.bed);
    table.head_string_x_m = physics::head_string_x(scene.bed);
  }
  return table;
}

double cushion_width(const Table& table) {
  return table.has_rails ? 1.8 * table.ball_radius_m : 0;
}

double wood_width(const Table& table) {
  return table.has_rails ? 3.4 * table.ball_radius_m : 0;
}

Box frame_of(const Table& table) {
  const double rail = cushion_width(table) + wood_width(table);
  const Vec2 reach{rail, rail};
  return {table.bed.low - reach, table.bed.high + reach};
}

std::vector<DrawnBall> drawn(const std::vector<physics::BallState>& balls) {
  std::vector<DrawnBall> all;
  for (const auto& ball : balls) {
    if (ball.phase == physics::Phase::pocketed) continue;
    all.push_back({ball.id, ball.position, ball.velocity, 1});
  }
  return all;
}

std::vector<DrawnBall> drawn(const physics::State& state) {
  std::vector<DrawnBall> all;
  for (const auto& ball : state.balls) all.push_back({ball.id, ball.position, {}, 1});
  return all;
}

std::vector<DrawnBall> balls_at(const Table& table, const physics::Timeline& timeline,
                                double time_s) {
  const auto states = timeline.states(time_s);
  std::vector<DrawnBall> all;
  for (const auto& ball : states) {
    if (ball.phase != physics::Phase::pocketed) continue;
    const double fallen = (time_s - timeline.path(ball.id).back().start_s) / falling_s;
    if (fallen >= 1) continue;
    const Vec2 hole = nearest_hole(table, ball.position);
    all.push_back({ball.id, ball.position + (hole - ball.position) * fallen, {}, 1 - 0.6 * fallen});
  }
  for (const DrawnBall& ball : drawn(states)) all.push_back(ball);
  return all;
}

std::vector<DrawnPath> paths_until(const physics::Timeline& timeline, double time_s) {
  std::vector<DrawnPath> all;
  for (const physics::BallId ball : timeline.balls()) {
    DrawnPath path{ball, {}};
    for (const physics::Segment& segment : timeline.path(ball)) {
      if (segment.start_s > time_s) break;
      if (path.points.empty() || !(path.points.back() == segment.position)) {
        path.points.push_back(segment.position);
      }
    }
    const Vec2 now = timeline.state(ball, time_s).position;
    if (!path.points.empty() && !(path.points.back() == now)) path.points.push_back(now);
    if (path.points.size() > 1) all.push_back(std::move(path));
  }
  return all;
}

}  // namespace breakshot::client
