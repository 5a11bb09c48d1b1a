// What the bot sees when it is its turn, and which balls it may play.
#pragma once

#include <vector>

#include "client_cli/bot/aim.hpp"
#include "common/match/match.hpp"

namespace breakshot::bot {

/// A table at rest with `status.turn` to shoot or to choose: all of it is public.
struct Position {
  match::GameKind game = match::GameKind::eight_ball;
  physics::Scene scene;
  physics::State table;
  rules::GameStatus status;
};

/// The balls that the player at turn may hit first, ascending; in practice all.
std::vector<BallId> targets_of(const Position& position);

/// How many balls the player of a seat has still to pocket, the 8 included; on an open table the
/// smaller of the two groups counts.
std::size_t balls_left(const Position& position, rules::Seat seat);

/// Whether the cue ball, in hand, may be put there.
bool can_place(const Position& position, Vec2 place);

}  // namespace breakshot::bot
