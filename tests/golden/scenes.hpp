// The scenes of the golden shots: which models, with which numbers.
#pragma once

#include <string>

#include "common/physics/scene.hpp"
#include "tests/golden/draws.hpp"

namespace breakshot::golden {

/// Which alternative of each phenomenon a scene has.
struct Models {
  std::size_t motion;    ///< below 3
  std::size_t contact;   ///< below 5; 0: none
  std::size_t cushions;  ///< below 11; 0: none, 1 to 5 a rectangle, 6 to 10 segments and arcs
};

/// A scene and what it is called.
struct NamedScene {
  std::string name;
  physics::Scene scene;
};

/// A scene on a table of any size, or one of the five that have room for sixty balls.
NamedScene scene_of(const Models& models, bool roomy, Draws& draws);

}  // namespace breakshot::golden
