#include "common/match/permission.hpp"

#include <type_traits>

namespace breakshot::match {
namespace {

using rules::GameStatus;

template <class C>
constexpr bool is_the_servers = std::is_same_v<C, Start> || std::is_same_v<C, Abandoned>;

/// Commands that belong to the player at the table; the others may come from any seat.
template <class C>
constexpr bool needs_the_turn =
    std::is_same_v<C, Place> || std::is_same_v<C, Shoot> || std::is_same_v<C, Choose>;

std::string shown(Seat seat) {
  return "seat " + std::to_string(number(seat));
}

/// Whether the author is one who may ever ask this.
template <class C>
std::optional<Refusal> wrong_author(const Match& match, const Author& author) {
  if constexpr (is_the_servers<C>) {
    if (!author.seat) return std::nullopt;
    return Refusal{RefusalCode::not_allowed_now, "only the server starts or ends a match so"};
  } else {
    if (!author.seat) {
      return Refusal{RefusalCode::not_your_turn, "the server has no seat; a seat must ask this"};
    }
    if (!sits(match, *author.seat)) {
      return Refusal{RefusalCode::not_your_turn, shown(*author.seat) + " does not play here"};
    }
    const Seat turn = match.status.game.turn;
    if (needs_the_turn<C> && match.status.stage == Stage::running && *author.seat != turn) {
      return Refusal{RefusalCode::not_your_turn, "it is the turn of " + shown(turn)};
    }
    return std::nullopt;
  }
}

std::optional<Refusal> not_now(std::string what) {
  return Refusal{RefusalCode::not_allowed_now, std::move(what)};
}

std::optional<Refusal> not_now(const Match&, const Place&, const GameStatus& game) {
  if (!game.options.empty()) return not_now("a choice is open; choose before placing");
  if (game.ball_in_hand == rules::BallInHand::none) {
    return not_now("the cue ball is not in hand; shoot from where it lies");
  }
  return std::nullopt;
}

std::optional<Refusal> not_now(const Match&, const Shoot&, const GameStatus& game) {
  if (!game.options.empty()) return not_now("a choice is open; choose before shooting");
  return std::nullopt;
}

std::optional<Refusal> not_now(const Match&, const Choose&, const GameStatus& game) {
  if (game.options.empty()) return not_now("no choice is open; shoot");
  return std::nullopt;
}

std::optional<Refusal> not_now(const Match& match, const AgreeRerack&, Seat seat) {
  if (match.status.rerack_agreed[number(seat)]) {
    return not_now(shown(seat) + " has already agreed; it lasts until the next shot");
  }
  if (match.settings.game == GameKind::eight_ball && match.status.game.breaking) {
    return not_now("the rack has not been broken yet; there is nothing to rack again");
  }
  return std::nullopt;
}

/// Whether the moment is right for a command whose author may ask it.
template <class C>
std::optional<Refusal> wrong_moment(const Match& match, const Author& author, const C& command) {
  const bool gathering = match.status.stage == Stage::gathering;
  if constexpr (std::is_same_v<C, Start>) {
    if (gathering) return std::nullopt;
    return not_now("the match has already started");
  } else {
    if (gathering) return not_now("the match has not started; wait for every seat");
    if constexpr (std::is_same_v<C, AgreeRerack>) {
      return not_now(match, command, *author.seat);
    } else if constexpr (needs_the_turn<C>) {
      return not_now(match, command, match.status.game);
    } else {
      return std::nullopt;
    }
  }
}

}  // namespace

bool sits(const Match& match, Seat seat) {
  if (number(seat) >= match.settings.seats) return false;
  const auto* practice = std::get_if<rules::Practice>(&match.game);
  return practice == nullptr || !practice->left[number(seat)];
}

std::optional<Refusal> not_permitted(const Match& match, const Ask& ask) {
  if (match.status.stage == Stage::finished) {
    return Refusal{RefusalCode::finished, "the match is over"};
  }
  if (ask.expected != match.next) {
    return Refusal{RefusalCode::wrong_sequence,
                   "expected entry " + std::to_string(static_cast<std::uint32_t>(ask.expected)) +
                       ", but the next is " +
                       std::to_string(static_cast<std::uint32_t>(match.next)) + "; look again"};
  }
  return std::visit(
      [&](const auto& command) -> std::optional<Refusal> {
        using C = std::decay_t<decltype(command)>;
        if (auto refusal = wrong_author<C>(match, ask.author)) return refusal;
        return wrong_moment(match, ask.author, command);
      },
      ask.command);
}

}  // namespace breakshot::match
