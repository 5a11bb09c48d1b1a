// A Create that is sent again, since its answer was lost: it leads to the match that the first one
// opened, so that a connection that breaks at a bad moment leaves no match that nobody knows of.
#pragma once

#include "server/hub/moment.hpp"

namespace breakshot::hub {

/// Answers a Create with the key of an earlier one of this guest's, now or when the match is
/// stored. False: there is none, and the request is a new one.
bool create_again(Moment& moment, const Ask& ask, const lobby::Create& create);

/// Answers one who asked again while the match was being stored, if still there.
void come_back(Moment& moment, const Asker& asker, LiveMatch& match);

}  // namespace breakshot::hub
