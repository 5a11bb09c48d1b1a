// When two things meet. Every answer is a pure function of the paths, so that it does not depend on
// when it is asked; it is the next event, not the next root: contacts that touch and separate are
// not met again before the gap has opened and closed (Bannerman et al. 2014, "Stable algorithm for
// event detection in event-driven particle dynamics").
#pragma once

#include "common/physics/exact.hpp"
#include "common/physics/laws.hpp"
#include "common/physics/roots.hpp"

namespace breakshot::physics {

template <class Real>
constexpr Real largest_coordinate(BasicVec2<Real> a) {
  return larger(magnitude(a.x), magnitude(a.y));
}

/// The one tolerance: a gap of at most this at instant t is a touch. What positions of this size
/// and a time of this size cannot resolve (design section 2, "Detection").
template <class Real>
Real touch_gap(Real coordinate, Real relative_speed, Real time_s) {
  return 8 * ulp(coordinate) + relative_speed * ulp(time_s);
}

/// No touch_gap of these sizes is greater; far cheaper, for the many gaps that are.
template <class Real>
constexpr Real touch_gap_bound(Real coordinate, Real relative_speed, Real time_s) {
  return std::numeric_limits<Real>::epsilon() * (8 * coordinate + relative_speed * time_s);
}

/// Twofold products are good to about 2^-100 (for double): what differs by less is a tie.
template <class Real>
inline const Real twofold_resolution = power_of_two<Real>(8 -
                                                          2 * std::numeric_limits<Real>::digits);

/// Speeds below this have squares that lose digits to underflow; they are taken in units in which
/// they do not, if need be more than once.
template <class Real>
inline const Real slow_below = power_of_two<Real>(std::numeric_limits<Real>::digits + 7 +
                                                  std::numeric_limits<Real>::min_exponent / 2);
template <class Real>
inline const Real slow_scale = power_of_two<Real>(-std::numeric_limits<Real>::min_exponent / 2);

/// The sign of (D |w|)^2 - (d x w)^2 for d = b - a and w = v - u, and its value: whether a straight
/// relative path comes nearer than D. Differences and products keep their rounding errors.
template <class Real>
Real nearness(BasicVec2<Real> a, BasicVec2<Real> b, BasicVec2<Real> u, BasicVec2<Real> v,
              Real distance) {
  const Twofold<Real> dx = two_sum(b.x, -a.x);
  const Twofold<Real> dy = two_sum(b.y, -a.y);
  const Twofold<Real> wx = two_sum(v.x, -u.x);
  const Twofold<Real> wy = two_sum(v.y, -u.y);
  const Twofold<Real> reach = two_product(distance, distance) * (wx * wx + wy * wy);
  const Twofold<Real> cross_product = dx * wy - dy * wx;
  const Twofold<Real> difference = reach - cross_product * cross_product;
  return difference.high > twofold_resolution<Real> * reach.high ? difference.high : Real(0);
}

/// The pair at the later of two starts, seen from there.
template <class Real>
struct Encounter {
  Real start_s{};
  BasicVec2<Real> first;
  BasicVec2<Real> second;
  BasicVec2<Real> first_velocity;
  BasicVec2<Real> second_velocity;
  Relative<Real> relative;
  Real end_s{};  ///< of the earlier phase
};

template <class Real, PathLike Mover, PathLike Other>
Encounter<Real> encounter(const Mover& a, const Other& b) {
  Encounter<Real> e;
  e.start_s = larger(a.segment.start_s, b.segment.start_s);
  e.first = position_at(a.segment, e.start_s);
  e.second = position_at(b.segment, e.start_s);
  e.first_velocity = velocity_at(a.segment, e.start_s);
  e.second_velocity = velocity_at(b.segment, e.start_s);
  e.relative = {e.second - e.first, e.second_velocity - e.first_velocity,
                b.segment.acceleration - a.segment.acceleration};
  e.end_s = a.end_s < b.end_s ? a.end_s : b.end_s;
  return e;
}

/// Time until a straight relative path of constant velocity comes nearer than `distance`, or never.
/// Now they are `apart`, m, and move against one another at `speed`, m/s.
template <class Real>
Real linear_entry(const Encounter<Real>& e, Real distance, Real apart, Real speed) {
  using std::sqrt;
  const BasicVec2<Real> d = e.relative.position;
  const BasicVec2<Real> w = e.relative.velocity;
  const Real largest = largest_coordinate(w);
  if (largest < slow_below<Real>) {
    if (largest == 0) return never<Real>;
    const Real scale = slow_scale<Real>;
    Encounter<Real> scaled = e;
    scaled.first_velocity = e.first_velocity * scale;
    scaled.second_velocity = e.second_velocity * scale;
    scaled.relative.velocity = w * scale;
    return linear_entry(scaled, distance, apart, length(scaled.relative.velocity)) * scale;
  }
  const Real b = dot(d, w);
  if (b >= 0) return never<Real>;
  const Real reach = distance * speed;
  const Real miss = magnitude(cross(d, w));
  const Real doubt = 8 * std::numeric_limits<Real>::epsilon() *
                     (magnitude(d.x * w.y) + magnitude(d.y * w.x) + reach);
  Real discriminant = (reach - miss) * (reach + miss);
  if (magnitude(reach - miss) <= doubt) {
    discriminant = nearness(e.first, e.second, e.first_velocity, e.second_velocity, distance);
  }
  if (!(discriminant > 0)) return never<Real>;
  return (apart - distance) * (apart + distance) / (sqrt(discriminant) - b);
}

/// Whether a pair that is apart is `span` seconds on still apart and has approached all the time.
/// `straight`: the relative path is, and does not turn back.
template <class Real>
bool only_approaches(const Relative<Real>& motion, Real distance, Real span, bool straight) {
  const BasicVec2<Real> d = motion.at(span);
  // A thousandth is for rounding.
  if (!(dot(d, d) > Real(1.001) * distance * distance)) return false;
  if (!(dot(d, motion.velocity_at(span)) < 0)) return false;
  if (straight) return true;
  const Real bend =
      dot(motion.velocity, motion.velocity) + dot(motion.position, motion.acceleration);
  const Real unbent = 3 * dot(motion.velocity, motion.acceleration) * span;
  return bend > 0 && Real(1.001) * -unbent < bend;
}

/// When the balls of two paths next meet: the first event after both have started, within both
/// phases, or never. Touching and approaching is at once. Of what is certainly after `until_s`
/// nothing is said; else that makes no difference.
template <class Real, PathLike Mover, PathLike Other>
Real contact_time(const Mover& a, const Other& b, Real diameter, EntryFinder finder,
                  Real until_s = never<Real>) {
  using std::sqrt;
  const Encounter<Real> e = encounter<Real>(a, b);
  const Relative<Real>& relative = e.relative;
  const Real horizon = e.end_s - e.start_s;
  const Real distance = length(relative.position);
  const Real coordinate =
      larger(diameter, larger(largest_coordinate(e.first), largest_coordinate(e.second)));
  const Real gap = distance - diameter;
  const Real speeds = magnitude(relative.velocity.x) + magnitude(relative.velocity.y);
  const bool one_stays = stays(a) || stays(b);
  const bool slowing = one_stays && !a.curved && !b.curved;
  const bool straight = slowing || relative.acceleration == BasicVec2<Real>{};
  if (gap <= touch_gap_bound(coordinate, speeds, e.start_s) &&
      gap <= touch_gap(coordinate, length(relative.velocity), e.start_s)) {
    const Real approach = -dot(relative.position, relative.velocity);
    const Real unresolved = unresolved_speed(a.speed + b.speed) * distance;
    if (approach > unresolved) return e.start_s;
    if (straight) return never<Real>;
    const EntrySearch<Real> search(relative, diameter, distance, finder);
    const bool level = approach >= -unresolved;
    if (level && search.closes_at_once()) return e.start_s;
    const auto t = search.first(horizon, level);
    return t ? e.start_s + *t : never<Real>;
  }
  if (until_s < e.end_s && only_approaches(relative, diameter, until_s - e.start_s, slowing)) {
    return never<Real>;
  }
  if (!straight) {
    const auto t = EntrySearch<Real>(relative, diameter, distance, finder).first(horizon, false);
    return t ? e.start_s + *t : never<Real>;
  }
  const Real speed = length(relative.velocity);
  Real t = linear_entry(e, diameter, distance, speed);
  if (t == never<Real>) return t;
  if (slowing) {
    // Along a straight decelerating path, t at constant velocity is a distance. The whole stop,
    // at speed / deceleration, covers half of what constant velocity would.
    const Real deceleration = length(stays(a) ? b.segment.acceleration : a.segment.acceleration);
    const Real left = 1 - 2 * (deceleration / speed) * t;
    if (!(left > 0)) return never<Real>;
    t = 2 * t / (1 + sqrt(left));
  }
  return t <= horizon ? e.start_s + t : never<Real>;
}

/// What slows down covers no more than its first speed does, but for rounding.
inline constexpr double never_farther = 1.001;

/// When the ball of a path next meets a nose, or never if that is not before `until_s`; never too
/// if it touches, a gap apart that its speed would not close by then. The ball's surface meets the
/// cushion: its centre meets the line a radius inward, within the cushion's extent.
template <class Real, PathLike Mover>
Real cushion_time(const Mover& path, const Nose<Real>& nose, Real radius, Real top_speed,
                  Real until_s) {
  using std::sqrt;
  const auto& s = path.segment;
  const BasicVec2<Real> offset = s.position - nose.from;
  const Real gap = dot(offset, nose.inward) - radius;
  const Real towards = -dot(s.velocity, nose.inward);
  const Real pull = -dot(s.acceleration, nose.inward);
  if (pull <= 0 && Real(never_farther) * towards * (until_s - s.start_s) < gap) return never<Real>;
  // A straight path that only slows down does not come back.
  if (towards <= 0 && (pull <= 0 || !path.curved)) return never<Real>;
  const auto within = [&](Real t) {
    const Real foot =
        dot(s.position + (s.velocity + s.acceleration * (t / 2)) * t - nose.from, nose.along);
    return foot >= 0 && foot <= nose.extent;
  };
  const Real coordinate = larger(radius, largest_coordinate(s.position));
  if (gap <= touch_gap_bound(coordinate, path.speed, s.start_s) &&
      gap <= touch_gap(coordinate, path.speed, s.start_s)) {
    // Deeper than rounding can have pushed it, or before its end, the ball is beside this cushion:
    // it may come out in front of it and turn back.
    if (gap < -touch_gap(coordinate, 2 * top_speed, s.start_s) || !within(Real(0))) {
      const Real square = towards * towards + 2 * pull * gap;
      if (!(towards < 0 && pull > 0 && square > 0)) return never<Real>;
      const Real t = (sqrt(square) - towards) / pull;
      return s.start_s + t <= path.end_s && within(t) ? s.start_s + t : never<Real>;
    }
    const Real unresolved = unresolved_speed(path.speed);
    if (towards > unresolved) return s.start_s;
    if (pull <= 0) return never<Real>;
    if (towards >= -unresolved) return s.start_s;
    // Back at the line, or where the line was not reached, back at the depth it started from.
    const Real square = towards * towards + 2 * pull * gap;
    const Real t = (square > 0 ? sqrt(square) - towards : -2 * towards) / pull;
    return s.start_s + t <= path.end_s && within(t) ? s.start_s + t : never<Real>;
  }
  const Real discriminant = towards * towards + 2 * pull * gap;
  Real t = never<Real>;
  if (towards > 0 && discriminant > 0) t = 2 * gap / (towards + sqrt(discriminant));
  if (towards <= 0 && pull > 0) t = (sqrt(discriminant) - towards) / pull;
  if (!(s.start_s + t <= path.end_s) || t == never<Real> || !within(t)) return never<Real>;
  return s.start_s + t;
}

/// The sector of an arc has this much to spare on both sides, in radii: what rounding may open
/// between a rounded nose and the straight ones beside it.
template <class Real>
inline const Real sector_slack = 64 * std::numeric_limits<Real>::epsilon();

/// Whether a ball with its centre at `position` is in front of the arc.
template <class Real>
bool faces(const Arc<Real>& arc, BasicVec2<Real> position) {
  const BasicVec2<Real> d = position - arc.centre.segment.position;
  const Real coordinate = larger(largest_coordinate(position), arc.distance);
  const Real slack = sector_slack<Real> * coordinate;
  return cross(arc.from, d) >= -slack && cross(d, arc.to) >= -slack &&
         dot(arc.from + arc.to, d) > 0;
}

/// When the ball of a path next meets a rounded nose, or never.
template <class Real, PathLike Mover>
Real arc_time(const Mover& path, const Arc<Real>& arc, EntryFinder finder) {
  const Real t = contact_time(path, arc.centre, arc.distance, finder);
  return t < never<Real> && faces(arc, position_at(path.segment, t)) ? t : never<Real>;
}

/// When the centre of a path's ball next crosses a hole's edge, or never.
template <class Real, PathLike Mover>
Real drop_time(const Mover& path, const Drop<Real>& drop, EntryFinder finder) {
  return contact_time(path, drop.centre, drop.radius, finder);
}

}  // namespace breakshot::physics
