// Scenes and positions that physics tests start from.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <variant>

#include "common/physics/simulate.hpp"
#include "common/physics/table.hpp"
#include "common/physics/timeline.hpp"
#include "tests/support/chance.hpp"

namespace breakshot::support {

/// Endless cloth, no friction, elastic balls.
inline physics::Scene gas() {
  physics::Scene scene;
  scene.ball_ball = physics::Elastic{};
  return scene;
}

/// Endless cloth with friction and elastic balls.
inline physics::Scene cloth() {
  physics::Scene scene = gas();
  scene.gravity_m_s2 = 9.81;
  scene.bed.motion = physics::Straight{0.2, 0.01, 1.0};
  return scene;
}

/// An 8-foot table; friction as asked for.
inline physics::Scene table(physics::Motion motion, physics::CushionModel cushions,
                            physics::BallBallModel balls) {
  physics::Scene scene;
  scene.gravity_m_s2 = 9.81;
  scene.bed = {motion, physics::eight_foot_length_m, physics::eight_foot_width_m};
  scene.cushions = physics::RectangleCushions{cushions};
  scene.ball_ball = balls;
  return scene;
}

inline physics::Ball ball(std::uint32_t id, physics::Vec2 position, physics::Vec2 velocity = {}) {
  return {physics::BallId{id}, position, velocity, {}};
}

inline physics::State balls(std::initializer_list<physics::Ball> list) {
  return {list};
}

/// Cue ball on the head spot and a triangle of 15 with this gap.
inline physics::State racked(const physics::Scene& scene, double gap_m) {
  physics::State state{{ball(0, physics::head_spot(scene.bed))}};
  std::uint32_t id = 1;
  for (const physics::Vec2 place : physics::triangle_rack(scene.bed, scene.ball, gap_m)) {
    state.balls.push_back(ball(id++, place));
  }
  return state;
}

/// A shot that must come to its end.
inline physics::Shot shot_of(const physics::Scene& scene, const physics::State& state,
                             std::optional<physics::Strike> strike = std::nullopt,
                             const physics::ShotSeed& seed = {},
                             const physics::Limits& limits = {}) {
  EXPECT_TRUE(physics::faults_of(scene).empty());
  EXPECT_TRUE(physics::faults_of(scene, state).empty());
  auto outcome = physics::simulate(scene, state, strike, seed, limits);
  if (auto* shot = std::get_if<physics::Shot>(&outcome)) return std::move(*shot);
  ADD_FAILURE() << "stalled";
  return std::get<physics::Stalled>(std::move(outcome)).so_far;
}

inline physics::Limits until(double horizon_s) {
  physics::Limits limits;
  limits.horizon_s = horizon_s;
  return limits;
}

template <class Kind>
std::vector<Kind> all_of(const physics::Shot& shot) {
  std::vector<Kind> found;
  for (const physics::Event& event : shot.events) {
    if (const auto* kind = std::get_if<Kind>(&event)) found.push_back(*kind);
  }
  return found;
}

inline physics::ShotSeed seed_of(std::uint32_t number) {
  physics::ShotSeed seed;
  for (std::size_t i = 0; i < 4; ++i) seed.seed[i] = static_cast<std::uint8_t>(number >> 8 * i);
  return seed;
}

}  // namespace breakshot::support
