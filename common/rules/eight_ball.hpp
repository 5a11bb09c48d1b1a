// 8-ball by the WPA's World Standardized Rules. See docs/rules.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "common/physics/perturbation.hpp"
#include "common/rules/facts.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::rules {

/// One rack of 8-ball between shots.
struct EightBall {
  Seat breaker{};  ///< who breaks this rack
  GameStatus status;

  friend bool operator==(const EightBall&, const EightBall&) = default;
};

/// The position before a break: cue ball on the head spot, the 8 in the middle, one ball of each
/// group at the back corners, the rest drawn from the rack stream. `rack` counts racks of the
/// match.
physics::State rack_eight_ball(const physics::Scene& scene, const physics::Seed& seed,
                               std::uint32_t rack);

/// A rack about to be broken by `breaker`.
EightBall eight_ball_start(Seat breaker);

/// What a shot or a choice led to.
struct EightBallAfter {
  EightBall game;
  Ruling ruling;
  physics::State table;  ///< spotted balls and a pocketed cue ball put back
  bool rerack = false;   ///< the balls are to be racked again, broken by game.breaker
};

/// Judges a shot. `before` is the table before it. The call must be free of faults (`call_fault`).
EightBallAfter judge(const EightBall& game, const physics::Scene& scene,
                     const physics::State& before, const physics::Shot& shot, const Call& call);

/// What is wrong with a call at this moment of the game, or nothing.
std::optional<std::string> call_fault(const EightBall& game, const physics::State& table,
                                      const Call& call);

/// Carries out a choice, which must be one of game.status.options.
EightBallAfter choose(const EightBall& game, const physics::Scene& scene,
                      const physics::State& table, Option option);

}  // namespace breakshot::rules
