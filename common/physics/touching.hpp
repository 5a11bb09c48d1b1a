// Whether a ball touches something at this instant: the other contacts of a ball that has one. A
// gap that rounding explains is none (`touch_gap`, detect.hpp).
#pragma once

#include "common/physics/body.hpp"
#include "common/physics/detect.hpp"

namespace breakshot::physics {

template <class Real>
bool balls_touch(const Body<Real>& a, const Body<Real>& b, Real diameter, Real now_s) {
  const Real coordinate =
      larger(diameter, larger(largest_coordinate(a.position), largest_coordinate(b.position)));
  return length(b.position - a.position) - diameter <=
         touch_gap(coordinate, length(b.velocity - a.velocity), now_s);
}

/// `gap` is that of ball and nose, m; deeper than the fastest ball explains, the ball is behind it.
template <class Real>
bool nose_touches(const Body<Real>& body, const Nose<Real>& nose, Real gap, Real radius,
                  Real top_speed, Real now_s) {
  const Real coordinate = larger(radius, largest_coordinate(body.position));
  const Real foot = dot(body.position - nose.from, nose.along);
  return gap <= touch_gap(coordinate, length(body.velocity), now_s) &&
         gap >= -touch_gap(coordinate, 2 * top_speed, now_s) && foot >= 0 && foot <= nose.extent;
}

template <class Real>
bool arc_touches(const Body<Real>& body, const Arc<Real>& arc, Real now_s) {
  const BasicVec2<Real> d = body.position - arc.centre.segment.position;
  const Real coordinate = larger(arc.distance, largest_coordinate(body.position));
  const Real speeds = magnitude(body.velocity.x) + magnitude(body.velocity.y);
  const Real reach = arc.distance + 2 * touch_gap_bound(coordinate, speeds, now_s);
  if (dot(d, d) > reach * reach) return false;
  return length(d) - arc.distance <= touch_gap(coordinate, length(body.velocity), now_s) &&
         faces(arc, body.position);
}

}  // namespace breakshot::physics
