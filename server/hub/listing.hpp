// Which matches there are: open and running ones from memory, the others from the store.
#pragma once

#include "server/hub/moment.hpp"

namespace breakshot::hub {

void list(Moment& moment, const Ask& ask, const lobby::List& list);
void list_loaded(Moment& moment, const LoadingList& loading, const ledger::FoundMatches& found);

}  // namespace breakshot::hub
