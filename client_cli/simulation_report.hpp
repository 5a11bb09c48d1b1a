// The output of `breakshot simulate`: one JSON object a line, keys in a fixed order, the shortest
// numbers that read back to the same bits.
#pragma once

#include <optional>
#include <ostream>
#include <vector>

#include "common/physics/audit.hpp"
#include "common/physics/event.hpp"

namespace breakshot::client {

enum class Ending { rest, horizon, until, stalled };

struct Simulated {
  physics::Shot shot;
  Ending ending = Ending::rest;
  std::vector<physics::BallId> stalled;  ///< the balls of the last set, where stalled
};

void print_report(std::ostream& out, const Simulated& simulated,
                  const std::optional<physics::Audit>& audit);

}  // namespace breakshot::client
