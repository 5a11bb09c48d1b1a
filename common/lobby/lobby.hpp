// What clients ask and are told, as values: the vocabulary that the wire says and the hub answers.
//
// Every request is answered exactly once: by the answer named at it, or by Refused. The answer
// carries the request's id; so do the pieces of a fetched record that come before FetchDone. What
// is told without having been asked for (news of followed matches, Goodbye) carries the id 0.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/hash/hash.hpp"
#include "common/match/match.hpp"
#include "common/record/record.hpp"

namespace breakshot::lobby {

inline constexpr std::uint32_t protocol_version = 2;
/// Where servers listen and clients look unless told otherwise: POOL on a telephone's keys.
inline constexpr std::uint16_t default_port = 7665;

/// A guest's identity: whoever shows it is that guest. The server keeps only its SHA-256.
using Token = std::array<std::uint8_t, 32>;
/// Lets its holder join, watch and fetch a private match: 10 characters of Crockford's base 32 in
/// upper case. Codes that people type are understood in lower case too, and with I, L and O.
using InviteCode = std::string;
/// Random bytes of a client's by which a Create that is sent again is known.
using CreationKey = std::array<std::uint8_t, 16>;

// Limits of what clients may say, in one place. What a name may be: common/lobby/name.hpp.
inline constexpr std::size_t max_preset_bytes = 64;
inline constexpr std::size_t invite_code_length = 10;

// ---- What clients ask

/// The first request on a connection; answered by Welcome. The connection that was a guest's before
/// is told Goodbye.
struct Hello {
  std::uint32_t version = protocol_version;
  std::string name;
  std::optional<Token> token;  ///< missing: a new guest

  friend bool operator==(const Hello&, const Hello&) = default;
};
/// Opens a match and takes seat 0; answered by MatchNews. The asker follows it from then on. The
/// same Create with the same key, sent again by the same guest since the answer was lost, is
/// answered with the match that it opened, as long as that is open or running, the server has not
/// been started anew and the guest has not given up the seat.
struct Create {
  std::string preset;  ///< a name out of physics::presets(); empty: the default
  match::GameKind game = match::GameKind::eight_ball;
  std::uint8_t seats = 2;
  std::uint32_t race_to = 1;
  bool is_private = false;
  std::optional<CreationKey> key;  ///< missing: each one opens another match

  friend bool operator==(const Create&, const Create&) = default;
};
// Join, Watch and Fetch name a match by id, or by the code of a private match; exactly one of the
// two is given, or both for the same match.

/// Takes a free seat, or comes back to one's own, and follows the match from entry `from` on like
/// Watch; answered by MatchNews. Coming back works at any stage.
struct Join {
  std::optional<match::MatchId> match;
  std::optional<InviteCode> code;
  match::Seq from{};

  friend bool operator==(const Join&, const Join&) = default;
};
/// Follows a match from entry `from` on; answered by MatchNews. Then come, each exactly once and in
/// order, the entries from `from` on: those up to `info.next` are the match so far, what follows is
/// live. Asking again starts again at the new `from`. A player present at the table is one whose
/// connection follows the match.
struct Watch {
  std::optional<match::MatchId> match;
  std::optional<InviteCode> code;
  match::Seq from{};

  friend bool operator==(const Watch&, const Watch&) = default;
};
enum class Filter : std::uint8_t { open, running, mine, finished };
/// A position in a listing: after this match. By value, since the match itself may be gone by now.
struct Position {
  std::int64_t created_unix_ms = 0;
  match::MatchId match{};

  friend bool operator==(const Position&, const Position&) = default;
};
/// Answered by Listing. Private matches appear only to those who sit at them. `open` matches have a
/// free seat or wait for contributions; `mine` are those of the asker's at any stage.
struct List {
  Filter filter = Filter::open;
  std::optional<Position> after;  ///< the last one of the page before

  friend bool operator==(const List&, const List&) = default;
};
/// A record as it stands: answered by MatchNews with the header, the entries from `from` on, and
/// FetchDone, all with the request's id. A match that has not started has no record yet.
struct Fetch {
  std::optional<match::MatchId> match;
  std::optional<InviteCode> code;
  match::Seq from{};

  friend bool operator==(const Fetch&, const Fetch&) = default;
};
/// A seated player's share of the seed; answered by Done. The match starts when every seat is taken
/// and has contributed. The same contribution may be sent again.
struct Contribute {
  match::MatchId match{};
  match::Contribution contribution{};

  friend bool operator==(const Contribute&, const Contribute&) = default;
};
/// A command of the asker's seat; answered by EntryNews with the entry that it became. To a
/// follower who awaits just this number the answer is the entry itself, and it is not told again;
/// to one who is still being told the match so far it comes once more, in its place. The same id at
/// the same sequence number is the same command sent again and is answered with the same entry,
/// once more.
struct Act {
  match::MatchId match{};
  match::Seq expected{};
  match::CommandId id{};   ///< not 0, which stands for the server's commands
  match::Command command;  ///< never Start or Abandoned: those are the server's

  friend bool operator==(const Act&, const Act&) = default;
};
/// Asks to be given the match, since the opponent has vanished for long enough; answered by
/// EntryNews with the entry Abandoned.
struct Claim {
  match::MatchId match{};

  friend bool operator==(const Claim&, const Claim&) = default;
};
/// Stops following a match; before its start, also gives up the seat. Answered by Done.
struct Leave {
  match::MatchId match{};

