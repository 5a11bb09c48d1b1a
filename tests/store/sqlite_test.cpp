// What belongs to the store in a file: what it refuses to open, and failures of the world.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "server/store/schema.hpp"
#include "server/store/sqlite.hpp"
#include "tests/store/shelf.hpp"

namespace breakshot::store {
namespace {

/// The message with which a file is refused.
std::string refusal_of(const std::filesystem::path& file) {
  try {
    open_sqlite(file, [](const ledger::Report&) {});
  } catch (const StoreError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find(file.filename().string()), std::string::npos) << what;
    return what;
  }
  return "opened";
}

bool says(const std::string& what, const std::string& part) {
  return what.find(part) != std::string::npos;
}

TEST(Opening, TheFileIsForItsOwnerAlone) {
  SqliteShelf shelf;
  ASSERT_FALSE(shelf.put({ledger::PutGuest{{guest(1), "Ada"}}}));
  for (const char* suffix : {"", "-wal", "-shm", "-lock"}) {
    const auto permissions = std::filesystem::status(shelf.file().string() + suffix).permissions();
    EXPECT_EQ(permissions, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write)
        << suffix;
  }
}

TEST(Opening, AFileOfSomethingElseIsRefusedAndLeftAsItIs) {
  const support::Scratch scratch;
  const auto file = scratch.path() / "notes.txt";
  const std::string text = "These are notes, long enough to be taken for a page of something else.";
  std::ofstream(file) << text;
  EXPECT_TRUE(says(refusal_of(file), "not a database"));
  std::ifstream read(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(read), {}), text);
}

TEST(Opening, ADatabaseOfAnotherProgramIsRefused) {
  const support::Scratch scratch;
  const auto file = scratch.path() / "other.db";
  std::ofstream(file).close();
  Database(file, Database::Access::read_write).run("CREATE TABLE song (title TEXT)");
  EXPECT_TRUE(says(refusal_of(file), "another program"));
}

TEST(Opening, ANewerVersionIsRefused) {
  SqliteShelf shelf;
  shelf.close();
  const std::string newer = "PRAGMA user_version = " + std::to_string(schema_version + 1);
  Database(shelf.file(), Database::Access::read_write).run(newer.c_str());
  EXPECT_TRUE(says(refusal_of(shelf.file()), "run a newer server"));
}

TEST(Opening, AVersionThatNeverWasIsRefused) {
  SqliteShelf shelf;
  shelf.close();
  Database(shelf.file(), Database::Access::read_write).run("PRAGMA user_version = 0");
  EXPECT_TRUE(says(refusal_of(shelf.file()), "never was"));
}

/// Fills a store with guests and overwrites part of them.
void damage(SqliteShelf& shelf) {
  for (std::uint8_t i = 0; i < 200; ++i) {
    ASSERT_FALSE(shelf.put({ledger::PutGuest{{guest(i), "Ada"}}}));
  }
  shelf.close();
  std::fstream file(shelf.file(), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(4096 + 8);
  file << std::string(3000, '\x55');
}

TEST(Opening, ADamagedFileIsRefused) {
  SqliteShelf shelf;
  damage(shelf);
  EXPECT_TRUE(says(refusal_of(shelf.file()), "damaged") ||
              says(refusal_of(shelf.file()), "malformed"));
}

TEST(Opening, AFileIsSearchedForDamageUpToASize) {
  SqliteShelf shelf;
  damage(shelf);
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(shelf.file()));
  EXPECT_THROW(prepare_file(shelf.file(), size), StoreError);
  EXPECT_NO_THROW(prepare_file(shelf.file(), size - 1));
}

TEST(Opening, AFolderThatThereIsNotIsNamed) {
  const support::Scratch scratch;
  EXPECT_TRUE(says(refusal_of(scratch.path() / "none" / "matches.db"), "No such file"));
}

TEST(Opening, AFileInUseByAnotherServerIsRefused) {
  SqliteShelf shelf;
  EXPECT_TRUE(says(refusal_of(shelf.file()), "another server"));
  shelf.close();
  EXPECT_EQ(refusal_of(shelf.file()), "opened");
}

TEST(Opening, OnlyTheTableOfSecretsHoldsASecret) {
  SqliteShelf shelf;
  const Story begun = story(1, 2, false);
  for (const ledger::Batch& batch : begun.batches) ASSERT_FALSE(shelf.put(batch));
  shelf.close();
  Database database(shelf.file(), Database::Access::read_write);
  const auto holds = [&] {
    database.run("PRAGMA wal_checkpoint(TRUNCATE)");
    std::ifstream read(shelf.file(), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(read), {});
    return bytes.find(std::string(begun.secret.begin(), begun.secret.end())) != std::string::npos;
  };
  EXPECT_TRUE(holds());
  database.run("PRAGMA secure_delete = ON");
  database.run("DELETE FROM secret");
  EXPECT_FALSE(holds());
}

// ---- Failures of the world

/// While it lives no file of this process grows beyond so many bytes: a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    before_signal_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, before_signal_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*before_signal_)(int);
};

