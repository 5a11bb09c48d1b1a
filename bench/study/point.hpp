// One way to simulate, as a row of the study names it.
#pragma once

#include <string>
#include <vector>

#include "common/study/method.hpp"

namespace breakshot::bench {

struct Point {
  std::string method;  ///< exact, fixed, swept, literal
  std::string scalar;
  std::string step_s;  ///< as it is written; "-" without one

  study::Method the_method() const;
  study::Scalar the_scalar() const;
};

/// All that are studied; more of them in a full study.
std::vector<Point> points(bool full);

}  // namespace breakshot::bench
