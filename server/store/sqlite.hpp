// SQLite with owners: a database and its statements close themselves, and failures are exceptions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace breakshot::store {

/// A call of SQLite's has failed: its own words, and its extended result code.
class SqliteError : public std::runtime_error {
 public:
  SqliteError(const std::string& what, int code);
  int code() const { return code_; }

 private:
  int code_;
};

class Statement;

class Database {
 public:
  enum class Access { read_write, read_only };

  /// The file must exist.
  Database(const std::filesystem::path& file, Access access);
  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&&) = delete;

  /// Runs statements that have neither parameters nor results.
  void run(const char* sql);
  Statement prepare(std::string_view sql);
  std::int64_t number(std::string_view sql);  ///< the first column of the first row

  /// Whether no transaction is open. SQLite itself ends one on some errors (a full disk).
  bool idle() const;
  /// Rows that the last statement has changed.
  int changes() const;

 private:
  sqlite3* handle_ = nullptr;
};

/// A prepared statement, usable again after `reset`. Parameters and columns count from 0.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql);
  ~Statement();
  Statement(Statement&& other) noexcept;
  Statement& operator=(Statement&&) = delete;

  using Blob = std::span<const std::uint8_t>;

  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, std::string_view text);
  Statement& bind(int parameter, Blob bytes);
  Statement& bind_null(int parameter);
  template <class Value>
  Statement& bind_optional(int parameter, const std::optional<Value>& value) {
    return value ? bind(parameter, *value) : bind_null(parameter);
  }

  /// Goes on to the next row; whether there is one.
  bool step();
  /// Runs to the end a statement without results, and makes it ready to run again.
  void run();
  void reset();

  bool is_null(int column) const;
  std::int64_t number(int column) const;
  std::string text(int column) const;
  /// Valid until the next step or reset.
  Blob blob(int column) const;

 private:
  void check(int result) const;

  sqlite3* database_;
  sqlite3_stmt* handle_ = nullptr;
};

}  // namespace breakshot::store
