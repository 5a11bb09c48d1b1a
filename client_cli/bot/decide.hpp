// What the bot does when it is its turn: the candidate that did best in its own trials. Bounded by
// counts, never by a clock, so that the same position and seed give the same decision anywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "client_cli/bot/position.hpp"

namespace breakshot::bot {

/// How unsteadily the bot strikes. It knows its own hand, and prefers shots that forgive.
struct Hand {
  /// Greatest error of the direction, rad, and of the speed, as a share of it. Errors are drawn
  /// from a triangle-like distribution: those near the greatest are rare.
  double direction_rad = 0;
  double speed_share = 0;
};

/// How hard to think, and with which luck: the bot does not know the seed of the match, so it tries
/// its shots with seeds of its own.
struct Effort {
  physics::Seed seed{};
  std::uint32_t turn = 0;  ///< makes the luck of each decision another; below 2^20
  std::size_t candidates = 400;
  std::size_t finalists = 6;  ///< candidates that are tried again with further seeds
  std::size_t samples = 8;    ///< trials of each finalist, at most 1000
  Hand hand;
  /// Leaves out this many of the best shots: those that were tried and could not be played.
  std::size_t skip = 0;
};

struct Decision {
  std::optional<match::Place> place;  ///< to be done before the shot
  std::variant<match::Shoot, match::Choose, match::Concede> act;
};

/// The position must have options or a cue ball. In practice with no ball left to play the bot
/// concedes, which ends the match.
Decision decide(const Position& position, const Effort& effort);

}  // namespace breakshot::bot
