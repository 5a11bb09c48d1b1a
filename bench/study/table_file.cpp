#include "bench/study/table_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <stdexcept>

namespace breakshot::bench {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    cells.push_back(line.substr(start, end - start));
    start = end + 1;
  }
  return cells;
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + cell;
  return line;
}

}  // namespace

TableFile::TableFile(std::string path, std::vector<std::string> columns)
    : path_(std::move(path)), columns_(std::move(columns)) {
  std::ifstream file(path_);
  std::string line;
  if (!std::getline(file, line)) {
    std::ofstream(path_) << line_of(columns_) << '\n';
    return;
  }
  if (line != line_of(columns_)) throw std::runtime_error(path_ + ": is of another study");
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != columns_.size()) throw std::runtime_error(path_ + ": damaged: " + line);
    Row row;
    for (std::size_t i = 0; i < cells.size(); ++i) row[columns_[i]] = cells[i];
    rows_.push_back(std::move(row));
  }
}

const Row* TableFile::find(const Row& values) const {
  const auto found = std::find_if(rows_.rbegin(), rows_.rend(), [&](const Row& row) {
    return std::all_of(values.begin(), values.end(),
                       [&](const auto& value) { return row.at(value.first) == value.second; });
  });
  return found == rows_.rend() ? nullptr : &*found;
}

void TableFile::add(const Row& row) {
  Row whole;
  std::vector<std::string> cells;
  for (const std::string& column : columns_) {
    const auto cell = row.find(column);
    whole[column] = cell == row.end() ? "" : cell->second;
    cells.push_back(whole[column]);
  }
  std::ofstream(path_, std::ios::app) << line_of(cells) << '\n';
  rows_.push_back(std::move(whole));
}

std::string shown(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 7);
  return {text.data(), end.ptr};
}

}  // namespace breakshot::bench
