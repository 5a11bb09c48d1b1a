// Matches for tests: asks are made in a line, and a refusal where none is expected fails the test.
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "common/match/match.hpp"
#include "tests/support/shot_builder.hpp"

namespace breakshot::support {

inline match::Settings eight_ball_settings(std::uint32_t race_to = 1) {
  return {"club", club_scene(), match::GameKind::eight_ball, 2, race_to};
}
inline match::Settings practice_settings(std::uint8_t seats) {
  return {"club", club_scene(), match::GameKind::practice, seats, 1};
}

inline constexpr match::Author the_server{};
constexpr match::Author seat(std::uint8_t number) {
  return {match::Seat{number}};
}

/// Asks with the number that the match expects.
inline std::variant<match::Accepted, match::Refusal> ask(const match::Match& match,
                                                         match::Author author,
                                                         const match::Command& command) {
  return match::apply(match, {author, match.next, command});
}

/// The match after an ask that must be accepted; `match` itself if it is not.
inline match::Match after(const match::Match& match, match::Author author,
                          const match::Command& command) {
  auto result = ask(match, author, command);
  if (auto* refusal = std::get_if<match::Refusal>(&result)) {
    ADD_FAILURE() << "refused: " << refusal->what;
    return match;
  }
  return std::get<match::Accepted>(std::move(result)).next;
}

/// Why an ask that must be refused was.
inline match::Refusal refusal(const match::Match& match, match::Author author,
                              const match::Command& command) {
  const auto result = ask(match, author, command);
  if (const auto* refusal = std::get_if<match::Refusal>(&result)) return *refusal;
  ADD_FAILURE() << "accepted";
  return {};
}

inline match::Match started(const match::Settings& settings, const physics::Seed& seed = {}) {
  return after(match::created(settings, seed), the_server, match::Start{});
}

}  // namespace breakshot::support
