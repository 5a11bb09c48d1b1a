// Scenario files: one scene, its balls and a stroke, as JSON in the protobuf mapping of
// breakshot.v1.Scenario (docs/scenarios.md).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/physics/simulate.hpp"

namespace breakshot::wire {

struct Scenario {
  physics::Scene scene;
  physics::State state;
  std::optional<physics::Strike> strike;
  physics::ShotSeed seed;
  physics::Limits limits;
};

/// Reads and validates. Any text gives a scenario free of faults, or at least one fault whose field
/// is the path in the file.
std::variant<Scenario, std::vector<physics::Fault>> read_scenario(std::string_view json);

/// The text of a scenario file, which reads back to the same scenario.
std::string text_of(const Scenario& scenario);

}  // namespace breakshot::wire
