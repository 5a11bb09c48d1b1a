// Closed-form motion between two events: p(t) = p0 + v0 t + a t^2 / 2 with a constant acceleration.
// Spin changes evenly as well, but the part about the vertical axis stops at zero.
#pragma once

#include "common/physics/ball.hpp"
#include "common/physics/scene.hpp"

namespace breakshot::physics {

/// The motion of one ball from `start_s` until its next segment begins.
template <class Real>
struct BasicSegment {
  BallId ball{};
  Phase phase = Phase::rest;
  Real start_s{};
  BasicVec2<Real> position;       ///< at start, m
  BasicVec2<Real> velocity;       ///< at start, m/s
  BasicVec2<Real> acceleration;   ///< constant, m/s^2
  BasicVec3<Real> spin{};         ///< at start, rad/s; zero in motions without spin
  BasicVec3<Real> spin_change{};  ///< constant, rad/s^2; z is against spin.z

  friend bool operator==(const BasicSegment&, const BasicSegment&) = default;
};

using Segment = BasicSegment<double>;

/// Copies number by number what was written so a moment ago: a processor that reads more at once
/// waits until all of it has come to memory.
template <class Real>
void copy_in_parts(const BasicVec2<Real>& from, BasicVec2<Real>& to) {
  to.x = from.x;
  to.y = from.y;
}
template <class Real>
void copy_in_parts(const BasicVec3<Real>& from, BasicVec3<Real>& to) {
  to.x = from.x;
  to.y = from.y;
  to.z = from.z;
}
template <class Real>
void copy_in_parts(const BasicSegment<Real>& from, BasicSegment<Real>& to) {
  to.ball = from.ball;
  to.phase = from.phase;
  to.start_s = from.start_s;
  copy_in_parts(from.position, to.position);
  copy_in_parts(from.velocity, to.velocity);
  copy_in_parts(from.acceleration, to.acceleration);
  copy_in_parts(from.spin, to.spin);
  copy_in_parts(from.spin_change, to.spin_change);
}

template <class Real>
BasicVec2<Real> position_at(const BasicSegment<Real>& s, Real time_s) {
  const Real dt = time_s - s.start_s;
  return s.position + (s.velocity + s.acceleration * (dt / 2)) * dt;
}

template <class Real>
BasicVec2<Real> velocity_at(const BasicSegment<Real>& s, Real time_s) {
  return s.velocity + s.acceleration * (time_s - s.start_s);
}

template <class Real>
BasicVec3<Real> spin_at(const BasicSegment<Real>& s, Real time_s) {
  const Real dt = time_s - s.start_s;
  const Real z = s.spin.z + s.spin_change.z * dt;
  const bool over = (s.spin.z < 0) != (z < 0);
  return {s.spin.x + s.spin_change.x * dt, s.spin.y + s.spin_change.y * dt, over ? Real(0) : z};
}

}  // namespace breakshot::physics
