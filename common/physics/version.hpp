// Which bits: what earlier versions of the physics did otherwise, kept for their records.
#pragma once

#include <cstdint>

namespace breakshot::physics {

/// Changes whenever the same input may give other bits, if it is one that a match can have. Records
/// name it. Version 1 had no spin, no friction at contacts, no jaws and no arcs; what else was
/// otherwise is below.
inline constexpr std::uint32_t physics_version = 3;

/// How the entry into contact is found once its stretch is known.
enum class EntryFinder : std::uint8_t {
  newton,    ///< from the end of the stretch to the last bit: up to version 2
  quartics,  ///< from its start, in far fewer steps
};

constexpr EntryFinder finder_of(std::uint32_t physics) {
  return physics < 3 ? EntryFinder::newton : EntryFinder::quartics;
}

/// Up to version 2 smooth elastic contacts of straight courses never rested where normals are
/// turned: a push could be endless.
constexpr bool turned_contacts_rest(std::uint32_t physics) {
  return physics >= 3;
}

}  // namespace breakshot::physics
