#include "bench/study/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include "bench/study/results.hpp"
#include "bench/study/sets.hpp"
#include "common/physics/ball.hpp"

namespace breakshot::bench {
namespace {

/// Near enough for a gas, m.
constexpr double near_enough_m = 1e-3;
/// A way to simulate is good enough for a set if so many outcomes agree.
constexpr double good_share = 0.95;

using Cells = std::vector<std::string>;

/// A table of Markdown.
class Table {
 public:
  explicit Table(const Cells& heading) {
    add(heading);
    text_ += "|---";
    for (std::size_t i = 1; i < heading.size(); ++i) text_ += "|---:";
    text_ += "|\n";
  }
  void add(const Cells& cells) {
    for (const std::string& cell : cells) text_ += "| " + cell + " ";
    text_ += "|\n";
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string rounded(double value, int digits) {
  if (value == 0) return "0";
  const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
  return shown(std::round(value * scale) / scale);
}

std::string cell(const std::optional<double>& value, int digits = 2) {
  return value ? rounded(*value, digits) : "";
}

std::string percent(const std::optional<double>& share) {
  return share ? shown(std::round(*share * 100)) + " %" : "";
}

/// 1234567 as 1,234,567.
std::string grouped(const std::optional<double>& value) {
  if (!value) return "";
  std::string digits = std::to_string(std::llround(*value));
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), ",");
  }
  return digits;
}

std::string micros(const Row& row) {
  const double us = number_in(row, "cpu_us").value_or(0);
  return us < 100 ? rounded(us, 2) : grouped(us);
}

const Row* point_named(const std::vector<Row>& points, const std::string& name) {
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const Row& point) { return name_of(point) == name; });
  return found == points.end() ? nullptr : &*found;
}

std::string sets_table(const StudyFiles& files) {
  Table table({"set", "what", "shots", "events a shot", "µs a shot", "instructions a shot",
               "instructions an event"});
  for (const Set& set : sets()) {
    const auto points = points_of(files, std::string(set.name));
    const Row* exact = point_named(points, "exact double");
    if (exact == nullptr) continue;
    const auto instructions = number_in(*exact, "instructions");
    const auto events = number_in(*exact, "events");
    table.add({"`" + std::string(set.name) + "`", std::string(set.what), exact->at("shots"),
               cell(events, 4), micros(*exact), grouped(instructions),
               instructions && events ? grouped(*instructions / *events) : ""});
  }
  return table.text();
}

std::string machine(const StudyFiles& files) {
  if (files.points.rows().empty()) return "";
  return files.points.rows().back().at("processor") +
         ", one core; a build of the `release` preset.\n";
}

std::string methods_table(const StudyFiles& files, const std::string& set) {
  Table table({"method", "µs", "instructions", "position after 1, m", "after 2", "after 5",
               "after 10", "wrong after 2", "after 5", "overlap, m", "energy", "outcome"});
  for (const Row& point : points_of(files, set)) {
    const auto wrong = [&](const char* contacts) {
      const Row* errors = errors_of(files, point, contacts);
      return errors == nullptr ? std::nullopt : number_in(*errors, "wrong");
    };
    Cells cells = {name_of(point), micros(point), grouped(number_in(point, "instructions"))};
    for (const char* contacts : {"1", "2", "5", "10"}) {
      cells.push_back(cell(position_error(files, point, contacts)));
    }
    cells.push_back(percent(wrong("2")));
    cells.push_back(percent(wrong("5")));
    cells.push_back(cell(number_in(point, "overlap_m")));
    cells.push_back(cell(number_in(point, "energy")));
    cells.push_back(percent(number_in(point, "outcome")));
    table.add(cells);
  }
  return table.text();
}

/// Sets in which something is pocketed or not; gases have no outcome.
const std::vector<std::string>& played_sets() {
  static const std::vector<std::string> names = {"break",  "break_full", "rack", "cut",
                                                 "safety", "kick",       "push"};
  return names;
}

