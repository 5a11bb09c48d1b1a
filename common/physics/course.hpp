// A ball's path as its neighbours look at it, time and again: where it is, how it moves, and until
// when. One cache line for a double.
#pragma once

#include <bit>

#include "common/physics/detect.hpp"

namespace breakshot::physics {

template <class Real>
struct alignas(std::bit_ceil(8 * sizeof(Real))) Course {
  Real start_s{};
  BasicVec2<Real> position;
  BasicVec2<Real> velocity;
  BasicVec2<Real> acceleration;
  Real until_s = never<Real>;  ///< of the ball's next event, as far as is known
};

template <class Real>
BasicVec2<Real> position_at(const Course<Real>& m, Real time_s) {
  const Real dt = time_s - m.start_s;
  return {m.position.x + (m.velocity.x + m.acceleration.x * (dt / 2)) * dt,
          m.position.y + (m.velocity.y + m.acceleration.y * (dt / 2)) * dt};
}

template <class Real>
BasicVec2<Real> velocity_at(const Course<Real>& m, Real time_s) {
  const Real dt = time_s - m.start_s;
  return {m.velocity.x + m.acceleration.x * dt, m.velocity.y + m.acceleration.y * dt};
}

/// The path of a ball that never slows down, as contact_time() asks for it: its course says all.
template <class Real>
struct EvenMover {
  const Course<Real>& segment;
  Real speed;
  Real end_s = never<Real>;
  bool curved = false;
};

template <class Real>
EvenMover<Real> even_mover(const Course<Real>& course) {
  return {course, length(course.velocity)};
}

template <class Real>
bool stays(const EvenMover<Real>& mover) {
  return mover.speed == 0;
}

}  // namespace breakshot::physics
