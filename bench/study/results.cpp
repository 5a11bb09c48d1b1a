#include "bench/study/results.hpp"

#include <algorithm>
#include <cmath>

#include "common/study/compare.hpp"

namespace breakshot::bench {
namespace {

/// Medians of fewer balls say nothing.
constexpr double fewest_balls = 8;
/// From fewer contacts than these no growth can be taken.
constexpr std::size_t fewest_steps = 3;
/// Where more balls than this have met something else, what is left is no sample.
constexpr double most_wrong = 0.25;

std::vector<Row> once(const TableFile& file, const std::string& set,
                      const std::vector<std::string>& key) {
  std::vector<Row> rows;
  for (const Row& row : file.rows()) {
    if (row.at("set") != set) continue;
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& other) {
      return std::all_of(key.begin(), key.end(),
                         [&](const std::string& name) { return row.at(name) == other.at(name); });
    });
    if (same == rows.end()) {
      rows.push_back(row);
    } else if (std::stoul(row.at("shots")) >= std::stoul(same->at("shots"))) {
      *same = row;
    }
  }
  return rows;
}

}  // namespace

std::optional<double> number_in(const Row& row, const std::string& column) {
  const std::string& cell = row.at(column);
  return cell.empty() ? std::nullopt : std::optional(std::stod(cell));
}

std::vector<Row> points_of(const StudyFiles& files, const std::string& set) {
  std::vector<Row> rows = once(files.points, set, {"method", "scalar", "step_s"});
  // Long steps first: a curve goes from cheap to dear.
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    const bool curve = a.at("method") == b.at("method") && a.at("scalar") == b.at("scalar");
    const auto step = [](const Row& r) {
      return r.at("step_s") == "-" ? 1e9 : std::stod(r.at("step_s"));
    };
    return curve                              ? step(a) > step(b)
           : a.at("method") == b.at("method") ? false
                                              : a.at("method") < b.at("method");
  });
  return rows;
}

std::vector<Row> needs_of(const StudyFiles& files, const std::string& set) {
  return once(files.needs, set, {"phenomenon", "choice"});
}

std::string name_of(const Row& point) {
  if (point.at("method") == "exact") return "exact " + point.at("scalar");
  if (point.at("step_s") == "-") return point.at("method") + ", one frame";
  return point.at("method") + " " + point.at("step_s");
}

const Row* errors_of(const StudyFiles& files, const Row& point, const std::string& contacts) {
  return files.errors.find({{"set", point.at("set")},
                            {"method", point.at("method")},
                            {"scalar", point.at("scalar")},
                            {"step_s", point.at("step_s")},
                            {"shots", point.at("shots")},
                            {"contacts", contacts}});
}

std::optional<double> position_error(const StudyFiles& files, const Row& point,
                                     const std::string& contacts) {
  const Row* errors = errors_of(files, point, contacts);
  return errors == nullptr ? std::nullopt : number_in(*errors, "position_m");
}

std::optional<Growth> growth_of(const StudyFiles& files, const Row& point) {
  Growth growth;
  double last_m = 0;
  for (std::size_t k = 1; k <= study::most_contacts; ++k) {
    const Row* errors = errors_of(files, point, std::to_string(k));
    if (errors == nullptr || number_in(*errors, "balls").value_or(0) < fewest_balls) break;
    const auto error_m = number_in(*errors, "position_m");
    if (number_in(*errors, "wrong").value_or(1) > most_wrong || !error_m) break;
    if (*error_m == 0) continue;
    if (growth.from == 0) growth = {k, k, *error_m, 0};
    last_m = *error_m;
    growth.to = k;
  }
  if (growth.to < growth.from + fewest_steps) return std::nullopt;
  growth.factor =
      std::pow(last_m / growth.first_m, 1 / static_cast<double>(growth.to - growth.from));
  return growth;
}

}  // namespace breakshot::bench
