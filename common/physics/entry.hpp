// What the cell calendar keeps of each ball beside its course.
#pragma once

#include <bit>
#include <cstdint>

#include "common/physics/appointment.hpp"
#include "common/physics/cells.hpp"
#include "common/physics/courses.hpp"

namespace breakshot::physics {

/// A meeting has one turn in the heap, that of the ball that `calls` the other, which `waits` for
/// it and is in the heap for its crossings alone: of two turns one would be for nothing. Until it
/// is scheduled again it keeps the time it had there: its crossing, or later than the meeting.
enum class Turn : std::uint8_t { own, calls, waits };

/// The next event of a ball, but for its time, the next crossing, and what of its path is neither
/// course nor spin. One cache line for a double.
template <class Real>
struct alignas(std::bit_ceil(8 * sizeof(Real))) Entry {
  Real crossing_s = never<Real>;
  Real end_s = never<Real>;  ///< of the phase
  Real speed{};              ///< at the start of the path, m/s
  Place place;
  std::uint32_t with = 0;
  std::uint32_t paths_of_other = 0;  ///< of `with`, when the appointment was made
  std::uint32_t paths = 0;           ///< how many the ball has had
  BallId id{};
  Due due = Due::nothing;
  Side side = Side::right;
  Turn turn = Turn::own;
  Phase phase = Phase::rest;
  bool curved = false;  ///< as Path has it

  /// Another path.
  void set(const Path<Real>& path) {
    end_s = path.end_s;
    speed = path.speed;
    ++paths;
    id = path.segment.ball;
    phase = path.segment.phase;
    curved = path.curved;
  }
};

static_assert(sizeof(Entry<double>) == 64 && sizeof(Course<double>) == 64);

/// Whether a ball leaves its cell before anything else happens to it.
template <class Real>
bool crosses(const Entry<Real>& entry, const Course<Real>& course) {
  return entry.crossing_s <= course.until_s;
}

}  // namespace breakshot::physics
