// Who may ask what, and when: everything that can be refused without looking at a command's values.
#pragma once

#include <optional>

#include "common/match/match.hpp"

namespace breakshot::match {

/// Whether `seat` exists and has not left.
bool sits(const Match& match, Seat seat);

/// Why `ask` cannot be carried out now, or nothing.
std::optional<Refusal> not_permitted(const Match& match, const Ask& ask);

}  // namespace breakshot::match
