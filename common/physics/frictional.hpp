// Two balls that rub while they bounce: throw and transfer of spin as one impulse of Coulomb
// friction. The surfaces slip at v_s = v_a - v_b + (w_a + w_b) x R n across the line of centres n,
// vertical part included; an impulse P against the slip changes it by 7 P, so that P is at most
// |v_s| / 7 (sticking) and at most mu times the normal impulse (slipping). The coefficient falls
// with the slip, mu = a + b exp(-c v_s): Alciatore, "Pool and billiards physics principles", TP
// A.14, a fit to the measurements of Marlow 1995. Vertical velocity is not modelled: what the cloth
// takes of it is lost, so that energy never rises.
#pragma once

#include "common/physics/impact.hpp"
#include "common/physics/portable.hpp"

namespace breakshot::physics {

/// The impulse for each kilogram, in space, that friction gives a ball whose surface slips: against
/// `slip` of this speed, limited by the coefficient times the normal impulse and by `stick` times
/// the slip.
template <class Real>
BasicVec3<Real> friction_against(BasicVec3<Real> slip, Real speed, Real limit, Real stick) {
  const Real size = stick * speed < limit ? stick * speed : limit;
  return slip * (-size / speed);
}

/// How fast the surfaces of two balls slip past one another, of a as seen from b, m/s. `normal` is
/// the unit vector from a to b.
template <class Real>
BasicVec3<Real> slip_of_pair(const Moving<Real>& a, const Moving<Real>& b, BasicVec2<Real> normal,
                             Real radius) {
  const BasicVec3<Real> to_contact{normal.x * radius, normal.y * radius, Real(0)};
  const BasicVec3<Real> slip =
      surface_velocity(a, to_contact) - surface_velocity(b, to_contact * Real(-1));
  const BasicVec2<Real> tangent = perp(normal);
  const Real across = slip.x * tangent.x + slip.y * tangent.y;
  return {tangent.x * across, tangent.y * across, slip.z};
}

/// Friction of two balls after a normal impulse for each kilogram of `normal_impulse`, m/s; `share`
/// in (0, 1] is how much of what sticks this contact may take where a ball has several.
template <class Real>
BasicVec3<Real> pair_friction(const Moving<Real>& a, const Moving<Real>& b, BasicVec2<Real> normal,
                              Real normal_impulse, Real share, const PairLaw<Real>& law) {
  using std::sqrt;
  const BasicVec3<Real> slip = slip_of_pair(a, b, normal, law.radius);
  const Real speed = sqrt(dot(slip, slip));
  if (!(speed > 0)) return {};
  const Real coefficient = law.b > 0 ? law.a + law.b * portable_exp(-law.c * speed) : law.a;
  return friction_against(slip, speed, coefficient * normal_impulse, share / 7);
}

/// Gives a ball an impulse for each kilogram at `offset` from its centre.
template <class Real>
void push(Moving<Real>& ball, BasicVec3<Real> offset, BasicVec3<Real> impulse, Real radius) {
  ball.velocity = ball.velocity + BasicVec2<Real>{impulse.x, impulse.y};
  ball.spin = ball.spin + spin_from(offset, impulse, radius);
}

}  // namespace breakshot::physics
