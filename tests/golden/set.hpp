// Two hundred shots through every model, whose digests are in set.digests. Shots 0 to 164 are every
// combination of 3 motions, 5 contacts between balls (none among them) and 11 cushions (none; five
// models, round a rectangle and as free segments and arcs); 35 more have 25 to 59 balls, for both
// calendars of the physics. Pockets, perturbation, tips, spin, tables and places are drawn.
//
// The shots are frozen: nothing here uses a default, a table or a function of the physics, except
// for its values. A phenomenon that is added gets shots of its own after these.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "common/physics/simulate.hpp"

namespace breakshot::golden {

struct GoldenShot {
  std::string name;  ///< its number and what is in it, without spaces
  physics::Scene scene;
  physics::State state;
  std::optional<physics::Strike> strike;
  physics::ShotSeed seed;
  physics::Limits limits;
};

inline constexpr std::size_t combinations = 3 * 5 * 11;
inline constexpr std::size_t golden_shots = 200;
/// Events in one shot: emulated processors run the set in seconds.
inline constexpr std::size_t most_golden_events = 8000;

/// The shot of this number below golden_shots. A pure function.
GoldenShot golden_shot(std::size_t number);

/// The versions of the physics that have all that is in the shots. Of version 1 there are matches.
inline constexpr std::array<std::uint32_t, 2> golden_physics{2, 3};
static_assert(golden_physics.back() == physics::physics_version, "add digests of the new version");

/// A line of set.digests: "physics-3/NAME".
std::string name_of(const GoldenShot& shot, std::uint32_t physics);
/// The digest of what that version of the physics makes of a shot, in hexadecimal; "stalled" if it
/// does not end.
std::string digest_of(const GoldenShot& shot, std::uint32_t physics);

}  // namespace breakshot::golden
