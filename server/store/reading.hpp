// Each query in SQL, and what it found as values.
#pragma once

#include <functional>

#include "server/ledger/ledger.hpp"
#include "server/store/sqlite.hpp"

namespace breakshot::store {

/// Throws if the database cannot be read or holds what no server has written.
ledger::Found answer(Database& database, const ledger::Query& query);

/// Every match that is not finished, in order of id; one that cannot be read as damaged.
void read_live(Database& database, const std::function<void(ledger::Restored)>& give);

}  // namespace breakshot::store
