// What the cell calendar keeps of each ball beside its path.
#pragma once

#include <cstdint>

#include "common/physics/appointment.hpp"
#include "common/physics/cells.hpp"

namespace breakshot::physics {

/// A meeting has one turn in the heap, that of the ball that `calls` the other, which `waits` for
/// it and is in the heap for its crossings alone: of two turns one would be for nothing. Until it
/// is scheduled again it keeps the time it had there: its crossing, or later than the meeting.
enum class Turn : std::uint8_t { own, calls, waits };

/// The next event of a ball, but for its time, and the next crossing.
template <class Real>
struct Entry {
  Real crossing_s = never<Real>;
  std::uint32_t with = 0;
  std::uint32_t paths_of_other = 0;  ///< of `with`, when the appointment was made
  std::uint32_t paths = 0;           ///< how many the ball has had
  Due due = Due::nothing;
  Side side = Side::right;
  Turn turn = Turn::own;
};

}  // namespace breakshot::physics
