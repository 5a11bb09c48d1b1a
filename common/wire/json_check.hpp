// Strict JSON: what a lenient reader would let pass (a key given twice, a trailing comma, a number
// beyond a double) is a fault, with the path of its field.
#pragma once

#include <optional>
#include <string_view>

#include "common/physics/scene.hpp"

namespace breakshot::wire {

/// The first fault of a JSON text, or nothing. A fault of syntax has no field but a line and
/// column.
std::optional<physics::Fault> json_fault(std::string_view text);

}  // namespace breakshot::wire
