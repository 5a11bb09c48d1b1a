// A ball as it is at one instant: what contacts act on and what predictions start from.
#pragma once

#include <cstdint>

#include "common/physics/laws.hpp"

namespace breakshot::physics {

template <class Real>
struct Body {
  BallId id{};
  std::uint32_t collisions = 0;  ///< of this shot so far: the counter of its random stream
  bool present = true;           ///< on the table
  bool rests = true;
  BasicVec2<Real> position;
  BasicVec2<Real> velocity;
  BasicVec2<Real> acceleration;

  /// Moves the body to where its path is at `time_s`.
  void follow(const Path<Real>& path, Real time_s) {
    const BasicSegment<Real>& s = path.segment;
    rests = s.phase == Phase::rest || s.phase == Phase::pocketed;
    position = position_at(s, time_s);
    velocity = velocity_at(s, time_s);
    acceleration = s.acceleration;
  }
};

}  // namespace breakshot::physics
