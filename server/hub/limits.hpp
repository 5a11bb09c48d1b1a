// Every limit of the server's decisions, in one place. What a single message may say is limited by
// common/lobby, what a match may be by match::faults_of, what may wait to be sent by server/net.
#pragma once

#include <chrono>
#include <cstddef>

namespace breakshot::hub {

struct Limits {
  // ---- Connections
  /// Connections at once; one more is told Goodbye.
  std::size_t connections = 2048;
  /// Requests of one connection that are not answered yet.
  std::size_t asks_per_connection = 16;
  /// Matches that one connection follows at once.
  std::size_t follows_per_connection = 8;
  /// Invite codes of no match that one connection may try before it is closed.
  std::size_t wrong_codes_per_connection = 20;

  // ---- Matches
  /// Matches open or running at once.
  std::size_t live_matches = 2000;
  /// Matches open or running in which one guest sits.
  std::size_t live_matches_per_guest = 8;
  /// Followers of one match that do not sit at it.
  std::size_t spectators_per_match = 200;
  /// Entries of one match; then it can only be conceded or claimed.
  std::size_t entries_per_match = 10'000;
  /// Requests to change one match that wait while a change of it is being stored.
  std::size_t asks_per_match = 32;

  // ---- Memory
  /// The newest entries of a running match that stay in memory; older ones are read from the store.
  std::size_t recent_entries = 32;
  /// Entries told or loaded at a time to one that is behind end at the first beyond this, bytes.
  std::size_t batch_bytes = 256 * 1024;

  // ---- Time
  /// A match that has not started is discarded this long after it was created.
  std::chrono::milliseconds gathering_expires = std::chrono::hours(24);
  /// How long an opponent must have been away before the match can be claimed.
  std::chrono::milliseconds claim_after = std::chrono::minutes(10);
  /// A running match at which nobody has been present for so long is ended as abandoned.
  std::chrono::milliseconds deserted_ends = std::chrono::hours(24 * 7);
};

}  // namespace breakshot::hub
