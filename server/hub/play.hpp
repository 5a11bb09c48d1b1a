// A match that runs: its commands, what they become, and its end.
#pragma once

#include <optional>

#include "server/hub/moment.hpp"

namespace breakshot::hub {

/// The start command carried out: the first entry and the match after it.
Played start_of(const match::Settings& settings, const physics::Seed& seed,
                const hash::Digest& header, const match::Secret& secret);
/// The start is stored: everyone is told the header and the first entry.
void begin(Moment& moment, LiveMatch& match, Begun begun);

// The match of the following is live, the guest may see it, and no change of it is under way.

void act(Moment& moment, const Ask& ask, LiveMatch& match, const lobby::Act& act);
void claim(Moment& moment, const Ask& ask, LiveMatch& match);
/// Ends a match at which nobody has been present for long enough; nothing otherwise.
void abandon_if_deserted(Moment& moment, LiveMatch& match);

/// Whether a seat has left a practice that others go on with.
bool has_left(const LiveMatch& match, match::Seat seat);

/// Whether the match is finished by it. The caller then removes it.
bool entry_stored(Moment& moment, LiveMatch& match, StoringEntry storing);
void entry_failed(Moment& moment, const StoringEntry& storing);

/// Looks up what a command sent again became, in a match of which it may be an older entry.
void look_up(Moment& moment, const Ask& ask, match::Seat seat, const lobby::Act& act);
void entry_loaded(Moment& moment, const LoadingEntry& loading, const ledger::FoundEntries& found);

}  // namespace breakshot::hub
