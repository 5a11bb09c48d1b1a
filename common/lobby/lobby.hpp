// What clients ask and are told, as values: the vocabulary that the wire says and the hub answers.
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

inline constexpr std::uint32_t protocol_version = 1;
/// Where servers listen and clients look unless told otherwise: POOL on a telephone's keys.
inline constexpr std::uint16_t default_port = 7665;

/// A guest's identity: whoever shows it is that guest. The server keeps only its SHA-256.
using Token = std::array<std::uint8_t, 32>;
/// Lets its holder join, watch and fetch a private match: 10 characters of Crockford's base 32.
using InviteCode = std::string;

// Limits of what clients may say, in one place. A name is 1 to 32 code points of UTF-8 without
// control characters and without leading or trailing space.
inline constexpr std::size_t max_name_bytes = 64;
inline constexpr std::size_t invite_code_length = 10;

// ---- What clients ask

struct Hello {
  std::uint32_t version = protocol_version;
  std::string name;
  std::optional<Token> token;  ///< missing: a new guest
};
struct Create {
  std::string preset;  ///< a name out of physics::presets(); empty: the default
  match::GameKind game = match::GameKind::eight_ball;
  std::uint8_t seats = 2;
  std::uint32_t race_to = 1;
  bool is_private = false;
};
/// Takes a free seat, or comes back to one's own. By id, or by the code of a private match.
struct Join {
  std::optional<match::MatchId> match;
  std::optional<InviteCode> code;
};
/// Follows a match from entry `from` on: the match so far, then what happens.
struct Watch {
  std::optional<match::MatchId> match;
  std::optional<InviteCode> code;
  match::Seq from{};
};
enum class Filter : std::uint8_t { open, running, mine, finished };
struct List {
  Filter filter = Filter::open;
  std::optional<match::MatchId> after;  ///< the last one of the page before
};
/// A whole record, header and entries.
struct Fetch {
  std::optional<match::MatchId> match;
  std::optional<InviteCode> code;
};
struct Contribute {
  match::MatchId match{};
  match::Contribution contribution{};
};
struct Act {
  match::MatchId match{};
  match::Seq expected{};
  match::CommandId id{};
  match::Command command;  ///< never Start or Abandoned: those are the server's
};
/// Asks to be given the match, since the opponent has vanished for long enough.
struct Claim {
  match::MatchId match{};
};
/// Stops following a match; before its start, also gives up the seat.
struct Leave {
  match::MatchId match{};
};
/// Shows that the client is still there, so that a silent connection is a dead one. Answered with
/// Done.
struct Ping {};

using Request =
    std::variant<Hello, Create, Join, Watch, List, Fetch, Contribute, Act, Claim, Leave, Ping>;

// ---- What clients are told

/// The answer to a good Hello.
struct Welcome {
  std::string name;
  std::optional<Token> token;  ///< given once, to a new guest
  std::string server;          ///< version, for people
};

enum class RefusalCode : std::uint8_t {
  unsupported_version,
  bad_request,  ///< a value out of range; the text names it
  hello_first,
  unknown_token,
  no_such_match,  ///< also a private one that the asker may not see
  match_full,
  wrong_stage,  ///< e.g. contributing to a running match
  not_seated,
  too_early,    ///< a claim before the opponent has been away for long enough
  too_many,     ///< a limit of the server is reached; the text names it
  unavailable,  ///< the store failed or the server is stopping; nothing was changed
  command,      ///< match::Refusal: `detail` says which
};
struct Refused {
  RefusalCode code{};
  std::optional<match::RefusalCode> detail;  ///< with `command`
  std::string what;
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
  bool is_private = false;
  std::optional<InviteCode> code;  ///< told to those who sit at the match

  friend bool operator==(const MatchInfo&, const MatchInfo&) = default;
};

/// The answer to Create, Join and Watch, and told to all followers when the seats change.
struct MatchNews {
  MatchInfo info;
  std::optional<match::Seat> you;        ///< the follower's own seat
  std::optional<record::Header> header;  ///< once the match has started
};
/// One entry: the match so far to a newcomer, then each as it is stored.
struct EntryNews {
  match::MatchId match{};
  std::shared_ptr<const record::Entry> entry;  ///< shared by all that are told
};
struct Listing {
  std::vector<MatchInfo> matches;  ///< newest first, at most page_size
  bool more = false;
};
inline constexpr std::size_t page_size = 50;
/// Follows the last entry of a fetched record.
struct FetchDone {
  match::MatchId match{};
  std::uint32_t entries = 0;
};
/// The request was carried out and there is nothing else to say (Contribute, Leave, Ping).
struct Done {};
/// The server is about to close the connection, and why.
struct Goodbye {
  std::string what;
};

using Answer =
    std::variant<Welcome, Refused, MatchNews, EntryNews, Listing, FetchDone, Done, Goodbye>;

/// Pairs answers with requests; chosen by the client, 0 in what nobody asked for.
enum class RequestId : std::uint32_t {};

struct Asked {
  RequestId id{};
  Request request;
};
struct Told {
  RequestId id{};
  Answer answer;
};

}  // namespace breakshot::lobby
