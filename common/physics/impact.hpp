// What the models of one contact have in common: how a ball moves, and the laws of noses and of
// pairs of balls. All balls of a scene are of one kind, so masses cancel: impulses are given for
// each kilogram, m/s. A ball's moment of inertia is 2/5 m R^2.
#pragma once

#include "common/physics/vec.hpp"

namespace breakshot::physics {

/// How a ball moves at the instant of a contact.
template <class Real>
struct Moving {
  BasicVec2<Real> velocity;  ///< m/s
  BasicVec3<Real> spin;      ///< rad/s
};

/// What a cushion's nose does to a spinning ball that meets it.
template <class Real>
struct NoseLaw {
  Real radius{};           ///< of the ball, m
  Real height{};           ///< of the nose above the bed, m; at least a radius
  Real friction{};         ///< of ball and nose
  Real cloth_friction{};   ///< of ball and cloth
  Real frequency_ratio{};  ///< of tangential to normal vibration of the nose
};

/// What two spinning balls do to one another.
template <class Real>
struct PairLaw {
  Real radius{};  ///< m
  Real a{};       ///< friction at slip speed v: a + b exp(-c v)
  Real b{};
  Real c{};               ///< s/m
  Real cloth_friction{};  ///< of ball and cloth
};

/// The velocity at a place of a ball's surface, `offset` from its centre, in space: v + w x offset.
template <class Real>
constexpr BasicVec3<Real> surface_velocity(const Moving<Real>& ball, BasicVec3<Real> offset) {
  const BasicVec3<Real> turning = cross(ball.spin, offset);
  return {ball.velocity.x + turning.x, ball.velocity.y + turning.y, turning.z};
}

/// What an impulse for each kilogram does to the spin of a ball, `offset` from its centre.
template <class Real>
constexpr BasicVec3<Real> spin_from(BasicVec3<Real> offset, BasicVec3<Real> impulse, Real radius) {
  return cross(offset, impulse) * (5 / (2 * radius * radius));
}

}  // namespace breakshot::physics
