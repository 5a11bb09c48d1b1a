// A ball against a nose that gives way along its normal and across it. Source: Stronge 2000,
// "Impact Mechanics", chapter 5 (bilinear compliant contact, central impact).
//
// Normal: a spring, softer in restitution so that it gives back e^2 of the energy. With V the
// approach at the contact, in units of time in which the normal frequency is 1:
//   compression   force V sin(t), impulse V (1 - cos(t)), t from 0 to pi/2;
//   restitution   force V sin(p), impulse V (1 - e cos(p)), p = pi/2 + (t - pi/2) / e up to pi.
// Tangential: a spring between ball and nose of frequency ratio r to the normal one. Surface speed
// v and stretch x turn while the contact sticks,
//   x' = v, v' = -r^2 x;
// it slips when the spring's force r^2 x / (7/2) would exceed friction times the normal force: then
// the force is that, x follows it, and v' = -7/2 friction force. A sphere's free contact moves
// along the initial slip only, so that one coordinate is enough.
//
// Parameters: restitution e [0, 1]; friction of ball and nose [0, 10]; height h of the nose [R,
// 2R), m, sin theta = (h - R) / R; frequency ratio r [1, 10]: 1.8 is near that of an elastic
// half-space (Poisson's ratio 0.1), large r is a rigid surface; radius R, m. Impulses are for each
// kilogram. Left out: the bed during the impact. The vertical velocity that the nose gives is
// dropped afterwards, as if the bed took it up, so that the return along the table is less than e
// where h > R; a ball that would still approach (e near 0, h > R) stops. The stretch is not kept
// from one impact to the next.
#pragma once

#include "common/physics/contact_frame.hpp"
#include "common/physics/portable.hpp"

namespace breakshot::physics {

/// Steps of each of the two phases. Sticking is exact for any number; twice as many change
/// velocities by less than 1e-3 of the speeds of the impact at r = 10, 1e-4 at r = 2.
inline constexpr int compliant_steps = 64;

/// The tangential coordinate during an impact.
template <class Real>
struct Shear {
  Real slip{};     ///< of the ball's surface, m/s
  Real stretch{};  ///< of the spring, times the normal frequency, m/s

  /// One step: sticking turns both by `turn`, exactly; beyond the greatest stretch that friction
  /// holds the contact slips, with an impulse of at most `most`.
  void advance(SineCosine<Real> turn, Real ratio, Real greatest, Real most) {
    using std::sqrt;
    const Shear stuck{slip * turn.cosine - ratio * stretch * turn.sine,
                      stretch * turn.cosine + slip / ratio * turn.sine};
    const Real sign = stuck.stretch < 0 ? Real(-1) : Real(1);
    if (sign * stuck.stretch <= greatest) {
      *this = stuck;
      return;
    }
    const Real needed = sign * (slip - stuck.slip) * 2 / 7;
    const Real impulse = needed < -most ? -most : lesser(needed, most);
    // Spring and motion together have no more energy than before: within a step that only partly
    // slips the impulse alone would not ensure that.
    const Real energy = slip * slip + ratio * ratio * (stretch - greatest) * (stretch + greatest);
    const Real fastest = sqrt(not_negative(energy));
    const Real next = slip - sign * impulse * 7 / 2;
    slip = next < -fastest ? -fastest : lesser(next, fastest);
    stretch = sign * greatest;
  }
};

/// Runs one phase: `share` is 1 in compression, the restitution in restitution; `from` is the
/// cosine at its start, 1 or 0.
template <class Real>
void run_phase(Shear<Real>& shear, Real approach, Real share, int from, Real friction, Real ratio,
               int steps) {
  const portable::Period<Real>& half_pi = portable::half_pi<Real>();
  const Real angle = (half_pi.high + half_pi.low) / Real(steps);
  const SineCosine<Real> normal = portable_sine_cosine<Real>(angle);
  const SineCosine<Real> turn = portable_sine_cosine<Real>(angle * share * ratio);
  const Real hold = friction * approach * 7 / (2 * ratio * ratio);
  Real sine = Real(1 - from);
  Real cosine = Real(from);
  for (int step = 1; step <= steps; ++step) {
    const Real last = cosine;
    cosine = last * normal.cosine - sine * normal.sine;
    sine = sine * normal.cosine + last * normal.sine;
    if (step == steps) {
      cosine = Real(from - 1);
      sine = Real(from);
    }
    shear.advance(turn, ratio, hold * not_negative(sine),
                  friction * approach * share * (last - cosine));
  }
}

/// The tangential impulse of an impact at `approach` > 0, against a slip of `slip` >= 0.
template <class Real>
Real compliant_impulse(Real slip, Real approach, Real restitution, const NoseLaw<Real>& law,
                       int steps) {
  Shear<Real> shear{slip, 0};
  run_phase<Real>(shear, approach, 1, 1, law.friction, law.frequency_ratio, steps);
  if (restitution > 0) {
    run_phase<Real>(shear, approach, restitution, 0, law.friction, law.frequency_ratio, steps);
  }
  return (slip - shear.slip) * 2 / 7;
}

/// The ball after it has met a nose in direction `outward`, a unit vector from the ball to the
/// cushion. A ball that does not approach is returned as it is. More `steps` for measuring only.
template <class Real>
Moving<Real> after_stronge2000(const Moving<Real>& ball, BasicVec2<Real> outward, Real restitution,
                               const NoseLaw<Real>& law, int steps = compliant_steps) {
  using std::sqrt;
  const ContactFrame<Real> frame{outward, law.radius};
  const Facing<Real> before = frame.seen(ball);
  if (!(before.velocity.y > 0)) return ball;
  const Real sine = (law.height - law.radius) / law.radius;
  const Real cosine = sqrt((1 - sine) * (1 + sine));
  const Real approach = cosine * before.velocity.y;
  const BasicVec2<Real> slip{before.velocity.x + before.spin.y * sine - before.spin.z * cosine,
                             before.spin.x - before.velocity.y * sine};
  const Real speed = length(slip);
  Facing<Real> after = before;
  after.velocity.y -= cosine * (1 + restitution) * approach;
  if (speed > 0) {
    const BasicVec2<Real> held =
        slip / speed * -compliant_impulse(speed, approach, restitution, law, steps);
    after.strike({0, cosine, sine}, {held.x, -sine * held.y, cosine * held.y});
  }
  after.velocity.y = lesser(after.velocity.y, Real(0));
  return frame.changed(ball, before, after);
}

}  // namespace breakshot::physics