TEST(Failure, AFullDiskIsReportedAndTheStoreGoesOnWhenThereIsRoom) {
  SqliteShelf shelf;
  const Story whole = story(1, 60, true);
  std::size_t stored = 0;
  {
    const FullDisk full(std::filesystem::file_size(shelf.file().string() + "-wal") + 100'000);
    while (stored < whole.batches.size() && !shelf.put(whole.batches[stored])) ++stored;
    ASSERT_LT(stored, whole.batches.size()) << "the disk was never full";
    EXPECT_TRUE(shelf.put(whole.batches[stored])) << "and it stays full";
    const auto next = shelf.row(whole.row.id)->progress.next;
    EXPECT_EQ(static_cast<std::size_t>(next) + 1, stored) << "what is stored can be read";
  }
  while (stored < whole.batches.size()) ASSERT_FALSE(shelf.put(whole.batches[stored++]));
  shelf.reopen();
  EXPECT_EQ(shelf.row(whole.row.id), whole.row);
}

TEST(Failure, AnEntryThatIsDamagedIsNotGiven) {
  SqliteShelf shelf;
  const Story begun = story(1, 3, false);
  for (const ledger::Batch& batch : begun.batches) ASSERT_FALSE(shelf.put(batch));
  shelf.close();
  Database(shelf.file(), Database::Access::read_write)
      .run("UPDATE entry SET bytes = x'00112233' WHERE seq = 2");
  shelf.reopen();
  const auto restored = shelf.restored();
  ASSERT_EQ(restored.size(), 1u);
  EXPECT_TRUE(says(std::get<ledger::DamagedMatch>(restored[0]).what, "an entry is damaged"));
  const auto report = shelf.ask(ledger::FindEntries{begun.row.id, match::Seq{2}, 1});
  EXPECT_TRUE(says(std::get<ledger::LoadFailed>(report).why, "an entry is damaged"));
  EXPECT_EQ(
      shelf.find<ledger::FoundEntries>(ledger::FindEntries{begun.row.id, {}, 1}).entries.size(),
      1u);
}

TEST(Failure, ARowThatNoServerHasWrittenIsNotGiven) {
  for (const char* spoil :
       {"UPDATE match SET stage = 1, score = 'two'", "UPDATE match SET winner = 300",
        "UPDATE match SET settings = x'00'", "UPDATE match SET header = x'00'",
        "UPDATE match SET next = -1", "DELETE FROM secret", "UPDATE seat SET seat = 5"}) {
    SqliteShelf shelf;
    const Story begun = story(1, 0, false);
    for (const ledger::Batch& batch : begun.batches) ASSERT_FALSE(shelf.put(batch));
    shelf.close();
    Database(shelf.file(), Database::Access::read_write).run(spoil);
    shelf.reopen();
    const auto restored = shelf.restored();
    ASSERT_EQ(restored.size(), 1u) << spoil;
    EXPECT_TRUE(std::holds_alternative<ledger::DamagedMatch>(restored[0])) << spoil;
  }
}

TEST(Failure, WhatIsNoRecordFailsAloneInItsGroup) {
  SqliteShelf shelf;
  ledger::MatchRow row = open_match(1);
  row.settings.preset.assign(100'000, 'x');  // beyond the record's limit: it cannot be encoded
  EXPECT_TRUE(shelf.put({ledger::CreateMatch{row, secret(1)}}));
  EXPECT_FALSE(shelf.put({ledger::CreateMatch{open_match(1), secret(1)}}));
}

TEST(Failure, ClosingCarriesOutWhatWasOrderedBefore) {
  SqliteShelf shelf;
  for (std::uint8_t i = 0; i < 50; ++i) shelf.append({ledger::PutGuest{{guest(i), "Ada"}}});
  shelf.reopen();
  for (std::uint8_t i = 0; i < 50; ++i) {
    EXPECT_TRUE(shelf.find<ledger::FoundGuest>(ledger::FindGuest{guest(i)}).guest);
  }
}

/// Stores entries of a match and writes a byte to the pipe for each one reported, until killed.
[[noreturn]] void store_until_killed(const std::filesystem::path& file, const Story& whole,
                                     int pipe) {
  const auto store = open_sqlite(file, [&](const ledger::Report& report) {
    if (!std::holds_alternative<ledger::Stored>(report)) std::_Exit(1);
    const char byte = 1;
    if (::write(pipe, &byte, 1) != 1) std::_Exit(1);
  });
  std::uint64_t ticket = 0;
  for (const ledger::Batch& batch : whole.batches) store->append(ledger::Ticket{++ticket}, batch);
  while (true) ::pause();
}

TEST(Failure, WhatWasReportedSurvivesAKill) {
  const Story whole = story(1, 300, true);
  for (const std::size_t reports_before_kill : {1u, 3u, 40u, 150u}) {
    const support::Scratch scratch;
    const auto file = scratch.path() / "matches.db";
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) store_until_killed(file, whole, ends[1]);
    ::close(ends[1]);
    std::size_t reported = 0;
    char bytes[64];
    while (reported < reports_before_kill) {
      const ssize_t got = ::read(ends[0], bytes, sizeof bytes);
      ASSERT_GT(got, 0);
      reported += static_cast<std::size_t>(got);
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ssize_t late = 0;
    while ((late = ::read(ends[0], bytes, sizeof bytes)) > 0) {
      reported += static_cast<std::size_t>(late);
    }
    ::close(ends[0]);
    // The first batch creates the match, the second holds the first entry.
    Reports reports;
    const auto store = open_sqlite(file, reports.reporter());
    store->load(ledger::Ticket{1}, ledger::FindEntries{whole.row.id, {}, std::size_t{1} << 30});
    const auto report = reports.wait_for(1).front();
    const auto entries =
        std::get<ledger::FoundEntries>(std::get<ledger::Loaded>(report).found).entries;
    EXPECT_GE(entries.size() + 1, reported);
    for (std::size_t i = 0; i < entries.size(); ++i) EXPECT_EQ(*entries[i], *whole.entries[i]);
  }
}

}  // namespace
}  // namespace breakshot::store
