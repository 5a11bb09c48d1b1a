// A ball as its contact sees it, and Coulomb friction at a place of its surface.
//
// Frame: x along the surface that is met, y into it, z up. Spins are multiplied by the radius, so
// that all is in m/s, and places of the surface are unit vectors from the centre. An impulse J for
// each kilogram at place r changes the velocity by J and the spin (times R) by 5/2 r x J. Vertical
// velocity is left out: the bed holds the ball down, and nothing lifts it.
#pragma once

#include "common/physics/impact.hpp"

namespace breakshot::physics {

template <class Real>
struct Facing {
  BasicVec2<Real> velocity;  ///< m/s
  BasicVec3<Real> spin;      ///< times the radius, m/s

  BasicVec3<Real> at(BasicVec3<Real> place) const {
    const BasicVec3<Real> turning = cross(spin, place);
    return {velocity.x + turning.x, velocity.y + turning.y, turning.z};
  }
  void strike(BasicVec3<Real> place, BasicVec3<Real> impulse) {
    velocity = velocity + BasicVec2<Real>{impulse.x, impulse.y};
    spin = spin + cross(place, impulse) * (Real(5) / 2);
  }
};

template <class Real>
struct ContactFrame {
  BasicVec2<Real> into;  ///< unit vector, the y axis
  Real radius{};         ///< m

  BasicVec2<Real> along() const { return {into.y, -into.x}; }

  Facing<Real> seen(const Moving<Real>& ball) const {
    const BasicVec2<Real> axis{ball.spin.x * radius, ball.spin.y * radius};
    return {{dot(ball.velocity, along()), dot(ball.velocity, into)},
            {dot(axis, along()), dot(axis, into), ball.spin.z * radius}};
  }

  /// The ball after what was `from` in this frame has become `to`: what has not changed keeps its
  /// bits.
  Moving<Real> changed(const Moving<Real>& ball, const Facing<Real>& from,
                       const Facing<Real>& to) const {
    const BasicVec2<Real> pushed = to.velocity - from.velocity;
    const BasicVec3<Real> spun = (to.spin - from.spin) * (1 / radius);
    const BasicVec2<Real> axis = along() * spun.x + into * spun.y;
    return {ball.velocity + along() * pushed.x + into * pushed.y,
            ball.spin + BasicVec3<Real>{axis.x, axis.y, spun.z}};
  }
};

template <class Real>
constexpr Real lesser(Real a, Real b) {
  return b < a ? b : a;
}

template <class Real>
constexpr Real not_negative(Real a) {
  return a > 0 ? a : Real(0);
}

/// The friction impulse, at most `limit`, of a place that slips at `slip` when a step begins and
/// whose slip all other impulses of the step change by `drift`. `mobility` is the change of slip
/// for each unit of impulse, by axis.
///
/// The direction is that of the slip half-way (second order). The impulse neither reverses the slip
/// nor works: impulse times mean slip is never positive, however large the step, so friction never
/// adds energy. A place that can be held is held.
template <class Real>
BasicVec2<Real> friction_over(BasicVec2<Real> slip, BasicVec2<Real> drift, BasicVec2<Real> mobility,
                              Real limit) {
  const BasicVec2<Real> middle = slip + drift / Real(2);
  const Real speed = length(middle);
  if (!(speed > 0) || !(limit > 0)) return {};
  const BasicVec2<Real> first = middle / speed;
  const BasicVec2<Real> yield{mobility.x * first.x, mobility.y * first.y};
  const Real guess = lesser(limit, speed / dot(first, yield));
  const BasicVec2<Real> half_way = middle - yield * (guess / 2);
  const BasicVec2<Real> direction = half_way / length(half_way);
  const Real give = mobility.x * direction.x * direction.x + mobility.y * direction.y * direction.y;
  const Real to_stop = not_negative(dot(direction, slip + drift)) / give;
  const Real without_work = 2 * dot(direction, middle) / give;
  return direction * -lesser(limit, lesser(to_stop, without_work));
}

/// Friction of ball and bed with an impulse of at most `limit`. The mobility of the lowest point is
/// 7/2 whatever the direction, so that this is exact for any limit.
template <class Real>
void rub_on_bed(Facing<Real>& ball, Real limit) {
  const BasicVec3<Real> lowest{0, 0, -1};
  const BasicVec3<Real> surface = ball.at(lowest);
  const BasicVec2<Real> slip{surface.x, surface.y};
  const Real speed = length(slip);
  if (!(speed > 0)) return;
  const BasicVec2<Real> impulse = slip / speed * -lesser(limit, speed * 2 / 7);
  ball.strike(lowest, {impulse.x, impulse.y, 0});
}

}  // namespace breakshot::physics
