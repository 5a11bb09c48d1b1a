// A ball as it is at the instant of a contact: what contacts act on.
#pragma once

#include <cstdint>

#include "common/physics/laws.hpp"

namespace breakshot::physics {

template <class Real>
struct Body : Moving<Real> {
  BallId id{};
  std::uint32_t ball = 0;        ///< its number, in the order of ids
  std::uint32_t collisions = 0;  ///< of this shot so far: the counter of its random stream
  bool present = true;           ///< on the table
  bool touched = false;          ///< whether the instant changed the ball
  BasicVec2<Real> position;

  Moving<Real>& moving() { return *this; }
  const Moving<Real>& moving() const { return *this; }
};

}  // namespace breakshot::physics
