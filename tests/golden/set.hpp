// Two hundred shots through every model, whose digests are in set.digests. Shots 0 to 164 are every
// combination of 3 motions, 5 contacts between balls (none among them) and 11 cushions (none; five
// models, round a rectangle and as free segments and arcs); 35 more have 25 to 59 balls, for both
// calendars of the physics. Pockets, perturbation, tips, spin, tables and places are drawn.
//
// The shots are frozen: nothing here uses a default, a table or a function of the physics, except
// for its values. A phenomenon that is added gets shots of its own after these.
#pragma once

#include <cstddef>
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

/// The digest of what the physics makes of it, in hexadecimal; "stalled" if it does not end.
std::string digest_of(const GoldenShot& shot);

}  // namespace breakshot::golden
