// A ball against a rigid nose, integrated over the impulse. Source: Mathavan, Jackson and Parkin
// 2010, "A theoretical analysis of billiard ball dynamics under cushion impacts", Proc. IMechE C
// 224, 1863-1873.
//
// The nose meets the ball at I, above the centre by R sin theta = h - R. In the frame of
// contact_frame.hpp I = R (0, cos theta, sin theta). For a normal impulse dP there
//   friction at I    mu_w dP against the slip of I, (vx + wy s - wz c, -vy s + wx) for x and for
//                    Y' = (0, -s, c), spins times R;
//   on the bed at C  what presses the ball down: dP (s + mu_w c (slip along Y') / |slip|);
//   friction at C    mu_s times that, against the slip of C, (vx - wy, vy + wx).
// Compression lasts until the approach is zero, restitution until the normal force has given back
// e^2 of the work that it took.
//
// Parameters: restitution e [0, 1], published 0.98; friction of ball and nose mu_w [0, 10],
// published 0.14; friction of ball and cloth mu_s [0, 10], published 0.212; height h of the nose
// [R, 2R), m, published 7R/5; radius R, m. Impulses are for each kilogram.
// Left out: deformation of the nose (the authors give the model for normal speeds up to 2.5 m/s)
// and vertical motion. Differently from the paper, a ball that friction lifts (mu_w > tan theta can
// do it) presses on the bed with zero, not with less than zero, which would add energy; and places
// whose slip friction can hold at zero stick.
#pragma once

#include "common/physics/contact_frame.hpp"
#include "common/physics/impact_steps.hpp"

namespace breakshot::physics {

template <class Real>
struct NoseContact {
  Facing<Real> ball;
  Real sine{};
  Real cosine{};
  Real friction{};
  Real cloth_friction{};
  TwoHalves<Real> on_bed{};

  Real approach() const { return cosine * ball.velocity.y; }
  Real mobility() const { return cosine * cosine; }
  void push(Real impulse) { ball.velocity.y -= cosine * impulse; }

  void press(Real impulse) {
    const BasicVec3<Real> nose{0, cosine, sine};
    const BasicVec2<Real> slip{ball.velocity.x + ball.spin.y * sine - ball.spin.z * cosine,
                               ball.spin.x - ball.velocity.y * sine};
    const BasicVec2<Real> held =
        friction_over<Real>(slip, {0, sine * cosine * impulse},
                            {Real(7) / 2, Real(5) / 2 + sine * sine}, friction * impulse);
    push(impulse);
    ball.strike(nose, {held.x, -sine * held.y, cosine * held.y});
    on_bed.add(not_negative(sine * impulse - cosine * held.y));
  }

  void rub() { rub_on_bed(ball, cloth_friction * not_negative(on_bed.both())); }
};

/// The ball after it has met a nose in direction `outward`, a unit vector from the ball to the
/// cushion. A ball that does not approach is returned as it is. More `steps` for measuring only.
template <class Real>
Moving<Real> after_mathavan2010(const Moving<Real>& ball, BasicVec2<Real> outward, Real restitution,
                                const NoseLaw<Real>& law, int steps = impact_steps) {
  using std::sqrt;
  const ContactFrame<Real> frame{outward, law.radius};
  const Facing<Real> before = frame.seen(ball);
  if (!(before.velocity.y > 0)) return ball;
  const Real sine = (law.height - law.radius) / law.radius;
  const NoseContact<Real> contact{
      before, sine, sqrt((1 - sine) * (1 + sine)), law.friction, law.cloth_friction, {}};
  Impact<NoseContact<Real>, Real> impact(contact, restitution);
  return frame.changed(ball, before, impact.after(steps).ball);
}

}  // namespace breakshot::physics
