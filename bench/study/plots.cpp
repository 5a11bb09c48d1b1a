#include <algorithm>
#include <array>

#include "bench/study/report.hpp"
#include "bench/study/results.hpp"
#include "bench/study/sets.hpp"
#include "common/study/compare.hpp"

namespace breakshot::bench {
namespace {

/// A curve and how it is drawn. Hollow marks: the outcome depends on how a caller slices time.
struct Curve {
  const char* method;
  const char* title;
  const char* style;
};

constexpr std::array<Curve, 4> curves = {{
    {"exact", "exact: float, double, long double", "lc rgb '#1b6ca8' pt 7"},
    {"swept", "swept step", "lc rgb '#2e8b57' pt 5"},
    {"fixed", "fixed step", "lc rgb '#c0392b' pt 9"},
    {"literal", "literal frames", "lc rgb '#8e44ad' pt 6"},
}};

constexpr std::array<const char*, 4> drawn_sets = {"break_full", "break", "push", "gas_1000"};

/// Errors that are below what a double can say are drawn at the bottom.
constexpr double least_error_m = 1e-20;

using Lines = std::vector<std::pair<double, double>>;

std::string block(const std::string& name, const Lines& lines) {
  std::string text = "$" + name + " << EOD\n";
  for (const auto& [x, y] : lines) {
    text += shown(x) + " " + shown(std::max(y, least_error_m)) + "\n";
  }
  return text + "EOD\n";
}

std::string plot(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "plot " : ", ") + part;
  return text + "\n";
}

/// The contact whose error is drawn against cost: the first that feels those before it everywhere.
constexpr const char* drawn_contact = "3";

/// Cost against the error of a ball's place at that contact, one curve a method.
std::string work_precision(const StudyFiles& files, const std::string& set) {
  std::string text;
  std::vector<std::string> parts;
  const auto points = points_of(files, set);
  for (const Curve& curve : curves) {
    Lines lines;
    for (const Row& point : points) {
      const auto error = position_error(files, point, drawn_contact);
      if (point.at("method") != curve.method || point.at("scalar") == "reference" || !error) {
        continue;
      }
      lines.push_back({*number_in(point, "cpu_us"), *error});
    }
    if (lines.empty()) continue;
    const std::string name = set + "_" + curve.method;
    text += block(name, lines);
    parts.push_back("$" + name + " with linespoints lw 2 ps 1.4 " + curve.style + " title '" +
                    curve.title + "'");
  }
  const std::string title =
      "set title '" + set + ": " + std::string(set_of(set).what) + "' noenhanced\n";
  return parts.empty() ? "" : text + title + plot(parts);
}

/// The error of a ball's place after each of its contacts.
std::string growth(const StudyFiles& files, const std::string& set) {
  std::string text;
  std::vector<std::string> parts;
  std::size_t count = 0;
  for (const Row& point : points_of(files, set)) {
    const std::string way = name_of(point);
    const bool drawn = (point.at("method") == "exact" && point.at("scalar") != "reference") ||
                       way == "swept 1e-3" || way == "fixed 1e-4" || way == "literal 1e-3";
    if (!drawn) continue;
    Lines lines;
    for (std::size_t k = 1; k <= study::most_contacts; ++k) {
      const auto error = position_error(files, point, std::to_string(k));
      if (error) lines.push_back({static_cast<double>(k), *error});
    }
    const std::string name = set + "_growth_" + std::to_string(count++);
    text += block(name, lines);
    parts.push_back("$" + name + " with linespoints lw 2 title '" + way + "'");
  }
  return parts.empty() ? "" : text + "set title '" + set + "' noenhanced\n" + plot(parts);
}

}  // namespace

std::string plots(const StudyFiles& files) {
  std::string text =
      "set terminal pngcairo size 1500,1100 font 'sans,12' background rgb 'white'\n"
      "set grid\nset format y '10^{%L}'\nset logscale y\n"
      "set output 'accuracy.png'\nset multiplot layout 2,2\n"
      "set logscale x\nset format x '10^{%L}'\n"
      "set xlabel 'processor time a shot, us'\n"
      "set ylabel 'error of the place of the 3rd contact, m (median)'\n"
      "set key outside bottom center horizontal\nset yrange [1e-20:1]\n";
  for (const char* set : drawn_sets) text += work_precision(files, set);
  text +=
      "unset multiplot\nset terminal pngcairo size 1500,600\n"
      "set output 'growth.png'\nset multiplot layout 1,2\n"
      "unset logscale x\nset format x '%g'\nset xlabel 'contacts that a ball has had'\n"
      "set ylabel 'error of the place of the contact, m (median)'\nset key outside bottom center "
      "horizontal\n";
  text += growth(files, "break_full") + growth(files, "gas_1000");
  return text + "unset multiplot\n";
}

}  // namespace breakshot::bench
