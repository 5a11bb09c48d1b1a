// Scenes between their protobuf message and the domain.
#pragma once

#include "breakshot/v1/scene.pb.h"
#include "common/physics/scene.hpp"
#include "common/wire/check.hpp"

namespace breakshot::wire {

void write(const physics::Scene& scene, v1::Scene& message);
/// The form of a scene; its ranges are physics::faults_of's to check. A number that is missing is
/// the domain's default.
physics::Scene read(const v1::Scene& message, const Where& at);

}  // namespace breakshot::wire
