// Values as columns and back. Reading throws std::runtime_error at what no server has written.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "server/ledger/ledger.hpp"
#include "server/store/sqlite.hpp"

namespace breakshot::store {

/// Ids are unsigned, SQLite's integers are not: flipping the highest bit keeps the order.
inline std::int64_t column_of(match::MatchId id) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(id) ^ (std::uint64_t{1} << 63));
}
inline match::MatchId id_in(std::int64_t column) {
  return match::MatchId{static_cast<std::uint64_t>(column) ^ (std::uint64_t{1} << 63)};
}

inline std::int64_t column_of(match::Seq seq) {
  return static_cast<std::int64_t>(seq);
}

/// Racks won by seat: "2 1".
std::string column_of(const std::vector<std::uint32_t>& score);
std::vector<std::uint32_t> score_in(const std::string& column);

/// An enumeration whose last value is `last`, or a small number.
template <class Value>
Value value_in(const Statement& row, int column, Value last) {
  const std::int64_t number = row.number(column);
  if (number < 0 || number > static_cast<std::int64_t>(last)) {
    throw std::runtime_error("column " + std::to_string(column) + " holds " +
                             std::to_string(number));
  }
  return static_cast<Value>(number);
}

template <std::size_t N>
std::array<std::uint8_t, N> bytes_in(const Statement& row, int column) {
  const Statement::Blob blob = row.blob(column);
  if (blob.size() != N) throw std::runtime_error("a blob has the wrong size");
  std::array<std::uint8_t, N> bytes{};
  std::copy(blob.begin(), blob.end(), bytes.begin());
  return bytes;
}

/// What was decoded, unless it is damaged.
template <class Value>
Value sound(std::variant<Value, record::Damage> decoded, const char* what) {
  if (const auto* damage = std::get_if<record::Damage>(&decoded)) {
    throw std::runtime_error(std::string(what) + " is damaged at byte " +
                             std::to_string(damage->offset) + ": " + damage->what);
  }
  return std::get<Value>(std::move(decoded));
}

}  // namespace breakshot::store
