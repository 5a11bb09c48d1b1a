// Practice: one seat or more, no fouls, no calls, balls placed freely.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/physics/event.hpp"
#include "common/physics/perturbation.hpp"
#include "common/physics/scene.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::rules {

struct Practice {
  GameStatus status;
  std::vector<bool> left;  ///< by seat: those who have left are passed over

  friend bool operator==(const Practice&, const Practice&) = default;
};

struct PracticeAfter {
  Practice game;
  Ruling ruling;
  physics::State table;  ///< with a pocketed cue ball put back on the head spot or beside it
};

Practice practice_start(std::size_t seats);

/// What is wrong with a call: practice asks for none.
std::optional<std::string> call_fault(const Practice& game, const Call& call);

/// `seat` leaves: the turn, if it was theirs, goes on to the next who stays.
Practice without(const Practice& game, Seat seat);

/// The turn goes round; pocketed object balls stay down.
PracticeAfter judge(const Practice& game, const physics::Scene& scene, const physics::Shot& shot);

}  // namespace breakshot::rules
