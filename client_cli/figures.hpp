// The paper's four figures.
#pragma once

#include <optional>

#include "client_cli/draw/picture.hpp"
#include "common/physics/scene.hpp"

namespace breakshot::client {

inline constexpr int figures = 4;
/// Where in the break figures 3 and 4 stand unless told otherwise, s.
inline constexpr double figure_break_s = 0.6;

/// What a figure shows besides what it shows anyway.
struct Besides {
  bool paths = false;
  bool velocities = false;
  bool cue = false;
};

/// 1: the default layout with the cue vector. 2: the rack, near to. 3: the break at `time_s`. 4:
/// the same with velocity vectors. `scene` must be free of faults and have a rectangle of cushions.
/// Throws CommandError where the break cannot be simulated.
Picture figure(int number, const physics::Scene& scene, std::optional<double> time_s = std::nullopt,
               const Besides& besides = {});

}  // namespace breakshot::client
