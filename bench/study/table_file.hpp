// Comma-separated files with a heading, to which rows are added one at a time, so that a study that
// was stopped goes on where it was.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace breakshot::bench {

using Row = std::map<std::string, std::string>;

class TableFile {
 public:
  /// Reads the file if it is there. One with another heading is not ours to add to: an exception.
  TableFile(std::string path, std::vector<std::string> columns);

  const std::vector<Row>& rows() const { return rows_; }
  /// The last row in which all of `values` stand, or none.
  const Row* find(const Row& values) const;
  /// Adds a row, in the file too. What it does not name is empty.
  void add(const Row& row);

 private:
  std::string path_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

/// A number as a file shows it: seven digits.
std::string shown(double value);

}  // namespace breakshot::bench