  friend bool operator==(const Leave&, const Leave&) = default;
};
/// Shows that the client is still there, so that a silent connection is a dead one. Answered with
/// Done.
struct Ping {
  friend bool operator==(const Ping&, const Ping&) = default;
};

using Request =
    std::variant<Hello, Create, Join, Watch, List, Fetch, Contribute, Act, Claim, Leave, Ping>;

// ---- What clients are told

/// The answer to a good Hello.
struct Welcome {
  std::string name;
  std::optional<Token> token;  ///< given once, to a new guest
  std::string server;          ///< version, for people
  /// How long an opponent must have been away before Claim succeeds, ms.
  std::int64_t claim_after_ms = 0;

  friend bool operator==(const Welcome&, const Welcome&) = default;
};

enum class RefusalCode : std::uint8_t {
  unsupported_version,
  bad_request,  ///< a value out of range; the text names it
  hello_first,
  unknown_token,  ///< ask again without it to become a new guest
  no_such_match,  ///< also a private one that the asker may not see
  match_full,
  wrong_stage,  ///< e.g. contributing to a running match
  not_seated,
  too_early,  ///< a claim before the opponent has been away for long enough
  too_many,   ///< a limit of the server is reached; the text names it
  /// The store failed or the server is stopping; nothing was changed as far as anyone was told.
  /// Asking again, with the same command id or key, is safe.
  unavailable,
  command,  ///< match::Refusal: `detail` says which
};
struct Refused {
  RefusalCode code{};
  std::optional<match::RefusalCode> detail;  ///< with `command`
  std::string what;

  friend bool operator==(const Refused&, const Refused&) = default;
};

struct SeatInfo {
  std::string name;  ///< empty: free
  bool contributed = false;
  bool present = false;
  std::int64_t away_ms = 0;  ///< how long the player has been gone; 0 when present

  friend bool operator==(const SeatInfo&, const SeatInfo&) = default;
};

/// A match as the lobby sees it.
struct MatchInfo {
  match::MatchId id{};
  match::Settings settings;
  hash::Digest commitment{};
  std::int64_t created_unix_ms = 0;
  match::Stage stage = match::Stage::gathering;
  std::vector<SeatInfo> seats;
  std::vector<std::uint32_t> score;
  match::Seq next{};  ///< the number of the next entry
  std::optional<match::Seat> winner;
  std::optional<match::MatchEnd> end;
  bool is_private = false;
  std::optional<InviteCode> code;  ///< told to those who sit at the match

  friend bool operator==(const MatchInfo&, const MatchInfo&) = default;
};

/// The answer to Create, Join and Watch, the beginning of the answer to Fetch, and told to all
/// followers when a seat is taken, given up, contributes, is present or away, and at the start.
struct MatchNews {
  MatchInfo info;
  std::optional<match::Seat> you;        ///< the follower's own seat
  std::optional<record::Header> header;  ///< once the match has started

  friend bool operator==(const MatchNews&, const MatchNews&) = default;
};
/// One entry: the match so far to a newcomer, then each as it is stored. The answer to Act and
/// Claim.
struct EntryNews {
  match::MatchId match{};
  std::shared_ptr<const record::Entry> entry;  ///< shared by all that are told

  friend bool operator==(const EntryNews& a, const EntryNews& b) {
    return a.match == b.match &&
           (a.entry == b.entry || (a.entry && b.entry && *a.entry == *b.entry));
  }
};
/// Told to the followers of a match that is no more, without ever having started.
struct MatchGone {
  match::MatchId match{};
  std::string what;

  friend bool operator==(const MatchGone&, const MatchGone&) = default;
};
struct Listing {
  std::vector<MatchInfo> matches;  ///< newest first, at most page_size
  bool more = false;

  friend bool operator==(const Listing&, const Listing&) = default;
};
inline constexpr std::size_t page_size = 50;
/// Follows the last entry of a fetched record.
struct FetchDone {
  match::MatchId match{};
  match::Seq next{};  ///< the number of the entry after the last one told

  friend bool operator==(const FetchDone&, const FetchDone&) = default;
};
/// The request was carried out and there is nothing else to say (Contribute, Leave, Ping).
struct Done {
  friend bool operator==(const Done&, const Done&) = default;
};
/// Why a connection is closed by the server; tells a client whether to come back by itself.
enum class GoodbyeReason : std::uint8_t {
  stopping,      ///< the server goes down: come back later
  taken_over,    ///< the same guest has connected again: do not come back
  too_slow,      ///< too much was waiting to be sent: come back and resume
  idle,          ///< nothing was heard for too long: come back
  too_many,      ///< the server is full: come back later
  bad_protocol,  ///< what was sent is not the protocol, or of another version: do not come back
};
/// The server is about to close the connection, and why.
struct Goodbye {
  GoodbyeReason reason{};
  std::string what;

  friend bool operator==(const Goodbye&, const Goodbye&) = default;
};

using Answer = std::variant<Welcome, Refused, MatchNews, EntryNews, MatchGone, Listing, FetchDone,
                            Done, Goodbye>;

/// Pairs answers with requests; chosen by the client, 0 in what nobody asked for.
enum class RequestId : std::uint32_t {};

struct Asked {
  RequestId id{};
  Request request;

  friend bool operator==(const Asked&, const Asked&) = default;
};
struct Told {
  RequestId id{};
  Answer answer;

  friend bool operator==(const Told&, const Told&) = default;
};

}  // namespace breakshot::lobby
