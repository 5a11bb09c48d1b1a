// What the server decides: a pure state machine. It is told what happened and answers what is to be
// done; sockets, the store, the clock and chance are its caller's.
//
// Store before announce: a change is first given out as Append; only when its ticket comes back as
// Stored does the match advance and is anyone told. So nobody ever sees what can be lost. The
// changes of one match are stored one at a time; requests to change it meanwhile wait their turn.
//
// The same inputs give the same outputs in the same order: nothing here reads a clock, an address
// or an unordered container.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "common/lobby/lobby.hpp"
#include "server/hub/limits.hpp"
#include "server/hub/note.hpp"
#include "server/ledger/ledger.hpp"

namespace breakshot::hub {

/// The time of an input, read by the caller.
struct Now {
  /// Of a clock that never goes back nor jumps: for how long something has lasted.
  std::chrono::milliseconds steady{};
  /// Milliseconds since 1970-01-01 UTC: for dates that are stored.
  std::int64_t unix_ms = 0;
};

// ---- Inputs

/// Fresh bytes of a cryptographic generator: ids, tokens, invite codes and secrets come from them.
using Entropy = std::array<std::uint8_t, 64>;

struct Opened {
  ConnectionId connection{};
};
struct Asked {
  ConnectionId connection{};
  lobby::Asked asked;
  Entropy entropy{};  ///< fresh for every request
};
/// The answer to ReportDrained.
struct Drained {
  ConnectionId connection{};
};
/// The connection is gone, whoever closed it. What the hub still says to it is dropped.
struct Closed {
  ConnectionId connection{};
};
/// Time has passed. Give one at least every few seconds.
struct Tick {};
/// The server is to stop: no new request is carried out, what is being stored is waited for, then
/// all connections are told Goodbye and closed, and Stopped is the last output.
struct Stopping {};

/// `ledger::Restored` comes at start-up, once for each match of the store, before all else.
using Input =
    std::variant<Opened, Asked, Drained, Closed, ledger::Report, ledger::Restored, Tick, Stopping>;

// ---- Outputs, to be carried out in their order

/// Say this on these connections. One value for all of them, to be encoded once.
struct Tell {
  std::vector<ConnectionId> to;
  std::shared_ptr<const lobby::Told> told;
};
/// Give Drained once everything told to the connection so far has been written to its socket: the
/// next part of a long answer waits for it. Not needed if it is closed before.
struct ReportDrained {
  ConnectionId connection{};
};
/// Close the connection when what was told to it has been written, or at the latest after a
/// deadline of the caller's. Give Closed then, as always.
struct Close {
  ConnectionId connection{};
};
/// What a connection is trusted with: frame sizes, deadlines, bytes that may wait to be sent.
enum class Standing : std::uint8_t {
  stranger,  ///< has not said a good Hello; every connection begins so
  guest,
  player,  ///< follows a match that has not finished and at which it sits
};
struct Treat {
  ConnectionId connection{};
  Standing as{};
};
/// Store this, all or nothing, after all that was appended before, and report the ticket.
struct Append {
  ledger::Ticket ticket{};
  ledger::Batch batch;
};
/// Answer this from the store, which shows at least all that has been reported as Stored, and
/// report the ticket.
struct Load {
  ledger::Ticket ticket{};
  ledger::Query query;
};
/// Everything is stored and said: the server can end.
struct Stopped {};

using Output = std::variant<Tell, ReportDrained, Close, Treat, Append, Load, Note, Stopped>;
using Outputs = std::vector<Output>;

struct State;

class Hub {
 public:
  /// `version` is what Welcome tells people about the server.
  explicit Hub(std::string version, const Limits& limits = {});
  ~Hub();
  Hub(Hub&&) noexcept;
  Hub& operator=(Hub&&) noexcept;

  Outputs step(Input input, Now now);

 private:
  std::unique_ptr<State> state_;
};

}  // namespace breakshot::hub
