// The break of 8-ball (WPA 3.3): the shot that has rules of its own, and the choices that follow.
#pragma once

#include "common/rules/eight_ball.hpp"

namespace breakshot::rules {

/// Completes `after`, which already holds fouls, pocketed balls and the table as the balls stopped,
/// by what a break means.
void judge_break(EightBallAfter& after, const physics::Scene& scene, const Facts& facts);

}  // namespace breakshot::rules
