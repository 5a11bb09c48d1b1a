// Which versions of the physics can be simulated again, and what each had.
#include <algorithm>

#include "common/record/record.hpp"

namespace breakshot::record {
namespace {

using Name = std::optional<std::string>;

/// What came with version 2, by its name in a scenario file; nothing for what version 1 had.
struct Newer {
  Name operator()(const physics::Frictionless&) const { return std::nullopt; }
  Name operator()(const physics::Straight&) const { return std::nullopt; }
  Name operator()(const physics::Spinning&) const { return "spinning"; }
  Name operator()(const physics::Mirror&) const { return std::nullopt; }
  Name operator()(const physics::CushionRestitution&) const { return std::nullopt; }
  Name operator()(const physics::Han2005&) const { return "han2005"; }
  Name operator()(const physics::Mathavan2010&) const { return "mathavan2010"; }
  Name operator()(const physics::Stronge2000&) const { return "stronge2000"; }
  Name operator()(const physics::StandardPockets&) const { return std::nullopt; }
  Name operator()(const physics::JawedPockets&) const { return "jawed"; }
  Name operator()(const physics::Elastic&) const { return std::nullopt; }
  Name operator()(const physics::BallRestitution&) const { return std::nullopt; }
  Name operator()(const physics::BallFriction&) const { return "frictional"; }
  Name operator()(const physics::Mathavan2014&) const { return "mathavan2014"; }

  Name operator()(const physics::RectangleCushions& cushions) const {
    return std::visit(*this, cushions.model);
  }
  Name operator()(const physics::FreeCushions& cushions) const {
    if (!cushions.arcs.empty()) return "arcs";
    for (const physics::CushionSegment& segment : cushions.segments) {
      if (auto name = std::visit(*this, segment.model)) return name;
    }
    return std::nullopt;
  }

  template <class Part>
  Name operator()(const std::optional<Part>& part) const {
    return part ? std::visit(*this, *part) : std::nullopt;
  }
};

}  // namespace

bool can_simulate(std::uint32_t physics) {
  return physics == physics::physics_version ||
         std::find(earlier_physics.begin(), earlier_physics.end(), physics) !=
             earlier_physics.end();
}

std::string simulated_versions() {
  std::string earlier;
  for (const std::uint32_t version : earlier_physics) {
    if (version == physics::physics_version) continue;
    earlier += (earlier.empty() ? "" : ", ") + std::to_string(version);
  }
  const std::string present = std::to_string(physics::physics_version);
  return earlier.empty() ? "version " + present : "versions " + earlier + " and " + present;
}

std::optional<std::string> newer_part_of(const physics::Scene& scene, std::uint32_t physics) {
  if (physics != 1) return std::nullopt;
  constexpr Newer newer;
  const std::pair<const char*, Name> parts[] = {
      {"scene.bed.motion", std::visit(newer, scene.bed.motion)},
      {"scene.cushions", newer(scene.cushions)},
      {"scene.pockets", newer(scene.pockets)},
      {"scene.ballBall", newer(scene.ball_ball)},
  };
  for (const auto& [field, name] : parts) {
    if (!name) continue;
    return std::string(field) + ": " + *name + " came with version 2 of the physics";
  }
  return std::nullopt;
}

}  // namespace breakshot::record
