// What a shot is worth: tried in the bot's own copy of the physics and judged by the rules.
#pragma once

#include <optional>

#include "client_cli/bot/candidates.hpp"
#include "client_cli/bot/position.hpp"
#include "common/physics/event.hpp"

namespace breakshot::bot {

/// A candidate played once.
struct Trial {
  rules::Call call;  ///< what was called for it
  double value = 0;  ///< to the shooter: -1 is a lost rack, 1 a won one
};

/// Plays a candidate with the given seed. Without a `call`, the one that suits what happened is
/// made: the intended ball, else another of the shooter's that dropped, else a safety. Nothing if
/// the physics stalls.
std::optional<Trial> try_out(const Position& position, const Candidate& candidate,
                             const std::optional<rules::Call>& call, const physics::ShotSeed& seed);

/// What an option that the player at turn may choose is worth to it.
double value_of(const Position& position, rules::Option option);

/// Whether a shot can come out differently with another seed.
bool is_chancy(const physics::Scene& scene);

}  // namespace breakshot::bot
