// Scenes between their protobuf message and the domain.
#pragma once

#include "breakshot/v1/scene.pb.h"
#include "common/physics/scene.hpp"
#include "common/wire/check.hpp"

namespace breakshot::wire {

void write(const physics::Scene& scene, v1::Scene& message);
physics::Vec2 read(const v1::Vec2& message, const Where& at);
/// The form of a scene; its ranges are physics::faults_of's to check. Numbers that have a default
/// may be missing; the message names the default.
physics::Scene read(const v1::Scene& message, const Where& at);

}  // namespace breakshot::wire
