// Balls: their identity, their kind and their state at an instant.
#pragma once

#include <cstdint>
#include <vector>

#include "common/physics/vec.hpp"

namespace breakshot::physics {

/// Names a ball within a scene; any number. In 8-ball 0 is the cue ball and 1 to 15 the object
/// balls.
enum class BallId : std::uint32_t {};
/// Index of a cushion: segments first, in the order of the scene.
enum class CushionId : std::uint32_t {};
/// Index of a pocket: 0 head-right, 1 side-right, 2 foot-right, 3 foot-left, 4 side-left, 5
/// head-left.
enum class PocketId : std::uint8_t {};

constexpr std::uint32_t number(BallId id) {
  return static_cast<std::uint32_t>(id);
}
constexpr std::uint32_t number(CushionId id) {
  return static_cast<std::uint32_t>(id);
}
constexpr std::uint32_t number(PocketId id) {
  return static_cast<std::uint32_t>(id);
}

/// What all balls of a scene share. The defaults are the WPA's ball: 2.25 in across, 5.5 oz.
struct BallKind {
  double radius_m = 0.028575;  ///< [1e-4, 10]
  double mass_kg = 0.155922;   ///< [1e-6, 1e6]

  friend bool operator==(const BallKind&, const BallKind&) = default;
};

/// The motion a ball is in. The order is that of the record and must not change.
enum class Phase : std::uint8_t { rest, slide, roll, spin, pocketed };

/// Whether the ball stays where it is, whatever time passes.
constexpr bool is_still(Phase phase) {
  return phase != Phase::slide && phase != Phase::roll;
}

/// A ball before a shot: where its centre is, and how it moves (usually not at all).
struct Ball {
  BallId id{};
  Vec2 position;  ///< m
  Vec2 velocity;  ///< m/s
  Vec3 spin;      ///< rad/s; zero for motions without spin

  friend bool operator==(const Ball&, const Ball&) = default;
};

/// The balls on the table before a shot, in any order; those that come out of a shot are in
/// ascending order of id. Pocketed balls are not in it.
struct State {
  std::vector<Ball> balls;

  friend bool operator==(const State&, const State&) = default;
};

}  // namespace breakshot::physics
