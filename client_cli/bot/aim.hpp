// Where to strike so that something goes somewhere: pockets as gates, ghost balls, corridors, and
// cushions as mirrors. Geometry alone, by straight paths and contacts along the line of centres;
// what really happens is for the physics to say.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "common/physics/ball.hpp"
#include "common/physics/scene.hpp"

namespace breakshot::bot {

using physics::BallId;
using physics::PocketId;
using physics::Vec2;

/// A segment that the centre of a ball crosses exactly when the ball is about to drop, m.
struct Gate {
  Vec2 from;
  Vec2 to;

  Vec2 middle() const { return (from + to) / 2.0; }
};

/// The gates of a scene's pockets, by PocketId; none for a scene without pockets.
std::vector<Gate> gates_of(const physics::Scene& scene);

/// The unit vector from one point to another; +x if they are the same.
Vec2 towards(Vec2 from, Vec2 to);

/// How the cue ball sends an object ball on its way.
struct Aim {
  Vec2 ghost;      ///< the cue ball's centre at the contact, m
  Vec2 direction;  ///< of the cue ball, unit
  double cut_cos;  ///< cosine of the angle between the paths of the two balls, (0, 1]
};

/// The aim of a cue ball at `cue` that sends a ball at `object` along the unit vector `way`; none
/// where the cut would be 90 degrees or more, or where the two balls overlap already.
std::optional<Aim> aim_of(Vec2 cue, Vec2 object, Vec2 way, double radius_m);

/// Whether a ball can move straight between two places without touching a ball of `table`, apart
/// from the two to be left out.
bool corridor_free(const physics::State& table, double radius_m, Vec2 from, Vec2 to, BallId mover,
                   std::optional<BallId> target = std::nullopt);

/// What the line of a shot meets first.
struct FirstContact {
  Vec2 place;                  ///< the centre of the cue ball at the contact, m
  std::optional<BallId> ball;  ///< missing: a cushion, or nothing within reach
  Vec2 ball_way;               ///< the way that the ball is sent, unit; zero without a ball
};

/// Follows a ball from where it lies along `direction` (unit) to the first thing it meets, at most
/// `reach_m` away.
FirstContact first_contact(const physics::Scene& scene, const physics::State& table, BallId mover,
                           Vec2 direction, double reach_m);

/// The image of `place` in a cushion, as a ball going to it by way of that cushion sees it: aiming
/// at the image reaches the place after the rebound. The balls' centres are mirrored in the line
/// that they can reach, and a cushion that returns less speed stands the image further off.
Vec2 image_in(const physics::CushionSegment& cushion, double radius_m, Vec2 place);

}  // namespace breakshot::bot
