// Runs the study and keeps what it finds in CSV files: points.csv has a row for each set and way to
// simulate it, errors.csv its errors by the number of contacts, requires.csv the full model with
// phenomena left out, engines.csv a plain break by an engine that has them and by one that has not.
// determinism.csv is not measured here: tests/golden/portable/compare leaves it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/study/table_file.hpp"

namespace breakshot::bench {

struct StudyFiles {
  explicit StudyFiles(const std::string& directory);

  TableFile points;
  TableFile errors;
  TableFile needs;
  TableFile engines;
  TableFile determinism;
};

struct StudyOptions {
  bool full = false;
  std::string folder;  ///< of this program, and of others that count instructions
  /// Called before each row with how many are done, of how many, and what comes next.
  std::function<void(std::size_t done, std::size_t all, const std::string& next)> progress;
};

/// Measures what is missing in the files.
void measure(StudyFiles& files, const StudyOptions& options);

/// What `measure` has counted: simulates `shots` shots of a set and nothing else. `words` are a set
/// and a point, or a set and the number of a variation.
void simulate_only(const std::vector<std::string>& words, std::size_t shots);

}  // namespace breakshot::bench
