// The limits of what a record may hold, in one place. The decoder refuses what is beyond them
// before it allocates anything; the encoder keeps to the same ones.
#pragma once

#include <cstddef>

#include "common/match/match.hpp"
#include "common/physics/simulate.hpp"

namespace breakshot::record {

inline constexpr std::size_t max_text_bytes = 256;  ///< a name of a player or a scene
inline constexpr std::size_t max_cushions = 4096;   ///< free segments of one scene
inline constexpr std::size_t max_balls = 4096;      ///< on one table
inline constexpr std::size_t max_events = physics::max_match_events;
/// One a ball at the start, then at most one a ball of each event.
inline constexpr std::size_t max_segments = max_balls + 2 * max_events;
inline constexpr std::size_t max_seats = match::max_practice_seats;
inline constexpr std::size_t max_fouls = 16;    ///< in one ruling
inline constexpr std::size_t max_options = 16;  ///< offered at once

}  // namespace breakshot::record
