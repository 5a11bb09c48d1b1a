#include "server/store/columns.hpp"

#include <charconv>

namespace breakshot::store {

std::string column_of(const std::vector<std::uint32_t>& score) {
  std::string column;
  for (const std::uint32_t racks : score) {
    if (!column.empty()) column += ' ';
    column += std::to_string(racks);
  }
  return column;
}

std::vector<std::uint32_t> score_in(const std::string& column) {
  std::vector<std::uint32_t> score;
  const char* at = column.data();
  const char* const end = at + column.size();
  while (at != end) {
    std::uint32_t racks = 0;
    const auto [next, error] = std::from_chars(at, end, racks);
    if (error != std::errc{} || (next != end && *next != ' ')) {
      throw std::runtime_error("a score reads \"" + column + "\"");
    }
    score.push_back(racks);
    at = next == end ? end : next + 1;
  }
  return score;
}

}  // namespace breakshot::store
