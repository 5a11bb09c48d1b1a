// How good a table looks to the player who is about to shoot at it, by geometry alone: what a shot
// is worth depends on what it leaves.
#pragma once

#include <vector>

#include "client_cli/bot/position.hpp"

namespace breakshot::bot {

/// A way to pocket a ball directly: nothing is in the way of either ball.
struct Pot {
  BallId ball{};
  PocketId pocket{};
  Vec2 target;      ///< the middle of the pocket's gate, m
  double ease = 0;  ///< (0, 1): how much error of the cue's direction it forgives
};

/// Every direct pot of the position, the easiest first.
std::vector<Pot> pots_of(const Position& position);

/// The same for a cue ball in hand: for every target ball and pocket that it can be sent to.
std::vector<Pot> lanes_of(const Position& position);

/// What the position is worth to the player at turn: from -1, about to lose, to 1, about to win.
double prospect_of(const Position& position);

}  // namespace breakshot::bot
