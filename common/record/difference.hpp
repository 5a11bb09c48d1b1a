// In which field two outcomes differ.
#pragma once

#include <optional>
#include <string>

#include "common/match/match.hpp"

namespace breakshot::record {

/// The first field, in the order of the record, whose canonical bytes differ, with both values:
/// "shot.events[42].time_s: 1.25 stored, 1.2500000000000002 simulated".
std::optional<std::string> difference_of(const match::Outcome& stored,
                                         const match::Outcome& simulated);

}  // namespace breakshot::record
