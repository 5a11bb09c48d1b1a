// Which balls are whose, and which of them the shooter is at.
#pragma once

#include <vector>

#include "common/physics/ball.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::rules {

/// The two seats of 8-ball.
constexpr Seat other(Seat seat) {
  return Seat{static_cast<std::uint8_t>(1 - number(seat))};
}

/// Solids are 1 to 7, stripes 9 to 15; the cue ball and the 8 belong to neither.
Group group_of(physics::BallId ball);

/// Solids for stripes and the reverse.
Group opposite(Group group);

/// The ball of that id on the table, or null when it is pocketed.
const physics::Ball* find(const physics::State& table, physics::BallId ball);

/// The balls that the player at the table is at, ascending: those that may be called, and one of
/// which must be hit first. His group, or the 8 once it is cleared; both groups on an open table,
/// or the 8 if nothing else is left; before a break, all.
std::vector<physics::BallId> targets(const GameStatus& status, const physics::State& table);

}  // namespace breakshot::rules
