// How the golden shots start: where the balls are, which of them move, and the stroke.
#pragma once

#include <optional>
#include <string>

#include "common/physics/scene.hpp"
#include "tests/golden/draws.hpp"

namespace breakshot::golden {

struct Start {
  std::string name;
  physics::State state;
  std::optional<physics::Strike> strike;  ///< none where the balls move from the start
};

/// A pair, a row, a rack or scattered balls, of which one is struck; or 3 to 12 balls that move.
Start start_of(const physics::Scene& scene, Draws& draws);

/// So many balls, in one rack with the cue ball before it or all of them on the move.
Start crowd_of(const physics::Scene& scene, std::size_t balls, Draws& draws);

}  // namespace breakshot::golden
