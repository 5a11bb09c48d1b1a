// What is worth a line in the log, as values. No secret, token or invite code is ever in a note.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "common/match/match.hpp"

namespace breakshot::hub {

/// Given by the caller of the hub, never used twice while the server runs.
enum class ConnectionId : std::uint64_t {};

struct GuestCame {
  ConnectionId connection{};
  std::string name;
  bool is_new = false;
};
struct MatchOpened {
  match::MatchId match{};
};
struct MatchStarted {
  match::MatchId match{};
};
struct MatchFinished {
  match::MatchId match{};
  std::optional<match::Seat> winner;
  match::MatchEnd end{};
};
/// Discarded before it started: it expired, or everyone has left.
struct MatchDiscarded {
  match::MatchId match{};
};
struct MatchRestored {
  match::MatchId match{};
  match::Seq next{};
};
/// A match that the store has and that cannot go on. It stays in the store as it is.
struct MatchSetAside {
  match::MatchId match{};
  std::string why;
};
struct StoreRefused {
  std::string why;
};

using Note = std::variant<GuestCame, MatchOpened, MatchStarted, MatchFinished, MatchDiscarded,
                          MatchRestored, MatchSetAside, StoreRefused>;

/// Whether someone who runs the server should look at it.
bool is_alarming(const Note& note);
/// One line, without a full stop.
std::string sentence_of(const Note& note);

}  // namespace breakshot::hub
