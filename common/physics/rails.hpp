// Where the cushions of a scene are, jaws and holes included: what detection runs against and
// drawings show.
#pragma once

#include <optional>
#include <vector>

#include "common/physics/scene.hpp"

namespace breakshot::physics {

/// A straight piece of a cushion.
struct RailSegment {
  CushionId id{};
  CushionSegment nose;
};

/// A rounded piece of a cushion.
struct RailArc {
  CushionId id{};
  CushionArc nose;
};

/// A hole in the bed. A ball whose centre crosses the edge drops.
struct Hole {
  PocketId pocket{};
  Vec2 centre;      ///< m
  double radius_m;  ///< of the edge
};

/// Everything that a ball can meet but balls. In a rectangle with jaws the cushions keep their ids
/// 0 to 3, and pocket p has jaws 4 + 2 p, at the end of the cushion before it, and 5 + 2 p;
/// counter-clockwise, facing and rounded nose alike.
struct Rails {
  std::vector<RailSegment> segments;
  std::vector<RailArc> arcs;
  std::vector<Hole> holes;
  /// Half the length and width of a rectangle of noses, which no rail reaches into.
  std::optional<Vec2> inside;
};

/// The scene must be free of faults.
Rails rails_of(const Scene& scene);

/// Where pocket `p` of a rectangle of cushions lies: the points of the noses beside its mouth,
/// counter-clockwise, and the unit vector through it, out of the table.
struct Mouth {
  Vec2 first;   ///< m
  Vec2 second;  ///< m
  Vec2 outward;
};

Mouth mouth_of(const Bed& bed, PocketId pocket, double corner_mouth_m, double side_mouth_m);

}  // namespace breakshot::physics
