// What the scenes at the edges have in common: every combination of models, balls that roll, and
// the bounds that hold for all.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/physics/audit.hpp"
#include "common/physics/exact.hpp"
#include "common/physics/rails.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::support {

inline constexpr double radius_m = 0.028575;
inline constexpr double diameter_m = 2 * radius_m;

inline const std::array<physics::Motion, 3>& motions() {
  static const std::array<physics::Motion, 3> all{physics::Frictionless{}, physics::Straight{},
                                                  physics::Spinning{}};
  return all;
}

inline const std::array<physics::BallBallModel, 4>& pair_models() {
  static const std::array<physics::BallBallModel, 4> all{
      physics::Elastic{}, physics::BallRestitution{}, physics::BallFriction{},
      physics::Mathavan2014{}};
  return all;
}

inline const std::array<physics::CushionModel, 5>& cushion_models() {
  static const std::array<physics::CushionModel, 5> all{
      physics::Mirror{}, physics::CushionRestitution{0.85, 0.9, 1e-3}, physics::Han2005{},
      physics::Mathavan2010{}, physics::Stronge2000{}};
  return all;
}

inline std::string name_of(const physics::Scene& scene) {
  std::string name = "motion " + std::to_string(scene.bed.motion.index());
  if (scene.ball_ball) name += ", balls " + std::to_string(scene.ball_ball->index());
  if (const auto* r =
          scene.cushions ? std::get_if<physics::RectangleCushions>(&*scene.cushions) : nullptr) {
    name += ", cushions " + std::to_string(r->model.index());
  }
  return name + (scene.pockets ? ", pockets " + std::to_string(scene.pockets->index()) : "");
}

inline bool has_friction(const physics::Scene& scene) {
  return !std::holds_alternative<physics::Frictionless>(scene.bed.motion);
}

/// 8-foot tables without pockets, one for every combination of models.
inline std::vector<physics::Scene> every_table() {
  std::vector<physics::Scene> all;
  for (const physics::Motion& motion : motions()) {
    for (const physics::BallBallModel& pair : pair_models()) {
      for (const physics::CushionModel& cushion : cushion_models()) {
        all.push_back(table(motion, cushion, pair));
      }
    }
  }
  return all;
}

/// Endless beds, one for every motion and every contact of balls.
inline std::vector<physics::Scene> every_cloth() {
  std::vector<physics::Scene> all;
  for (const physics::Motion& motion : motions()) {
    for (const physics::BallBallModel& pair : pair_models()) {
      physics::Scene scene = gas();
      scene.gravity_m_s2 = 9.81;
      scene.bed.motion = motion;
      scene.ball_ball = pair;
      all.push_back(scene);
    }
  }
  return all;
}

/// Endless cloth with spin.
inline physics::Scene carpet(const physics::BallBallModel& pair) {
  physics::Scene scene = cloth();
  scene.bed.motion = physics::Spinning{};
  scene.ball_ball = pair;
  return scene;
}

/// The full model with jawed pockets.
inline physics::Scene full_table() {
  physics::Scene scene = table(physics::Spinning{}, physics::Han2005{}, physics::BallFriction{});
  scene.pockets = physics::JawedPockets{};
  return scene;
}

/// A ball that rolls, where the scene has spin.
inline physics::Ball moving(const physics::Scene& scene, std::uint32_t id, physics::Vec2 position,
                            physics::Vec2 velocity) {
  physics::Ball rolls = ball(id, position, velocity);
  if (std::holds_alternative<physics::Spinning>(scene.bed.motion)) {
    const double radius = scene.ball.radius_m;
    rolls.spin = {-velocity.y / radius, velocity.x / radius, 0};
  }
  return rolls;
}

/// To rest, or without friction to a horizon.
inline physics::Limits limits_for(const physics::Scene& scene, double horizon_s) {
  physics::Limits limits;
  if (!has_friction(scene)) limits.horizon_s = horizon_s;
  return limits;
}

