// A store under test, whichever it is, and values to keep in it.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "server/store/store.hpp"
#include "tests/support/memory_store.hpp"
#include "tests/support/played_match.hpp"
#include "tests/support/scratch.hpp"

namespace breakshot::store {

/// What a store has reported, from whichever thread.
class Reports {
 public:
  Reporter reporter() {
    return [this](ledger::Report report) {
      const std::lock_guard lock(mutex_);
      reports_.push_back(std::move(report));
      changed_.notify_all();
    };
  }
  /// Waits until there are so many, and gives all.
  std::vector<ledger::Report> wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return reports_.size() >= count; });
    return reports_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<ledger::Report> reports_;
};

/// A store that may be closed and opened again.
class Shelf {
 public:
  virtual ~Shelf() = default;
  virtual Store& store() = 0;
  virtual void reopen() = 0;
  /// Waits until so many orders are reported since it was opened.
  virtual std::vector<ledger::Report> reports(std::size_t count) = 0;

  ledger::Ticket append(ledger::Batch batch) {
    store().append(ledger::Ticket{++orders_}, std::move(batch));
    return ledger::Ticket{orders_};
  }
  /// Why a batch failed, or nothing.
  std::optional<std::string> put(ledger::Batch batch) {
    append(std::move(batch));
    const ledger::Report last = reports(orders_).back();
    if (const auto* failed = std::get_if<ledger::StoreFailed>(&last)) return failed->why;
    if (std::get<ledger::Stored>(last).ticket != ledger::Ticket{orders_}) {
      throw std::logic_error("the report of another ticket");
    }
    return std::nullopt;
  }
  ledger::Report ask(ledger::Query query) {
    store().load(ledger::Ticket{++orders_}, std::move(query));
    return reports(orders_).back();
  }
  template <class Found>
  Found find(ledger::Query query) {
    const ledger::Report report = ask(std::move(query));
    if (const auto* failed = std::get_if<ledger::LoadFailed>(&report)) {
      throw std::runtime_error("not loaded: " + failed->why);
    }
    return std::get<Found>(std::get<ledger::Loaded>(report).found);
  }
  std::optional<ledger::MatchRow> row(match::MatchId id) {
    return find<ledger::FoundMatch>(ledger::FindMatch{id, std::nullopt}).row;
  }
  std::vector<ledger::Restored> restored() {
    std::vector<ledger::Restored> all;
    store().restore([&](ledger::Restored one) { all.push_back(std::move(one)); });
    return all;
  }

 protected:
  void restart() { orders_ = 0; }

 private:
  std::uint64_t orders_ = 0;
};

class SqliteShelf final : public Shelf {
 public:
  SqliteShelf() { open(); }
  Store& store() override { return *store_; }
  void reopen() override {
    store_.reset();
    restart();
    open();
  }
  std::vector<ledger::Report> reports(std::size_t count) override {
    return reports_->wait_for(count);
  }
  void close() { store_.reset(); }
  std::filesystem::path file() const { return scratch_.path() / "matches.db"; }

 private:
  void open() {
    reports_ = std::make_unique<Reports>();
    store_ = open_sqlite(file(), reports_->reporter());
  }

  support::Scratch scratch_;
  std::unique_ptr<Reports> reports_;
  std::unique_ptr<Store> store_;
};

class MemoryShelf final : public Shelf {
 public:
  MemoryShelf() { open({}); }
  Store& store() override { return *store_; }
  void reopen() override {
    restart();
    open(store_->kept());
  }
  std::vector<ledger::Report> reports(std::size_t count) override {
    while (store_->work()) {
    }
    return reports_->wait_for(count);
  }

 private:
  void open(support::Kept kept) {
    reports_ = std::make_unique<Reports>();
    store_ = std::make_unique<support::MemoryStore>(reports_->reporter(), std::move(kept));
  }

  std::unique_ptr<Reports> reports_;
  std::unique_ptr<support::MemoryStore> store_;
};

// ---- Values to keep

inline ledger::GuestId guest(std::uint8_t number) {
  ledger::GuestId id;
  id.token_hash.fill(number);
  return id;
}

inline match::Secret secret(std::uint8_t number) {
  match::Secret secret{};
  secret.fill(static_cast<std::uint8_t>(0xa0 + number));
  return secret;
}

/// A match of two that has not started; guest 1 sits at it.
inline ledger::MatchRow open_match(std::uint64_t id, std::int64_t created_unix_ms = 1000) {
  ledger::MatchRow row;
  row.id = match::MatchId{id};
  const physics::Preset& preset = physics::presets().front();
  row.settings = {std::string(preset.name), preset.scene, match::GameKind::eight_ball, 2, 3};
  row.commitment.fill(static_cast<std::uint8_t>(id));
  row.created_unix_ms = created_unix_ms;
  row.seats = {ledger::Sitter{guest(1), "Ada", std::nullopt}, std::nullopt};
  row.progress.score = {0, 0};
  return row;
}

/// A whole match as changes, with the row to which they lead. One entry a batch.
struct Story {
  std::vector<ledger::Batch> batches;
  ledger::MatchRow row;
  std::vector<ledger::EntryPointer> entries;
  match::Secret secret{};
};

/// So many shots of a practice of one, by guest 1; with `finished` it then ends.
inline Story story(std::uint64_t id, int shots, bool finished,
                   std::int64_t created_unix_ms = 1000) {
  support::PlayedMatch played(id, match::GameKind::practice, 1);
  for (int i = 0; i < shots; ++i) played.step();
  if (finished) played.play(0);
  Story story;
  story.secret = secret(1);
  story.row = open_match(id, created_unix_ms);
  story.row.settings = played.record().header.settings;
  story.row.seats = {ledger::Sitter{guest(1), "Ada", secret(7)}};
  story.row.progress.score = {0};
  story.batches.push_back({ledger::CreateMatch{story.row, story.secret}});
  record::Header header = played.record().header;
  header.id = story.row.id;
  story.row.header = header;
  story.batches.push_back({ledger::PutHeader{header}});
  for (const record::Entry& entry : played.record().entries) {
    story.entries.push_back(std::make_shared<const record::Entry>(entry));
    const ledger::AppendEntry append{story.row.id, story.entries.back()};
    if (story.entries.size() == 1) {
      story.batches.back().push_back(append);
    } else {
      story.batches.push_back({append});
    }
    story.row.progress = ledger::progress_after(entry);
  }
  return story;
}

/// Whether two lists of entries hold the same.
inline bool same(const std::vector<ledger::EntryPointer>& a,
                 const std::vector<ledger::EntryPointer>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return *x == *y; });
}

}  // namespace breakshot::store
