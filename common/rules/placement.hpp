// Where a ball may be put: by a player's hand, and by the rules.
#pragma once

#include <optional>
#include <string>

#include "common/physics/scene.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::rules {

/// Whether a cue ball in hand may be played from `position`. Behind the head string excludes the
/// string itself (WPA 8.1), except the head spot, on which a rack sets the cue ball.
bool may_play_from(const physics::Bed& bed, BallInHand hand, physics::Vec2 position);

/// What is wrong with putting `ball` at `position` by hand, or nothing: off the bed, on another
/// ball, or not where `hand` allows. Starts with the field that is at fault.
std::optional<std::string> placement_fault(const physics::Scene& scene, const physics::State& table,
                                           physics::BallId ball, physics::Vec2 position,
                                           BallInHand hand);

/// `table` with `ball` at `position`, moved there or put back.
physics::State with_ball(const physics::State& table, physics::BallId ball, physics::Vec2 position);

/// A bed must be at least this long, in radii of a ball, for a spot to be found whatever lies on
/// the long string: each of 15 balls keeps less than 4.1 radii of it from the centre of another,
/// and 2 are lost at the ends.
inline constexpr int least_bed_length_radii = 64;

/// `ball` spotted (WPA 1.4): on the foot spot, or on the long string as near behind it as the other
/// balls leave room, touching the one in the way unless that is the cue ball; before the foot spot
/// if all behind it is blocked.
physics::State with_spotted(const physics::Scene& scene, const physics::State& table,
                            physics::BallId ball);

/// The cue ball on the head spot, or on the long string as near behind it as the other balls leave
/// room; before it if all behind it is blocked. It touches no ball.
physics::State with_cue_ball_at_head_spot(const physics::Scene& scene, const physics::State& table);

}  // namespace breakshot::rules
