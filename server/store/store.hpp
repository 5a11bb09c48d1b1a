// Keeps what the hub orders to be kept. The interface says nothing about a database: one that lives
// in this process and its file (SQLite) stands behind it now; another may, without a change above.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "server/ledger/ledger.hpp"

namespace breakshot::store {

/// The store cannot be opened or read: the message says which file, what is wrong with it and what
/// would be right.
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Is called on threads of the store, one call at a time for appends and one at a time for loads.
/// It must not throw, wait for the store, or take long.
using Reporter = std::function<void(ledger::Report)>;

class Store {
 public:
  virtual ~Store() = default;

  /// Orders a batch to be stored and returns at once. Batches are carried out, and reported as
  /// Stored or StoreFailed, in the order of these calls. One that fails leaves nothing behind and
  /// does not hinder others. The caller bounds how many are under way.
  virtual void append(ledger::Ticket ticket, ledger::Batch batch) = 0;

  /// Orders an answer and returns at once; it is reported as Loaded or LoadFailed. It shows at
  /// least all batches that were reported as Stored before this call.
  virtual void load(ledger::Ticket ticket, ledger::Query query) = 0;

  /// Gives every match that is not finished, in order of id, on the calling thread. For start-up,
  /// before anything else is ordered. Throws StoreError if the store cannot be read; a single match
  /// that cannot be is given as damaged.
  virtual void restore(const std::function<void(ledger::Restored)>& give) = 0;
};

/// Opens or creates the database at `file` (with `file`-wal and `file`-shm beside it). Throws
/// StoreError if it is a file of something else, of a newer version, damaged, in use by another
/// server, or cannot be opened. The destructor carries out and reports what was ordered before.
std::unique_ptr<Store> open_sqlite(const std::filesystem::path& file, Reporter reporter);

}  // namespace breakshot::store
