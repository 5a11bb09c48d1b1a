// What must hold of everything that is stored, whenever the server has ended.
#pragma once

#include "server/hub/hub.hpp"
#include "tests/support/memory_store.hpp"

namespace breakshot::simulation {

/// Every record verifies as far as it goes, and holds each command once. Throws Broken.
void check_records(const support::Kept& kept);

/// A server that starts from it goes on with every match that is not finished. Throws Broken.
void check_restart(const support::Kept& kept, const hub::Limits& limits, hub::Now now);

}  // namespace breakshot::simulation
