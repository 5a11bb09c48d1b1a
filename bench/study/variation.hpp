// The full model with one phenomenon changed or left out: what a scene requires.
#pragma once

#include <string_view>
#include <vector>

#include "common/wire/scenario.hpp"

namespace breakshot::bench {

struct Variation {
  std::string_view phenomenon;
  std::string_view choice;
  void (*change)(wire::Scenario& scenario);
  bool same_balls = true;  ///< so that its outcome can be compared with that of the full model
  bool cells = false;      ///< in the calendar for many balls
};

/// The first is the full model itself.
const std::vector<Variation>& variations();

/// Simulates to the end.
physics::Shot shot_of(const wire::Scenario& scenario, bool cells);

}  // namespace breakshot::bench
