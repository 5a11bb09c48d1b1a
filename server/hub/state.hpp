// All that the hub knows between two steps. A value without behaviour: the files beside this one
// each know one part of what is done with it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "server/hub/hub.hpp"

namespace breakshot::hub {

using Milliseconds = std::chrono::milliseconds;

/// A request that waits for its answer: every one is answered exactly once.
struct Asker {
  ConnectionId connection{};
  lobby::RequestId request{};
};

// ---- Readers: those who are told a match's entries in order

enum class ReaderId : std::uint64_t {};

/// Each reader has a place of its own in the entries of a match, so that it is told each one
/// exactly once, whether from memory, from the store or live.
struct Reader {
  ConnectionId connection{};
  match::MatchId match{};
  match::Seq next{};  ///< the first entry that it has not been told
  /// Where it ends: of a fetch, or when the match is finished. Missing: it goes on live.
  std::optional<match::Seq> end;
  std::optional<Asker> fetch;  ///< a fetch's request, answered at the end
  bool live = false;           ///< has been told everything, and hears entries as they are stored
};

// ---- Connections

struct Connection {
  std::optional<ledger::Guest> guest;  ///< after Welcome
  bool greeting = false;               ///< a Hello is being answered
  bool closing = false;                ///< has been told Goodbye; only Closed matters now
  std::size_t pending = 0;             ///< requests not answered yet
  std::size_t wrong_codes = 0;
  Standing standing = Standing::stranger;
  std::map<match::MatchId, ReaderId> follows;
  std::set<ReaderId> fetches;
  std::size_t joining = 0;  ///< follows to come once a seat is stored
  /// The readers that are behind, served one batch at a time in turn.
  std::deque<ReaderId> behind;
  bool serving = false;  ///< a batch of the first one is being loaded or written
};

// ---- Matches

/// A request that waits until the change of its match that is under way is stored.
struct Waiting {
  Asker asker;
  lobby::Request request;
};

/// The request that opened a match, where it had a key: asked again it leads to the same match.
/// Only in memory: of a match whose creation was not answered before the server was started anew
/// nobody knows, and it expires as any that nobody joins.
struct Creation {
  ledger::GuestId guest;
  lobby::Create wish;
};

/// A match that is not finished.
struct LiveMatch {
  ledger::MatchRow row;
  match::Secret secret{};
  std::optional<Creation> creation;
  hash::Digest digest{};             ///< of the last entry, or of the header before the first
  std::optional<match::Match> game;  ///< once it has started
  std::deque<ledger::EntryPointer> recent;
  std::map<ConnectionId, ReaderId> followers;
  /// By seat: since when its player has been away; empty where present or where nobody sits.
  std::vector<std::optional<Milliseconds>> away_since;
  Milliseconds created{};  ///< on the steady clock
  bool changing = false;   ///< a change is being stored
  std::deque<Waiting> waiting;
};

// ---- What is being stored, by ticket

struct StoringGuest {
  Asker asker;
  ledger::Guest guest;
  std::optional<lobby::Token> token;  ///< a new guest's
};
struct StoringMatch {
  Asker asker;
  LiveMatch match;
  std::vector<Asker> again;  ///< the same Create, sent again meanwhile
};
/// An entry with the match that it leads to.
struct Played {
  ledger::EntryPointer entry;
  match::Match game;
};
/// The start of a match: its header and its first entry.
struct Begun {
  record::Header header;
  Played played;
};
struct StoringSeats {
  enum class Cause : std::uint8_t { join, contribute, leave } cause{};
  match::MatchId match{};
  Asker asker;
  ledger::Seats seats;
  std::optional<Begun> begun;  ///< the last contribution starts the match
};
struct StoringEntry {
  match::MatchId match{};
  std::optional<Asker> asker;  ///< missing: the server's own
  Played played;
};
struct StoringDiscard {
  match::MatchId match{};
  std::optional<Asker> asker;  ///< the last one to leave; missing: expired
  std::string why;
};

using Storing =
    std::variant<StoringGuest, StoringMatch, StoringSeats, StoringEntry, StoringDiscard>;

// ---- What is being loaded, by ticket

struct LoadingGuest {
  Asker asker;
  lobby::Hello hello;
};
/// The match of a request, which is not among the live ones that the asker may see.
struct LoadingMatch {
  Asker asker;
  lobby::Request request;
};
/// The entry that a command sent again may have become.
struct LoadingEntry {
  Asker asker;
  match::Seat seat{};
  lobby::Act act;
};
struct LoadingList {
  Asker asker;
};
struct LoadingBatch {
  ReaderId reader{};
  ConnectionId connection{};
};

using Loading = std::variant<LoadingGuest, LoadingMatch, LoadingEntry, LoadingList, LoadingBatch>;

// ---- Everything

struct State {
  std::string version;
  Limits limits;
  bool stopping = false;  ///< no new request is carried out
  bool stopped = false;   ///< Stopped was put out
  std::map<ConnectionId, Connection> connections;
  std::map<ledger::GuestId, ConnectionId> online;
  std::map<match::MatchId, LiveMatch> matches;
  std::map<std::string, match::MatchId> codes;  ///< of live private matches
  std::map<ReaderId, Reader> readers;
  std::map<ledger::Ticket, Storing> storing;
  std::map<ledger::Ticket, Loading> loading;
  std::uint64_t last_ticket = 0;
  std::uint64_t last_reader = 0;
};

}  // namespace breakshot::hub
