// The bot at a seat of a match on a server.
#pragma once

#include <cstdint>
#include <optional>

#include "client_cli/bot/decide.hpp"
#include "client_cli/online/player.hpp"

namespace breakshot::client {

struct BotPlan {
  bot::Effort effort;
  std::optional<std::uint32_t> most_shots;  ///< concedes at its turn once the match has had so many
};

/// Plays until the match is over.
void play_as_bot(Player& player, const BotPlan& plan);

}  // namespace breakshot::client
