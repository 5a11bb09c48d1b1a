// A ball and a nose above its centre as one impulse (Han 2005, "Dynamics in carom and three cushion
// billiards", J. Mech. Sci. Technol. 19). The nose touches the ball at R (n cos t + z sin t) from
// its centre, n out of the table and sin t = (height - R) / R. Along that line the ball comes at c
// = (v . n) cos t and takes the impulse (1 + e) c; its surface there slips at v_s, which an impulse
// P changes by 7/2 P: friction takes at most 2/7 |v_s| (sticking) and at most mu times the normal
// impulse (slipping). Vertical velocity is not modelled: the cloth takes it, and energy never
// rises. Parameters: restitution e in [0, 1], friction mu in [0, 10], height in [R, 2R) m.
#pragma once

#include "common/physics/frictional.hpp"

namespace breakshot::physics {

/// Where the nose touches: the unit vector from the ball's centre.
template <class Real>
BasicVec3<Real> nose_direction(BasicVec2<Real> outward, const NoseLaw<Real>& law) {
  using std::sqrt;
  const Real sine = (law.height - law.radius) / law.radius;
  const Real cosine = sqrt((1 - sine) * (1 + sine));
  return {outward.x * cosine, outward.y * cosine, sine};
}

/// Friction at the nose after a normal impulse for each kilogram along `direction`, m/s.
template <class Real>
BasicVec3<Real> nose_friction(const Moving<Real>& ball, BasicVec3<Real> direction,
                              Real normal_impulse, Real share, const NoseLaw<Real>& law) {
  using std::sqrt;
  const BasicVec3<Real> velocity = surface_velocity(ball, direction * law.radius);
  const BasicVec3<Real> slip = velocity - direction * dot(velocity, direction);
  const Real speed = sqrt(dot(slip, slip));
  if (!(speed > 0)) return {};
  return friction_against(slip, speed, law.friction * normal_impulse, share * 2 / 7);
}

/// The ball after the contact. `outward` is the unit normal from the ball to the cushion, towards
/// which it moves.
template <class Real>
Moving<Real> after_han2005(const Moving<Real>& ball, BasicVec2<Real> outward, Real restitution,
                           const NoseLaw<Real>& law) {
  const BasicVec3<Real> direction = nose_direction(outward, law);
  const Real approach = dot(surface_velocity(ball, direction * law.radius), direction);
  const Real normal_impulse = (1 + restitution) * approach;
  const BasicVec3<Real> friction = nose_friction(ball, direction, normal_impulse, Real(1), law);
  Moving<Real> after = ball;
  push(after, direction * law.radius, direction * -normal_impulse + friction, law.radius);
  return after;
}

}  // namespace breakshot::physics
