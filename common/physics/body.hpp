// A ball as it is at the instant of a contact: what contacts act on.
#pragma once

#include <cstdint>

#include "common/physics/laws.hpp"

namespace breakshot::physics {

template <class Real>
struct Body {
  BallId id{};
  std::uint32_t collisions = 0;  ///< of this shot so far: the counter of its random stream
  bool present = true;           ///< on the table
  std::uint64_t instant = 0;     ///< for which position and velocity were last read from the path
  BasicVec2<Real> position;
  BasicVec2<Real> velocity;
};

}  // namespace breakshot::physics
