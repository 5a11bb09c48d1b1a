// Practice: one seat or more, no fouls, balls placed freely.
#pragma once

#include "common/physics/event.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::rules {

struct Practice {
  GameStatus status;

  friend bool operator==(const Practice&, const Practice&) = default;
};

struct PracticeAfter {
  Practice game;
  Ruling ruling;
  physics::State table;  ///< with a pocketed cue ball put back on the head spot or beside it
};

Practice practice_start(std::size_t seats);

/// The turn goes round; pocketed object balls stay down.
PracticeAfter judge(const Practice& game, const physics::Scene& scene, const physics::State& before,
                    const physics::Shot& shot);

}  // namespace breakshot::rules
