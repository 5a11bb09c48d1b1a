// Shots and tables between their protobuf messages and the domain.
#pragma once

#include "breakshot/v1/shot.pb.h"
#include "common/physics/event.hpp"
#include "common/wire/check.hpp"

namespace breakshot::wire {

void write(const physics::State& table, v1::Table& message);
physics::State read(const v1::Table& message, const Where& at);

void write(const physics::Shot& shot, v1::Shot& message);
physics::Shot read(const v1::Shot& message, const Where& at);

}  // namespace breakshot::wire
