// The store in a file of SQLite's: one thread writes, one reads, each with a connection of its own.
#include <string>
#include <utility>
#include <vector>

#include "server/store/limits.hpp"
#include "server/store/lock.hpp"
#include "server/store/reading.hpp"
#include "server/store/schema.hpp"
#include "server/store/sqlite.hpp"
#include "server/store/store.hpp"
#include "server/store/worker.hpp"
#include "server/store/writing.hpp"

namespace breakshot::store {
namespace {

struct Order {
  ledger::Ticket ticket{};
  ledger::Batch batch;
};
struct Question {
  ledger::Ticket ticket{};
  ledger::Query query;
};

/// Writes groups of batches. What became of each is told when the whole group is committed.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& file)
      : database_(open_to_write(file)), writing_(database_) {}

  /// By batch: why it failed, or nothing.
  std::vector<std::optional<std::string>> write(const std::vector<Order>& group) {
    std::vector<std::optional<std::string>> failures(group.size());
    try {
      database_.run("BEGIN IMMEDIATE");
      for (std::size_t i = 0; i < group.size(); ++i) failures[i] = write_one(group[i].batch);
      database_.run("COMMIT");
    } catch (const std::exception& error) {
      roll_back();
      failures.assign(group.size(), error.what());
    }
    return failures;
  }

 private:
  std::optional<std::string> write_one(const ledger::Batch& batch) {
    database_.run("SAVEPOINT batch");
    try {
      for (const ledger::Change& change : batch) writing_.carry_out(change);
    } catch (const std::exception& error) {
      // Some errors, a full disk among them, end the transaction: then the whole group has failed.
      if (database_.idle()) throw;
      database_.run("ROLLBACK TO batch");
      database_.run("RELEASE batch");
      return error.what();
    }
    database_.run("RELEASE batch");
    return std::nullopt;
  }

  void roll_back() noexcept {
    try {
      if (!database_.idle()) database_.run("ROLLBACK");
    } catch (const SqliteError&) {
      // Then the next BEGIN fails and says so.
    }
  }

  Database database_;
  Writing writing_;
};

class SqliteStore final : public Store {
 public:
  /// The file is prepared, and locked for as long as the store lives.
  SqliteStore(std::unique_ptr<const Lock> lock, std::filesystem::path file, Reporter reporter)
      : lock_(std::move(lock)),
        file_(std::move(file)),
        reporter_(std::move(reporter)),
        writer_(file_),
        reader_(file_, Database::Access::read_only),
        writing_(most_batches_at_once, [this](std::vector<Order> group) { write(group); }),
        reading_(1, [this](std::vector<Question> group) { read(group.front()); }) {}

  void append(ledger::Ticket ticket, ledger::Batch batch) override {
    writing_.give({ticket, std::move(batch)});
  }

  void load(ledger::Ticket ticket, ledger::Query query) override {
    reading_.give({ticket, std::move(query)});
  }

  void restore(const std::function<void(ledger::Restored)>& give) override {
    try {
      Database database(file_, Database::Access::read_only);
      read_live(database, give);
    } catch (const SqliteError& error) {
      throw StoreError(file_.string() + ": cannot be read: " + error.what());
    }
  }

 private:
  void write(const std::vector<Order>& group) {
    const auto failures = writer_.write(group);
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (failures[i]) {
        reporter_(ledger::StoreFailed{group[i].ticket, *failures[i]});
      } else {
        reporter_(ledger::Stored{group[i].ticket});
      }
    }
  }

  void read(const Question& question) {
    ledger::Report report;
    try {
      report = ledger::Loaded{question.ticket, answer(reader_, question.query)};
    } catch (const std::exception& error) {
      report = ledger::LoadFailed{question.ticket, error.what()};
    }
    reporter_(std::move(report));
  }

  const std::unique_ptr<const Lock> lock_;
  const std::filesystem::path file_;
  const Reporter reporter_;
  Writer writer_;
  Database reader_;
  Worker<Order> writing_;  ///< the threads come last: they use all of the above
  Worker<Question> reading_;
};

}  // namespace

std::unique_ptr<Store> open_sqlite(const std::filesystem::path& file, Reporter reporter) {
  try {
    auto lock = std::make_unique<const Lock>(file.string() + "-lock");
    prepare_file(file);
    return std::make_unique<SqliteStore>(std::move(lock), file, std::move(reporter));
  } catch (const SqliteError& error) {
    throw StoreError(file.string() + ": cannot be opened: " + error.what());
  }
}

}  // namespace breakshot::store
