// Two balls with friction between them and on the bed, integrated over the impulse. Source:
// Mathavan, Jackson and Parkin 2014, "Numerical simulations of the frictional collisions of solid
// balls on a rough surface", Sports Engineering 17, 227-237.
//
// In the frame of contact_frame.hpp, y from a to b, spins times R, for a normal impulse dP:
//   between the balls  mu_b dP on a against the slip (vax - vbx - waz - wbz, wax + wbx) along x and
//                      z, and the opposite on b;
//   on the bed         the ball that is pushed down, by the z part of that impulse, rubs on the bed
//                      with mu_s times it against the slip of its lowest point (vx - wy, vy + wx).
// Compression lasts until vay = vby, restitution until the normal force has given back e^2 of the
// work that it took.
//
// Parameters: restitution e [0, 1], published 0.89; friction of the balls mu_b = law.a [0, 1],
// published 0.05; friction of ball and cloth mu_s [0, 10], published 0.21; radius R, m. Impulses
// are for each kilogram; both balls are of one kind. Left out: vertical motion (the ball that is
// lifted stays down), and friction that depends on the speed of slip (law.b and law.c are not
// used).
#pragma once

#include "common/physics/contact_frame.hpp"
#include "common/physics/impact_steps.hpp"

namespace breakshot::physics {

template <class Real>
struct PairContact {
  Facing<Real> a;
  Facing<Real> b;
  Real friction{};
  Real cloth_friction{};
  TwoHalves<Real> upwards{};  ///< impulses that a was given, and b lost

  Real approach() const { return a.velocity.y - b.velocity.y; }
  Real mobility() const { return 2; }
  void push(Real impulse) {
    a.velocity.y -= impulse;
    b.velocity.y += impulse;
  }

  void press(Real impulse) {
    const BasicVec2<Real> slip{a.velocity.x - b.velocity.x - (a.spin.z + b.spin.z),
                               a.spin.x + b.spin.x};
    const BasicVec2<Real> held = friction_over<Real>(slip, {}, {7, 5}, friction * impulse);
    push(impulse);
    a.strike({0, 1, 0}, {held.x, 0, held.y});
    b.strike({0, -1, 0}, {-held.x, 0, -held.y});
    upwards.add(held.y);
  }

  void rub() {
    const Real lift = upwards.both();
    rub_on_bed(lift < 0 ? a : b, cloth_friction * (lift < 0 ? -lift : lift));
  }
};

/// Two balls that meet; `normal` is the unit vector from a to b. Balls that do not approach are
/// left as they are. More `steps` for measuring only.
template <class Real>
void collide_mathavan2014(Moving<Real>& a, Moving<Real>& b, BasicVec2<Real> normal,
                          Real restitution, const PairLaw<Real>& law, int steps = impact_steps) {
  const ContactFrame<Real> frame{normal, law.radius};
  const PairContact<Real> before{frame.seen(a), frame.seen(b), law.a, law.cloth_friction, {}};
  if (!(before.approach() > 0)) return;
  Impact<PairContact<Real>, Real> impact(before, restitution);
  const PairContact<Real> after = impact.after(steps);
  a = frame.changed(a, before.a, after.a);
  b = frame.changed(b, before.b, after.b);
}

}  // namespace breakshot::physics
