// Events to the state of every ball at any time: all that drawing needs. No simulation happens
// here; a state is a pure function of the shot and of t.
#pragma once

#include <cstddef>
#include <vector>

#include "common/physics/event.hpp"

namespace breakshot::physics {

/// Where a ball is at an instant.
struct BallState {
  BallId id{};
  Phase phase = Phase::rest;
  Vec2 position;  ///< m; for a pocketed ball, where it dropped
  Vec2 velocity;  ///< m/s
  Vec3 spin{};    ///< rad/s

  friend bool operator==(const BallState&, const BallState&) = default;
};

/// The motion of every ball through one shot. Keeps its own index into the shot's segments.
class Timeline {
 public:
  explicit Timeline(const Shot& shot);

  /// Every ball of the shot, ascending.
  const std::vector<BallId>& balls() const { return balls_; }
  /// The last instant of the shot, s.
  double end_s() const { return end_s_; }

  /// The state of one ball at `time_s`, held at the first or last instant outside [0, end_s()].
  /// At the instant of an event the state is the one after it. `ball` must be one of balls().
  BallState state(BallId ball, double time_s) const;
  /// All balls, ascending.
  std::vector<BallState> states(double time_s) const;
  /// The segments of one ball in order of time: its path.
  const std::vector<Segment>& path(BallId ball) const;

 private:
  std::size_t index_of(BallId ball) const;

  std::vector<BallId> balls_;
  std::vector<std::vector<Segment>> paths_;
  double end_s_ = 0;
};

/// The balls left on the table at the end of a shot, at rest where they stopped: the state before
/// the next shot.
State state_after(const Shot& shot);

}  // namespace breakshot::physics
