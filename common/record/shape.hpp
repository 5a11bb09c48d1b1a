// Rules of what may be recorded that span several fields: orders and references that show, verify
// and every other reader rely on.
#pragma once

#include <optional>
#include <string>

#include "common/record/record.hpp"

namespace breakshot::record {

/// Balls ascend by id.
std::optional<std::string> shape_fault(const physics::State& state);

/// Every ball has a segment from 0; events and segments are in order of time, none after the end,
/// and of balls of the shot.
std::optional<std::string> shape_fault(const physics::Shot& shot);

/// There is a player for every seat.
std::optional<std::string> shape_fault(const Header& header);

/// Seats are seats of the match, and what is listed by seat has one of each.
std::optional<std::string> shape_fault(const Header& header, const Entry& entry);

}  // namespace breakshot::record
