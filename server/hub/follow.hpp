// Who is told a match's entries: followers, who go on live, and fetchers, who stop at an end. Each
// is a reader with a place of its own, so nobody misses an entry or is told one twice.
//
// Those who are behind are told one batch at a time, and the next only when the last one has been
// written: a long match never stands in a send queue as a whole.
#pragma once

#include <optional>

#include "server/hub/moment.hpp"

namespace breakshot::hub {

/// Whether the connection's limit leaves room to follow this match.
bool may_follow(State& state, ConnectionId id, match::MatchId match);

/// Makes the connection a follower from `from` on; if it was one already it starts again. Nothing
/// is told yet: `serve` does, after the asker was told about the match itself.
void follow(Moment& moment, ConnectionId id, LiveMatch& match, match::Seq from);
/// The same for a match that is not live: only what is stored is told.
void follow_stored(Moment& moment, ConnectionId id, const ledger::MatchRow& row, match::Seq from);
/// Tells the entries from `from` up to `end` as part of the answer to a request. `serve` begins.
void read_out(Moment& moment, const Asker& asker, match::MatchId match, match::Seq from,
              match::Seq end);

/// Stops following; what this means for the presence of a player is up to the caller.
void unfollow(Moment& moment, ConnectionId id, match::MatchId match);
/// Ends everything that is told to a connection unasked, and its fetches.
void stop_reading(Moment& moment, ConnectionId id);

/// Tells the next batch to a connection whose readers are behind, if it may be told one now.
void serve(Moment& moment, ConnectionId id);
/// What was told has been written.
void drained(Moment& moment, ConnectionId id);
void batch_loaded(Moment& moment, const LoadingBatch& loading, const ledger::FoundEntries& found);
void batch_failed(Moment& moment, const LoadingBatch& loading);

/// Answers a command with its entry. To a follower who is to be told just this one next, the answer
/// is it.
void answer_with_entry(Moment& moment, const Asker& asker, match::MatchId match,
                       const ledger::EntryPointer& entry);
/// Tells a new entry, which is match.recent.back(), to all who are up to date, and answers the one
/// who asked for it.
void announce(Moment& moment, LiveMatch& match, const std::optional<Asker>& asker);
/// The match is finished: those who are behind end where it ends.
void end_following(Moment& moment, LiveMatch& match);

}  // namespace breakshot::hub
