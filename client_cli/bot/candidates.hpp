// The shots that are worth a try in a position.
#pragma once

#include <optional>
#include <vector>

#include "client_cli/bot/position.hpp"

namespace breakshot::bot {

struct Candidate {
  std::optional<Vec2> place;  ///< with the ball in hand: where the cue ball is put first, m
  Vec2 direction;             ///< unit
  double speed_m_s = 0;
  rules::Call intended;  ///< what the shot is meant to do
};

/// The most promising first: breaks; direct pots; banks; kicks; thin and thick hits that leave the
/// opponent little; and a fan in all directions, so that there is always one. At most `count`,
/// which is at least 1.
std::vector<Candidate> candidates_of(const Position& position, std::size_t count);

}  // namespace breakshot::bot
