// Matches, their commands and what these led to, between their protobuf messages and the domain.
#pragma once

#include <optional>

#include "breakshot/v1/match.pb.h"
#include "common/match/match.hpp"
#include "common/wire/check.hpp"

namespace breakshot::wire {

void write(const match::Settings& settings, v1::Settings& message);
/// Free of faults (match::faults_of), or refused.
match::Settings read(const v1::Settings& message, const Where& at);

void write(const match::Command& command, v1::Command& message);
match::Command read(const v1::Command& message, const Where& at);

/// How a match ended; nothing for MATCH_END_UNSPECIFIED.
std::optional<match::MatchEnd> match_end(int value, const Where& at);

void write(const match::Outcome& outcome, v1::Outcome& message);
match::Outcome read(const v1::Outcome& message, const Where& at);

}  // namespace breakshot::wire
