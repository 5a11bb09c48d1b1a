// Checks a shot against what must hold at every event: energy does not rise and nothing overlaps,
// beyond what rounding explains.
#pragma once

#include "common/physics/event.hpp"
#include "common/physics/scene.hpp"
#include "common/physics/version.hpp"

namespace breakshot::physics {

struct Audit {
  double energy_start_J = 0;  ///< kinetic, just after the strike
  double energy_end_J = 0;
  /// The greatest rise of the kinetic energy at one instant, without what contacts that rest may
  /// give when they separate at h, the speed of their hop: m h^2 / 4 a pair, m h^2 / 2 at a
  /// cushion.
  double worst_rise_J = 0;
  /// The deepest overlap of two balls, or of a ball and a cushion, at any instant with events, m.
  double worst_penetration_m = 0;
  /// How much of an overlap is beyond what rounding explains: 8 ulp of the largest coordinate that
  /// its balls have had so far and the way of the fastest ball in 2 ulp of the time, m; 0 when none
  /// is.
  double worst_excess_m = 0;
};

/// The shot must be of that version of the physics: what contacts may give depends on it.
Audit audit(const Scene& scene, const Shot& shot, std::uint32_t physics = physics_version);

}  // namespace breakshot::physics
