// What the CSV files say of one set and one way to simulate it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/study/measure.hpp"

namespace breakshot::bench {

/// A cell as a number, if there is one.
std::optional<double> number_in(const Row& row, const std::string& column);

/// The rows of one set in points.csv, each way once: of the most shots, in the order of the file.
std::vector<Row> points_of(const StudyFiles& files, const std::string& set);
/// The same of requires.csv.
std::vector<Row> needs_of(const StudyFiles& files, const std::string& set);

/// The point `point` belongs to, "fixed 1e-3" or "exact double".
std::string name_of(const Row& point);

/// The row of errors.csv of a point, after so many contacts ("1" to "12", "end"); null if none.
const Row* errors_of(const StudyFiles& files, const Row& point, const std::string& contacts);

/// The median distance from the place of the contact in the reference, m.
std::optional<double> position_error(const StudyFiles& files, const Row& point,
                                     const std::string& contacts);

/// How errors grow from one contact to the next.
struct Growth {
  std::size_t from = 0;  ///< the first contact at which any error is left of rounding
  std::size_t to = 0;    ///< the last at which most balls have met the right things
  double first_m = 0;    ///< at `from`
  double factor = 0;     ///< for each further one
};

/// None if there are not enough such contacts.
std::optional<Growth> growth_of(const StudyFiles& files, const Row& point);

}  // namespace breakshot::bench
