// What happens by itself: matches come back when the server starts, and end when time has passed.
#pragma once

#include "server/hub/moment.hpp"

namespace breakshot::hub {

void restored(Moment& moment, ledger::Restored restored);
void ticked(Moment& moment);

}  // namespace breakshot::hub
