#include "server/store/schema.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "server/store/store.hpp"

namespace breakshot::store {
namespace {

// Ids are shifted by 2^63 so that the order of SQLite's signed integers is theirs (rows.cpp).
//
// The secret of a match has a table of its own, which no query for anyone's eyes touches: only
// restoring reads it. A free seat has no row.
constexpr const char* tables = R"sql(
CREATE TABLE guest (
  token_hash BLOB PRIMARY KEY CHECK (length(token_hash) = 32),
  name TEXT NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE match (
  id INTEGER PRIMARY KEY,
  settings BLOB NOT NULL,
  commitment BLOB NOT NULL CHECK (length(commitment) = 32),
  created_unix_ms INTEGER NOT NULL,
  code TEXT UNIQUE,
  header BLOB,
  stage INTEGER NOT NULL,
  next INTEGER NOT NULL,
  score TEXT NOT NULL,
  winner INTEGER,
  ending INTEGER
) STRICT;
CREATE INDEX match_by_stage ON match (stage, created_unix_ms DESC, id DESC);

CREATE TABLE secret (
  match INTEGER PRIMARY KEY REFERENCES match (id) ON DELETE CASCADE,
  secret BLOB NOT NULL CHECK (length(secret) = 32)
) STRICT;

CREATE TABLE seat (
  match INTEGER NOT NULL REFERENCES match (id) ON DELETE CASCADE,
  seat INTEGER NOT NULL,
  guest BLOB NOT NULL CHECK (length(guest) = 32),
  name TEXT NOT NULL,
  contribution BLOB CHECK (length(contribution) = 32),
  PRIMARY KEY (match, seat)
) STRICT, WITHOUT ROWID;
CREATE INDEX seat_by_guest ON seat (guest);

CREATE TABLE entry (
  match INTEGER NOT NULL REFERENCES match (id),
  seq INTEGER NOT NULL,
  bytes BLOB NOT NULL,
  UNIQUE (match, seq)
) STRICT;
)sql";

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw StoreError(file.string() + ": " + what);
}

/// Creates the file if there is none, for its owner alone: it holds secrets and invite codes. The
/// files that SQLite puts beside it take over the permissions.
void create_file(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) {
    refuse(file, std::string("cannot be opened for writing: ") + std::strerror(errno));
  }
  ::close(descriptor);
}

/// A file that is not empty must be ours.
void check_identity(const std::filesystem::path& file, Database& database) {
  if (database.number("PRAGMA application_id") != application_id) {
    refuse(file, "is a database of another program; choose another file");
  }
  const std::int64_t version = database.number("PRAGMA user_version");
  if (version > schema_version) {
    refuse(file, "has version " + std::to_string(version) +
                     " of the tables, this server knows up to " + std::to_string(schema_version) +
                     "; run a newer server");
  }
  if (version < schema_version) {
    refuse(file, "has version " + std::to_string(version) + " of the tables, which never was one");
  }
}

void check_integrity(const std::filesystem::path& file, Database& database,
                     std::int64_t checked_bytes) {
  const std::int64_t size =
      database.number("PRAGMA page_count") * database.number("PRAGMA page_size");
  if (size > checked_bytes) return;
  Statement check = database.prepare("PRAGMA quick_check(1)");
  const std::string found = check.step() ? check.text(0) : "no answer";
  if (found != "ok") {
    refuse(file,
           "is damaged (" + found + "); restore a copy or recover it with sqlite3's .recover");
  }
}

void make_durable(Database& database) {
  database.run("PRAGMA journal_mode = WAL");
  database.run("PRAGMA synchronous = FULL");
  database.run("PRAGMA foreign_keys = ON");
}

void create_tables(Database& database) {
  database.run("BEGIN IMMEDIATE");
  database.run(tables);
  database.run(("PRAGMA application_id = " + std::to_string(application_id)).c_str());
  database.run(("PRAGMA user_version = " + std::to_string(schema_version)).c_str());
  database.run("COMMIT");
}

}  // namespace

Database open_to_write(const std::filesystem::path& file) {
  Database database(file, Database::Access::read_write);
  make_durable(database);
  return database;
}

void prepare_file(const std::filesystem::path& file, std::int64_t checked_bytes) {
  create_file(file);
  try {
    Database database(file, Database::Access::read_write);
    const bool empty = database.number("SELECT count(*) FROM sqlite_schema") == 0 &&
                       database.number("PRAGMA application_id") == 0 &&
                       database.number("PRAGMA user_version") == 0;
    if (!empty) check_identity(file, database);
    make_durable(database);
    if (empty) create_tables(database);
    check_integrity(file, database, checked_bytes);
  } catch (const SqliteError& error) {
    refuse(file, std::string("cannot be used as the server's database: ") + error.what());
  }
}

}  // namespace breakshot::store