inline physics::BallState state_of(const physics::Shot& shot, std::uint32_t id, double time_s) {
  return physics::Timeline(shot).state(physics::BallId{id}, time_s);
}
inline physics::BallState state_of(const physics::Shot& shot, std::uint32_t id) {
  return state_of(shot, id, shot.end_s);
}

/// The fastest that any ball of the scene was given, m/s.
inline double top_speed_of(const physics::Shot& shot) {
  double squares = 1;
  for (const physics::Segment& s : shot.segments) {
    if (s.start_s == 0) squares += dot(s.velocity, s.velocity);
  }
  return std::sqrt(squares);
}

/// Energy never rises and nothing overlaps, beyond what rounding explains; every number is one.
inline void expect_sound(const physics::Scene& scene, const physics::Shot& shot,
                         const std::string& where) {
  double coordinate = 2 * scene.ball.radius_m;
  for (const physics::Segment& s : shot.segments) {
    ASSERT_TRUE(std::isfinite(s.start_s) && std::isfinite(length(s.position)) &&
                std::isfinite(length(s.velocity)) && std::isfinite(dot(s.spin, s.spin)))
        << where;
    coordinate = std::max({coordinate, std::abs(s.position.x), std::abs(s.position.y)});
  }
  const physics::Audit found = physics::audit(scene, shot);
  EXPECT_LE(found.worst_rise_J, 2e-14 * found.energy_start_J) << where;
  EXPECT_LE(found.worst_penetration_m, 8 * physics::ulp(coordinate) +
                                           2 * top_speed_of(shot) * physics::ulp(shot.end_s) +
                                           physics::input_overlap_m / 10)
      << where;
}

/// The same for what may stall: an answer that names the balls, and all that had happened is sound.
inline bool expect_sound_if_stalled(const physics::Scene& scene, const physics::State& state,
                                    const physics::Strike& strike, const physics::Limits& limits,
                                    const std::string& where) {
  const auto outcome = physics::simulate(scene, state, strike, seed_of(4), limits);
  const auto* stalled = std::get_if<physics::Stalled>(&outcome);
  if (stalled != nullptr) {
    EXPECT_FALSE(stalled->balls.empty()) << where;
    expect_sound(scene, stalled->so_far, where);
    return true;
  }
  expect_sound(scene, std::get<physics::Shot>(outcome), where);
  return false;
}

/// How deep the centre of any ball ever came within its radius of a rail, looked at on `samples`
/// places of every stretch of its path: what the events do not know of shows here.
inline double deepest_in_rails(const physics::Scene& scene, const physics::Shot& shot,
                               int samples) {
  const physics::Rails rails = physics::rails_of(scene);
  const physics::Timeline timeline(shot);
  double deepest = 0;
  const auto look = [&](physics::Vec2 place) {
    for (const physics::RailSegment& rail : rails.segments) {
      const physics::Vec2 along = rail.nose.to - rail.nose.from;
      const double share =
          std::clamp(dot(place - rail.nose.from, along) / dot(along, along), 0.0, 1.0);
      deepest =
          std::max(deepest, scene.ball.radius_m - length(place - rail.nose.from - along * share));
    }
    for (const physics::RailArc& rail : rails.arcs) {
      deepest = std::max(
          deepest, scene.ball.radius_m + rail.nose.radius_m - length(place - rail.nose.centre));
    }
  };
  for (const physics::BallId id : timeline.balls()) {
    const auto& path = timeline.path(id);
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (path[i].phase == physics::Phase::pocketed) continue;
      const double end = i + 1 < path.size() ? path[i + 1].start_s : shot.end_s;
      for (int k = 0; k <= samples; ++k) {
        look(position_at(path[i], path[i].start_s + (end - path[i].start_s) * k / samples));
      }
    }
  }
  return deepest;
}

}  // namespace breakshot::support
