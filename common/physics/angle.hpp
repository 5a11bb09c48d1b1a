// Angles become direction vectors at the edge, here, by a sine and cosine of our own: those of the
// platform's library differ between machines.
#pragma once

#include "common/physics/vec.hpp"

namespace breakshot::physics {

inline constexpr double pi = 3.14159265358979323846;

/// Beyond this the reduction to a quadrant would lose digits, rad.
inline constexpr double max_angle_rad = 1e6;

/// The unit vector at `angle_rad` from +x towards +y; |angle_rad| <= max_angle_rad. Accurate to 2
/// ulp.
Vec2 direction_of(double angle_rad);

}  // namespace breakshot::physics
