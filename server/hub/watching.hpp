// Watching a match and fetching its record, of matches that are live and of those that are stored.
#pragma once

#include "server/hub/moment.hpp"

namespace breakshot::hub {

// The guest may see the match.

void watch(Moment& moment, const Ask& ask, LiveMatch& match, const lobby::Watch& watch);
void fetch(Moment& moment, const Ask& ask, const LiveMatch& match, const lobby::Fetch& fetch);

/// A player comes back to a match that is not live.
void rejoin_stored(Moment& moment, const Ask& ask, const ledger::MatchRow& row,
                   const lobby::Join& join);
void watch_stored(Moment& moment, const Ask& ask, const ledger::MatchRow& row, match::Seq from);
void fetch_stored(Moment& moment, const Ask& ask, const ledger::MatchRow& row, match::Seq from);

/// What is wrong with beginning to read at `from`, or nothing.
std::optional<std::string> place_fault(const ledger::MatchRow& row, match::Seq from);
/// Refuses to follow one match more than the connection may.
void refuse_following(Moment& moment, const Asker& asker);

}  // namespace breakshot::hub
