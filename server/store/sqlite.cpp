#include "server/store/sqlite.hpp"

#include <sqlite3.h>

#include <utility>

#include "server/store/limits.hpp"

namespace breakshot::store {
namespace {

[[noreturn]] void fail(sqlite3* database, int result) {
  const std::string what = database ? sqlite3_errmsg(database) : sqlite3_errstr(result);
  throw SqliteError(what, database ? sqlite3_extended_errcode(database) : result);
}

}  // namespace

SqliteError::SqliteError(const std::string& what, int code)
    : std::runtime_error(what), code_(code) {}

Database::Database(const std::filesystem::path& file, Access access) {
  const int flags = access == Access::read_write ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY;
  const int result = sqlite3_open_v2(file.c_str(), &handle_, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  if (result != SQLITE_OK) {
    const std::string what = handle_ ? sqlite3_errmsg(handle_) : sqlite3_errstr(result);
    sqlite3_close(handle_);
    throw SqliteError(what, result);
  }
  sqlite3_extended_result_codes(handle_, 1);
  sqlite3_busy_timeout(handle_, busy_timeout_ms);
}

Database::~Database() {
  sqlite3_close(handle_);
}

Database::Database(Database&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}

void Database::run(const char* sql) {
  const int result = sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr);
  if (result != SQLITE_OK) fail(handle_, result);
}

Statement Database::prepare(std::string_view sql) {
  return {handle_, sql};
}

std::int64_t Database::number(std::string_view sql) {
  Statement statement = prepare(sql);
  statement.step();
  return statement.number(0);
}

bool Database::idle() const {
  return sqlite3_get_autocommit(handle_) != 0;
}

int Database::changes() const {
  return sqlite3_changes(handle_);
}

Statement::Statement(sqlite3* database, std::string_view sql) : database_(database) {
  check(sqlite3_prepare_v3(database, sql.data(), static_cast<int>(sql.size()),
                           SQLITE_PREPARE_PERSISTENT, &handle_, nullptr));
}

Statement::~Statement() {
  sqlite3_finalize(handle_);
}

Statement::Statement(Statement&& other) noexcept
    : database_(other.database_), handle_(std::exchange(other.handle_, nullptr)) {}

Statement& Statement::bind(int parameter, std::int64_t value) {
  check(sqlite3_bind_int64(handle_, parameter + 1, value));
  return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
  check(sqlite3_bind_text(handle_, parameter + 1, text.data(), static_cast<int>(text.size()),
                          SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind(int parameter, Blob bytes) {
  check(sqlite3_bind_blob64(handle_, parameter + 1, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
  return *this;
}

Statement& Statement::bind_null(int parameter) {
  check(sqlite3_bind_null(handle_, parameter + 1));
  return *this;
}

bool Statement::step() {
  const int result = sqlite3_step(handle_);
  if (result == SQLITE_ROW) return true;
  if (result == SQLITE_DONE) return false;
  // The message is the statement's; resetting it afterwards lets it run again.
  const SqliteError error(sqlite3_errmsg(database_), result);
  sqlite3_reset(handle_);
  throw error;
}

void Statement::run() {
  while (step()) {
  }
  reset();
}

void Statement::reset() {
  sqlite3_reset(handle_);
  sqlite3_clear_bindings(handle_);
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(handle_, column) == SQLITE_NULL;
}

std::int64_t Statement::number(int column) const {
  return sqlite3_column_int64(handle_, column);
}

std::string Statement::text(int column) const {
  const Blob bytes = blob(column);
  return {bytes.begin(), bytes.end()};
}

Statement::Blob Statement::blob(int column) const {
  const auto* bytes = static_cast<const std::uint8_t*>(sqlite3_column_blob(handle_, column));
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column))};
}

void Statement::check(int result) const {
  if (result != SQLITE_OK) fail(database_, result);
}

}  // namespace breakshot::store
