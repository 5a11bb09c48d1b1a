// Until a match starts: creating it, taking and giving up seats, contributing to its seed.
#pragma once

#include "server/hub/moment.hpp"

namespace breakshot::hub {

void create(Moment& moment, const Ask& ask, const lobby::Create& create, const Entropy& entropy);
void match_stored(Moment& moment, StoringMatch storing);
void match_failed(Moment& moment, const StoringMatch& storing);

// The match of the following is live, the guest may see it, and no change of it is under way.

/// Takes a seat, or follows it again from its own.
void join(Moment& moment, const Ask& ask, LiveMatch& match, const lobby::Join& join);
void contribute(Moment& moment, const Ask& ask, LiveMatch& match,
                const lobby::Contribute& contribute);
/// Stops following, and gives up the seat unless the match has started.
void leave(Moment& moment, const Ask& ask, LiveMatch& match);
/// Forgets a match that has not started.
void discard(Moment& moment, LiveMatch& match, const std::optional<Asker>& asker, std::string why);

void seats_stored(Moment& moment, LiveMatch& match, StoringSeats storing);
void seats_failed(Moment& moment, const StoringSeats& storing);
/// The caller then removes the match.
void discard_stored(Moment& moment, LiveMatch& match, const StoringDiscard& storing);
void discard_failed(Moment& moment, const StoringDiscard& storing);

}  // namespace breakshot::hub
