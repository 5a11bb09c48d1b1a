// Random breaks and shots over every combination of models: what `breakshot audit` looks at.
#pragma once

#include <cstdint>

#include "common/wire/scenario.hpp"

namespace breakshot::client {

/// The scenario with this number of the campaign with this seed; free of faults. A pure function.
wire::Scenario random_scenario(std::uint64_t seed, std::uint32_t number);

}  // namespace breakshot::client
