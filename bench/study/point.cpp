#include "bench/study/point.hpp"

#include <algorithm>
#include <stdexcept>

namespace breakshot::bench {

study::Method Point::the_method() const {
  if (method == "exact") return study::Exact{};
  if (method == "literal") {
    return study::Literal{step_s == "-" ? std::nullopt : std::optional(std::stod(step_s))};
  }
  if (method == "fixed") return study::FixedStep{std::stod(step_s)};
  if (method == "swept") return study::SweptStep{std::stod(step_s)};
  throw std::runtime_error("there is no method " + method);
}

study::Scalar Point::the_scalar() const {
  const auto& names = study::scalar_names;
  const auto found = std::find(names.begin(), names.end(), scalar);
  if (found == names.end()) throw std::runtime_error("there is no scalar " + scalar);
  return static_cast<study::Scalar>(found - names.begin());
}

std::vector<Point> points(bool full) {
  std::vector<Point> all;
  for (const std::string_view scalar : study::scalar_names) {
    all.push_back({"exact", std::string(scalar), "-"});
  }
  const std::vector<std::string> quick = {"1e-2", "1e-3", "1e-4"};
  const std::vector<std::string> many = {"2e-2", "1e-2", "5e-3", "2e-3", "1e-3",
                                         "5e-4", "2e-4", "1e-4", "1e-5"};
  for (const char* method : {"fixed", "swept"}) {
    for (const std::string& step : full ? many : quick) all.push_back({method, "double", step});
  }
  for (const char* frame : {"-", "1e-2", "1e-3"}) all.push_back({"literal", "double", frame});
  if (full) all.push_back({"literal", "double", "0.25"});
  return all;
}

}  // namespace breakshot::bench
