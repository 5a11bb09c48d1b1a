// Which part of the hub a request is for, and when: the changes of one match are carried out one at
// a time, in the order in which they were asked for.
#pragma once

#include "server/hub/moment.hpp"

namespace breakshot::hub {

void asked(Moment& moment, Asked asked);

/// The match of a request was looked up in the store, since it is not live or not for this guest to
/// see. Both take the same way, so that they look the same from outside.
void match_loaded(Moment& moment, LoadingMatch loading, const ledger::FoundMatch& found);

/// No change of the match is under way any more: the requests that waited for it have their turn.
void settle(Moment& moment, match::MatchId id);
/// The match is not live any more: finished, or discarded. Requests that waited for it are
/// answered.
void remove_match(Moment& moment, match::MatchId id);

}  // namespace breakshot::hub