std::string agreement_table(const StudyFiles& files) {
  Cells heading = {"method"};
  std::vector<std::string> names;
  std::map<std::string, std::vector<Row>> points;
  for (const std::string& set : played_sets()) {
    heading.push_back("`" + set + "`");
    points[set] = points_of(files, set);
    for (const Row& point : points[set]) {
      const std::string name = name_of(point);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  Table table(heading);
  for (const std::string& name : names) {
    Cells cells = {name};
    for (const std::string& set : played_sets()) {
      const Row* point = point_named(points[set], name);
      cells.push_back(point == nullptr ? "" : percent(number_in(*point, "outcome")));
    }
    table.add(cells);
  }
  return table.text();
}

std::string growth_table(const StudyFiles& files) {
  Table table({"set", "number type", "contacts", "error after the first of them, m",
               "growth a contact", "contacts until it is a ball's radius"});
  for (const Set& set : sets()) {
    for (const Row& point : points_of(files, std::string(set.name))) {
      const auto growth = growth_of(files, point);
      if (point.at("method") != "exact" || point.at("scalar") == "reference" || !growth) continue;
      std::string promised = "any";
      if (growth->factor > 1) {
        const double steps =
            std::log(physics::BallKind{}.radius_m / growth->first_m) / std::log(growth->factor);
        promised = shown(static_cast<double>(growth->from) + std::floor(steps));
      }
      table.add({"`" + std::string(set.name) + "`", point.at("scalar"),
                 std::to_string(growth->from) + " to " + std::to_string(growth->to),
                 cell(growth->first_m), cell(growth->factor), promised});
    }
  }
  return table.text();
}

/// Whether a way to simulate is good enough: by outcomes, or where there are none by the place of
/// the second contact.
bool good(const StudyFiles& files, const Row& point, bool played) {
  if (played) return number_in(point, "outcome").value_or(0) >= good_share;
  const Row* errors = errors_of(files, point, "2");
  return errors != nullptr && number_in(*errors, "wrong").value_or(1) <= 1 - good_share &&
         number_in(*errors, "position_m").value_or(1) <= near_enough_m;
}

const Row* cheapest(const StudyFiles& files, const std::vector<Row>& points, bool played,
                    const std::function<bool(const Row&)>& among) {
  const Row* best = nullptr;
  for (const Row& point : points) {
    if (!among(point) || !good(files, point, played)) continue;
    if (best == nullptr || *number_in(point, "cpu_us") < *number_in(*best, "cpu_us")) best = &point;
  }
  return best;
}

std::string winners_table(const StudyFiles& files) {
  Table table({"set", "exact double, µs", "cheapest step that is good enough", "µs",
               "times the cost of exact"});
  for (const Set& set : sets()) {
    const std::string name(set.name);
    const auto points = points_of(files, name);
    const bool played =
        std::find(played_sets().begin(), played_sets().end(), name) != played_sets().end();
    const Row* exact = point_named(points, "exact double");
    if (exact == nullptr) continue;
    const Row* step = cheapest(files, points, played,
                               [](const Row& point) { return point.at("method") != "exact"; });
    if (step == nullptr) {
      table.add({"`" + name + "`", micros(*exact), "none of those tried", "", ""});
      continue;
    }
    table.add({"`" + name + "`", micros(*exact), name_of(*step), micros(*step),
               rounded(*number_in(*step, "cpu_us") / *number_in(*exact, "cpu_us"), 2)});
  }
  return table.text();
}

std::string needs_table(const StudyFiles& files) {
  const std::vector<std::string> varied = {"break_full", "cut", "safety", "kick"};
  Cells heading = {"phenomenon", "instead"};
  std::map<std::string, std::vector<Row>> rows;
  for (const std::string& set : varied) {
    rows[set] = needs_of(files, set);
    heading.push_back("instructions, `" + set + "`");
  }
  for (const std::string& set : varied) heading.push_back("agrees, `" + set + "`");
  Table table(heading);
  for (std::size_t i = 0; i < rows["break_full"].size(); ++i) {
    const Row& row = rows["break_full"][i];
    Cells cells = {row.at("phenomenon"), row.at("choice")};
    Cells agreements;
    for (const std::string& set : varied) {
      if (i >= rows[set].size()) return table.text();
      cells.push_back(grouped(number_in(rows[set][i], "instructions")));
      agreements.push_back(percent(number_in(rows[set][i], "outcome")));
    }
    cells.insert(cells.end(), agreements.begin(), agreements.end());
    table.add(cells);
  }
  return table.text();
}

std::string engines_table(const StudyFiles& files) {
  Table table({"engine", "instructions a break"});
  for (const Row& row : files.engines.rows()) {
    table.add({row.at("engine"), grouped(number_in(row, "instructions"))});
  }
  return table.text();
}

std::string determinism_table(const StudyFiles& files) {
  Table table({"build", "how", "other lines", "of", "built, s", "ran, s"});
  for (const Row& row : files.determinism.rows()) {
    table.add({row.at("build"), row.at("how"), row.at("differ"), row.at("lines"), row.at("built_s"),
               row.at("ran_s")});
  }
  return table.text();
}

std::string table_named(const std::string& name, const StudyFiles& files) {
  if (name == "machine") return machine(files);
  if (name == "sets") return sets_table(files);
  if (name == "agreement") return agreement_table(files);
  if (name == "growth") return growth_table(files);
  if (name == "winners") return winners_table(files);
  if (name == "requires") return needs_table(files);
  if (name == "engines") return engines_table(files);
  if (name == "determinism") return determinism_table(files);
  if (name.starts_with("methods ")) return methods_table(files, name.substr(8));
  throw std::runtime_error("the page asks for a table that there is not: " + name);
}

}  // namespace

std::string filled(const std::string& page, const StudyFiles& files) {
  const std::string open = "<!-- table ";
  const std::string close = " -->\n";
  const std::string end = "<!-- end -->";
  std::string text;
  std::size_t from = 0;
  for (;;) {
    const std::size_t at = page.find(open, from);
    if (at == std::string::npos) return text + page.substr(from);
    const std::size_t name = at + open.size();
    const std::size_t name_end = page.find(close, name);
    const std::size_t stop = page.find(end, name);
    if (name_end == std::string::npos || stop == std::string::npos) {
      throw std::runtime_error("a table of the page has no end");
    }
    text += page.substr(from, name_end + close.size() - from);
    text += "\n" + table_named(page.substr(name, name_end - name), files) + "\n";
    from = stop;
  }
}

}  // namespace breakshot::bench
