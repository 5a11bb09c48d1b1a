// What is kept, as values: the changes that the hub orders and the store carries out, and what the
// store gives back. The hub and the store know this room and not each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/hash/hash.hpp"
#include "common/match/match.hpp"
#include "common/record/record.hpp"

namespace breakshot::ledger {

/// Who a guest is: the SHA-256 of the token that only the guest has.
struct GuestId {
  hash::Digest token_hash{};

  friend auto operator<=>(const GuestId&, const GuestId&) = default;
};

struct Guest {
  GuestId id;
  std::string name;

  friend bool operator==(const Guest&, const Guest&) = default;
};

/// A guest at a match. The name is the one under which the seat was taken.
struct Sitter {
  GuestId guest;
  std::string name;
  std::optional<match::Contribution> contribution;

  friend bool operator==(const Sitter&, const Sitter&) = default;
};

/// By seat; a free seat is empty.
using Seats = std::vector<std::optional<Sitter>>;

/// Where a match stands, as its last entry left it.
struct Progress {
  match::Stage stage = match::Stage::gathering;
  match::Seq next{};  ///< the number of entries
  std::vector<std::uint32_t> score;
  std::optional<match::Seat> winner;
  std::optional<match::MatchEnd> end;

  friend bool operator==(const Progress&, const Progress&) = default;
};

/// The progress that an entry leads to.
Progress progress_after(const record::Entry& entry);

/// All that is kept about a match but its entries and its secret.
struct MatchRow {
  match::MatchId id{};
  match::Settings settings;
  hash::Digest commitment{};
  std::int64_t created_unix_ms = 0;
  std::optional<std::string> code;  ///< the invite code of a private match
  Seats seats;
  std::optional<record::Header> header;  ///< once the match has started
  Progress progress;

  friend bool operator==(const MatchRow&, const MatchRow&) = default;
};

using EntryPointer = std::shared_ptr<const record::Entry>;

// ---- Changes

/// A new guest, or a new name for one that is known.
struct PutGuest {
  Guest guest;
};
/// A match without header and entries. The secret goes to a place of its own, from which only
/// restoring reads it.
struct CreateMatch {
  MatchRow row;
  match::Secret secret{};
};
struct PutSeats {
  match::MatchId match{};
  Seats seats;
};
struct PutHeader {
  record::Header header;  ///< of the match header.id
};
/// Fails unless the entry is the next one of its match.
struct AppendEntry {
  match::MatchId match{};
  EntryPointer entry;
};
/// Forgets a match that has not started.
struct DiscardMatch {
  match::MatchId match{};
};

using Change = std::variant<PutGuest, CreateMatch, PutSeats, PutHeader, AppendEntry, DiscardMatch>;

/// All or nothing.
using Batch = std::vector<Change>;

// ---- Queries

struct FindGuest {
  GuestId id;
};
/// By id, by code, or by both, which must then belong together.
struct FindMatch {
  std::optional<match::MatchId> id;
  std::optional<std::string> code;
};
/// A place in the order of listings: newest first, and among equals the greater id first.
struct Place {
  std::int64_t created_unix_ms = 0;
  match::MatchId match{};
};
/// Matches in the order of listings.
struct ListMatches {
  enum class Which : std::uint8_t {
    finished,  ///< finished ones that are public or in which `guest` sits
    mine,      ///< all in which `guest` sits
  } which{};
  GuestId guest;
  std::optional<Place> after;
  std::size_t count = 0;  ///< at most so many
};
/// Entries from `from` on: as many as there are, but no further one once `bytes` are reached, so at
/// least one if there is any.
struct FindEntries {
  match::MatchId match{};
  match::Seq from{};
  std::size_t bytes = 0;  ///< of their canonical encoding
};

using Query = std::variant<FindGuest, FindMatch, ListMatches, FindEntries>;

struct FoundGuest {
  std::optional<Guest> guest;
};
struct FoundMatch {
  std::optional<MatchRow> row;
};
struct FoundMatches {
  std::vector<MatchRow> rows;
};
struct FoundEntries {
  std::vector<EntryPointer> entries;
};

/// The alternatives stand in the order of those of Query.
using Found = std::variant<FoundGuest, FoundMatch, FoundMatches, FoundEntries>;

// ---- Reports

/// Pairs reports with what was ordered; never used twice while the server runs.
enum class Ticket : std::uint64_t {};

/// The batch is committed: it survives whatever happens from now on.
struct Stored {
  Ticket ticket{};
};
/// Nothing of the batch is kept. (If the machine fails before the next batch is stored, the medium
/// may turn out to have it after all: an answer given after this must not promise otherwise.)
struct StoreFailed {
  Ticket ticket{};
  std::string why;
};
struct Loaded {
  Ticket ticket{};
  Found found;
};
struct LoadFailed {
  Ticket ticket{};
  std::string why;
};

using Report = std::variant<Stored, StoreFailed, Loaded, LoadFailed>;

// ---- Start-up

/// A match that is not finished, with everything that is needed to go on.
struct LiveMatch {
  MatchRow row;
  match::Secret secret{};
  std::vector<EntryPointer> entries;
};
/// A match that is not finished and cannot be read.
struct DamagedMatch {
  match::MatchId match{};
  std::string what;
};

using Restored = std::variant<LiveMatch, DamagedMatch>;

}  // namespace breakshot::ledger
