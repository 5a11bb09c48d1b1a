#include "client_cli/figures.hpp"

#include "client_cli/command.hpp"
#include "common/physics/angle.hpp"
#include "common/physics/simulate.hpp"
#include "common/rules/eight_ball.hpp"

namespace breakshot::client {
namespace {

/// A good amateur's break.
constexpr double break_speed_m_s = 8;
/// The break of figures 3 and 4 comes a little from the side, as players break: dead centre, a rack
/// with gaps passes nearly all of the energy to its two back corners.
constexpr double break_angle_rad = 3 * physics::pi / 180;
/// Any seed would do; this one is the same for everybody.
constexpr physics::Seed figure_seed{};

physics::Shot default_break(const physics::Scene& scene, const physics::State& rack) {
  const physics::Strike strike{rules::cue_ball, physics::direction_of(break_angle_rad),
                               break_speed_m_s};
  physics::Limits limits;
  limits.max_events = physics::max_match_events;
  auto result = physics::simulate(scene, rack, strike, {figure_seed, 0}, limits);
  if (auto* shot = std::get_if<physics::Shot>(&result)) return std::move(*shot);
  throw CommandError("the break stalled and cannot be drawn");
}

Picture of_layout(const physics::Scene& scene, const physics::State& rack) {
  Picture picture;
  picture.table = table_of(scene);
  picture.balls = drawn(rack);
  return picture;
}

Picture of_rack(const physics::Scene& scene, const physics::State& rack) {
  Picture picture = of_layout(scene, rack);
  const physics::Vec2 apex = picture.table.foot_spot.value();
  const double radius = picture.table.ball_radius_m;
  picture.window = Box{{apex.x - 5 * radius, -9 * radius}, {apex.x + 13 * radius, 9 * radius}};
  return picture;
}

Picture of_break(const physics::Scene& scene, const physics::State& rack, double time_s,
                 bool paths) {
  Picture picture;
  picture.table = table_of(scene);
  const physics::Timeline timeline(default_break(scene, rack));
  picture.balls = balls_at(picture.table, timeline, time_s);
  if (paths) picture.paths = paths_until(timeline, time_s);
  return picture;
}

/// How the cue ball is struck from the head spot.
CueVector cue_vector(const Table& table, double angle_rad) {
  return {table.head_spot.value(), physics::direction_of(angle_rad), break_speed_m_s};
}

}  // namespace

Picture figure(int number, const physics::Scene& scene, std::optional<double> time_s,
               const Besides& besides) {
  const physics::State rack = rules::rack_eight_ball(scene, figure_seed, 0);
  // Nothing moves in the first two.
  if (number == 2) return of_rack(scene, rack);
  if (number == 1) {
    Picture picture = of_layout(scene, rack);
    picture.cue = cue_vector(picture.table, 0);
    return picture;
  }
  Picture picture = of_break(scene, rack, time_s.value_or(figure_break_s), besides.paths);
  picture.velocities = number == 4 || besides.velocities;
  if (besides.cue) picture.cue = cue_vector(picture.table, break_angle_rad);
  return picture;
}

}  // namespace breakshot::client
