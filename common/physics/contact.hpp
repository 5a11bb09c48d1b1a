// Two things that touch, and how they move against one another.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/body.hpp"

namespace breakshot::physics {

/// Two things that touch: balls `a` and `b` by their places among the bodies, the lower id first;
/// or ball `a` and cushion `b`, counting arcs after noses.
template <class Real>
struct Contact {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  bool cushion = false;
  bool predicted = false;  ///< the event that brought us here: logged even if nothing is left of it
  BasicVec2<Real> normal;  ///< unit vector from a to the other
  BasicVec2<Real> point;   ///< twice the place of the contact: sorts a set independently of numbers
};

template <class Real>
BasicVec2<Real> relative_velocity(const std::vector<Body<Real>>& bodies, const Contact<Real>& c) {
  return c.cushion ? bodies[c.a].velocity : bodies[c.a].velocity - bodies[c.b].velocity;
}

/// The speed at which a contact closes along `normal`, m/s; negative if it parts.
template <class Real>
Real approach(const std::vector<Body<Real>>& bodies, const Contact<Real>& c,
              BasicVec2<Real> normal) {
  return dot(relative_velocity(bodies, c), normal);
}

template <class Real>
bool has_ball(const Contact<Real>& c, std::uint32_t ball) {
  return c.a == ball || (!c.cushion && c.b == ball);
}

template <class Real>
bool share_a_ball(const Contact<Real>& p, const Contact<Real>& q) {
  return has_ball(q, p.a) || (!p.cushion && has_ball(q, p.b));
}

template <class Real>
std::size_t contacts_of(const std::vector<Contact<Real>>& set, std::uint32_t ball) {
  std::size_t count = 0;
  for (const Contact<Real>& c : set) count += has_ball(c, ball);
  return count;
}

template <class Real>
std::size_t most_contacts_of_a_ball(const std::vector<Contact<Real>>& set) {
  std::size_t most = 1;
  for (const Contact<Real>& c : set) {
    most = std::max({most, contacts_of(set, c.a), c.cushion ? 0 : contacts_of(set, c.b)});
  }
  return most;
}

}  // namespace breakshot::physics
