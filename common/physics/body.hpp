// A ball as it is at the instant of a contact: what contacts act on.
#pragma once

#include <cstdint>

#include "common/physics/laws.hpp"

namespace breakshot::physics {

template <class Real>
struct Body : Moving<Real> {
  BallId id{};
  std::uint32_t collisions = 0;  ///< of this shot so far: the counter of its random stream
  bool present = true;           ///< on the table
  std::uint64_t instant = 0;     ///< for which the rest was last read from the path
  std::uint64_t touched = 0;     ///< the last instant that changed the ball
  BasicVec2<Real> position;

  Moving<Real>& moving() { return *this; }
  const Moving<Real>& moving() const { return *this; }
};

}  // namespace breakshot::physics
