// The closed choices of a scene between their protobuf messages and the domain: motions, models of
// contacts, pockets.
#pragma once

#include "breakshot/v1/scene.pb.h"
#include "common/physics/scene.hpp"
#include "common/wire/check.hpp"

namespace breakshot::wire {

void write(const physics::Motion& motion, v1::Motion& message);
void write(const physics::CushionModel& model, v1::CushionModel& message);
void write(const physics::Pockets& pockets, v1::Pockets& message);
void write(const physics::BallBallModel& model, v1::BallBallModel& message);

// Numbers that have a default may be missing; ranges are physics::faults_of's to check.

physics::Motion read(const v1::Motion& message, const Where& at);
physics::CushionModel read(const v1::CushionModel& message, const Where& at);
physics::Pockets read(const v1::Pockets& message, const Where& at);
physics::BallBallModel read(const v1::BallBallModel& message, const Where& at);

}  // namespace breakshot::wire
