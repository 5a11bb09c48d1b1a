// How far a shot is from the same shot by the reference. Errors are taken after a ball's first,
// second, ... contact: where balls lie in the end measures chaos, which every method shares, and
// not the method.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "common/study/simulation.hpp"

namespace breakshot::study {

/// A ball that meets the same thing again within this time, s, hops on it: it is pushed, and how
/// many hops a push has is of no interest.
inline constexpr double hop_s = 0.02;

/// Contacts of one ball that are looked at.
inline constexpr std::size_t most_contacts = 12;

/// All balls that had so many contacts in the reference.
struct ContactErrors {
  std::size_t balls = 0;
  /// Of them, those whose contacts up to this one were not all with the same things.
  std::size_t wrong = 0;
  // Of the others:
  std::vector<double> times_s;      ///< differences of the time of the contact
  std::vector<double> positions_m;  ///< distances of the ball's places at the contact
};

struct Comparison {
  std::array<ContactErrors, most_contacts> contacts;  ///< after 1, 2, ... contacts
  ContactErrors end;           ///< when the reference ends; wrong: pocketed in one only
  double overlap_m = 0;        ///< the deepest of two balls when they meet
  double energy = 0;           ///< difference after a quarter of the time, as a share of the first
  bool first_contact = false;  ///< the ball that is struck meets the same ball first, or none
  bool cushions = false;       ///< the same balls meet a cushion
  bool pocketed = false;       ///< the same balls drop

  bool outcome() const { return first_contact && cushions && pocketed; }
};

/// Both shots are of the same input. `struck` is the ball that was; without one, the first contact
/// is the same by definition.
Comparison compare(const WideShot& shot, const WideShot& reference, const physics::Scene& scene,
                   const std::optional<physics::BallId>& struck);

}  // namespace breakshot::study
