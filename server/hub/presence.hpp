// Who is there: a player is present at a table whose connection follows the match.
#pragma once

#include <optional>

#include "server/hub/moment.hpp"

namespace breakshot::hub {

/// Notes who is present at the table; whether anything has changed.
bool note_presence(Moment& moment, LiveMatch& match);
/// The same; followers are told of a change, but not `except`.
void update_presence(Moment& moment, LiveMatch& match,
                     const std::optional<ConnectionId>& except = std::nullopt);

/// Whether the connection is a player's now: one that follows a match at which it sits.
void update_standing(Moment& moment, ConnectionId id);

}  // namespace breakshot::hub
