// What happened: header, chained entries, and the one canonical encoding of both that is the file,
// the database blob and the hash input.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/hash/hash.hpp"
#include "common/match/match.hpp"
#include "common/physics/simulate.hpp"

namespace breakshot::record {

inline constexpr std::uint32_t format_version = 1;

struct Player {
  std::string name;
  match::Contribution contribution{};

  friend bool operator==(const Player&, const Player&) = default;
};

/// Fixed once every seat is taken and has contributed.
struct Header {
  std::uint32_t format = format_version;
  std::uint32_t physics = physics::physics_version;
  match::MatchId id{};
  std::int64_t created_unix_ms = 0;  ///< for people; nothing depends on it
  match::Settings settings;
  std::vector<Player> players;  ///< by seat
  hash::Digest commitment{};    ///< commitment_of(secret)

  friend bool operator==(const Header&, const Header&) = default;
};

/// One accepted command with its outcome.
struct Entry {
  match::Seq seq{};
  match::Author author;
  match::CommandId id{};
  match::Command command;
  match::Outcome outcome;
  std::optional<match::Secret> secret;  ///< in the last entry of a finished match
  /// SHA-256(digest before || canonical bytes of this entry without its digest); the digest before
  /// the first entry is digest_of(header).
  hash::Digest digest{};

  friend bool operator==(const Entry&, const Entry&) = default;
};

/// What keeps a value out of the record: a limit (limits.hpp), a number that is not finite, text
/// that does not print as it is, an order that is not kept, a seat that the match does not have.
/// For values that come from elsewhere, before `encode`; what `read_file` gives is free of faults.
std::optional<std::string> fault_of(const Header& header);
std::optional<std::string> fault_of(const Header& header, const Entry& entry);

using ByteVector = std::vector<std::uint8_t>;

/// The canonical bytes (docs/record.md). The value must be free of faults: std::logic_error.
ByteVector encode(const Header& header);
/// With the digest as its last 32 bytes.
ByteVector encode(const Entry& entry);

/// The settings alone, as the header holds them: for a match that has not started.
ByteVector encode(const match::Settings& settings);

/// What is wrong with bytes, and at which offset of them.
struct Damage {
  std::size_t offset = 0;
  std::string what;

  friend bool operator==(const Damage&, const Damage&) = default;
};

std::variant<Header, Damage> decode_header(hash::Bytes bytes);
std::variant<Entry, Damage> decode_entry(hash::Bytes bytes);
std::variant<match::Settings, Damage> decode_settings(hash::Bytes bytes);

hash::Digest digest_of(const Header& header);
/// The digest that `entry` must carry after `before`; its own digest field is not read.
hash::Digest digest_of(const hash::Digest& before, const Entry& entry);

/// SHA-256 of "breakshot.simulate.1" and the canonical bytes of the shot's events and final state.
hash::Digest simulation_digest(const physics::Shot& shot);

// ---- Files

struct Record {
  Header header;
  std::vector<Entry> entries;

  friend bool operator==(const Record&, const Record&) = default;
};

/// The bytes of a `.breakshot` file.
ByteVector file_of(const Record& record);

/// The valid prefix of a file, and where and how it broke. Without a header there is no record.
struct Reading {
  std::optional<Record> record;
  std::optional<Damage> damage;
};

/// Reads hostile bytes: any input gives a reading. Structure, sequence and the digest chain are
/// checked, so that a reading without damage holds exactly the bytes that `file_of` gives for it.
Reading read_file(hash::Bytes bytes);

// ---- Verification

/// Earlier versions of the physics that can still be simulated with the same bits
/// (`physics::Limits`): of version 1, the tables that were offered for matches then.
inline constexpr std::array<std::uint32_t, 2> earlier_physics{1, 2};
static_assert(physics::physics_version <= 3, "which versions have kept their bits must be said");

/// Whether what was played by this version of the physics can be simulated again.
bool can_simulate(std::uint32_t physics);
/// Those versions for people: "version 1", "versions 1 and 2".
std::string simulated_versions();
/// The first field of a scene with what that version did not have yet, and what that is. A record
/// that holds both was not played so.
std::optional<std::string> newer_part_of(const physics::Scene& scene, std::uint32_t physics);

/// The first entry whose re-simulation differs from what is stored, and how.
struct Divergence {
  match::Seq seq{};
  std::string what;

  friend bool operator==(const Divergence&, const Divergence&) = default;
};

struct Verdict {
  enum class Kind : std::uint8_t { verified, diverged, not_revealed_yet, unknown_physics } kind{};
  std::size_t entries_verified = 0;
  std::optional<Divergence> divergence;  ///< with `diverged`

  friend bool operator==(const Verdict&, const Verdict&) = default;
};

/// Folds the commands again and compares outcomes and digests. The last entry must hold the secret,
/// whose commitment is checked first; without it only sequence and digests are checked. What is
/// wrong with the header is reported as of its entry 0.
Verdict verify(const Record& record);

}  // namespace breakshot::record
