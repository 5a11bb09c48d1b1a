// The first entry into contact of one point moving relative to another: the first time on an
// interval at which their distance falls below a given one. Linear paths lead to a quadratic,
// quadratic paths to a quartic, which is bracketed by the roots of its derivatives and never solved
// in closed form: closed forms and companion matrices fail near double roots, which is where
// grazing happens.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "common/physics/exact.hpp"
#include "common/physics/vec.hpp"
#include "common/physics/version.hpp"

namespace breakshot::physics {

/// d(t) = position + velocity t + acceleration t^2 / 2, one point as seen from another.
template <class Real>
struct Relative {
  BasicVec2<Real> position;
  BasicVec2<Real> velocity;
  BasicVec2<Real> acceleration;

  BasicVec2<Real> at(Real t) const { return position + (velocity + acceleration * (t / 2)) * t; }
  BasicVec2<Real> velocity_at(Real t) const { return velocity + acceleration * t; }
  /// Half the derivative of the squared distance.
  Real closing(Real t) const { return dot(at(t), velocity_at(t)); }
};

/// |a|^2 - distance^2 without the cancellation of the squares.
template <class Real>
Real excess(BasicVec2<Real> a, Real distance) {
  const Real r = length(a);
  return (r - distance) * (r + distance);
}

/// The roots of a t^2 + b t + c within (0, end), ascending; a double root is none.
template <class Real>
struct QuadraticRoots {
  std::array<Real, 2> t{};
  int count = 0;

  void add(Real root, Real end) {
    if (root > 0 && root < end) t[static_cast<std::size_t>(count++)] = root;
  }
};

template <class Real>
QuadraticRoots<Real> quadratic_roots(Real a, Real b, Real c, Real end) {
  using std::sqrt;
  QuadraticRoots<Real> roots;
  if (a == 0) {
    if (b != 0) roots.add(-c / b, end);
    return roots;
  }
  const Real discriminant = b * b - 4 * a * c;
  if (!(discriminant > 0)) return roots;
  const Real q = (b < 0 ? sqrt(discriminant) - b : -sqrt(discriminant) - b) / 2;
  const Real first = q / a;
  const Real second = q == 0 ? -first : c / q;
  roots.add(first < second ? first : second, end);
  roots.add(first < second ? second : first, end);
  return roots;
}

/// Bisection alone halves a bracket to the last bit within this many steps for every scalar.
template <class Real>
inline constexpr int max_root_steps = 2 * std::numeric_limits<Real>::digits + 64;

/// A root of `value` in [low, high], where its signs differ: Newton's method from `guess`, kept
/// inside the bracket by bisection. `value` gives {f(t), f'(t)}.
template <class Real, class Value>
Real bracketed_root(Real low, Real high, Real guess, bool rising, const Value& value) {
  std::optional<Real> settled;
  Real t = guess > low && guess < high ? guess : low + (high - low) / 2;
  for (int step = 0; step < max_root_steps<Real>; ++step) {
    const auto [f, slope] = value(t);
    if (f == 0) return t;
    ((f < 0) == rising ? low : high) = t;
    Real next = t - f / slope;
    if (next == t) settled = t;
    if (!(next > low && next < high)) next = low + (high - low) / 2;
    if (!(next > low && next < high)) return next;
    const Real moved = next > t ? next - t : t - next;
    t = next;
    if (moved <= std::numeric_limits<Real>::epsilon() * t) return t;
  }
  // A bracket too wide to be halved to the last bit: Newton's method had settled before.
  return settled.value_or(t);
}

/// A squared distance less another, seen from `time`, s seconds on:
/// value + 2 slope s + bend s^2 + cubic s^3 + quartic s^4.
template <class Real>
struct Quartic {
  Real time;
  Real value;
  Real slope;
  Real bend;
  Real cubic;
  Real quartic;
  Real steepness;  ///< -slope at the root of the parabola without the last terms; 0 if it has none

  struct Root {
    Real time;
    bool exact;  ///< to the last bit
  };

  /// Where the parabola falls to zero, if it does, set right by one step of Newton's method with
  /// the last terms. Exact if a second step would be below the last bit, and if what rounding makes
  /// of the steepness, a small difference seen from far away, is.
  Root root() const {
    const Real s = slope < 0 ? value / (steepness - slope) : -(slope + steepness) / bend;
    const Real fall = 2 * steepness - (3 * cubic + 4 * quartic * s) * s * s;
    if (!(fall > 0)) return {time + s, false};
    const Real step = (cubic + quartic * s) * s * s * s / fall;
    const Real far = magnitude(s);
    const Real turning = magnitude(bend) + (3 * magnitude(cubic) + 6 * quartic * far) * far;
    const Real root = time + (s + step);
    const Real resolution = std::numeric_limits<Real>::epsilon() * root;
    return {root, 2 * turning * step * step <= resolution * fall &&
                      far * slope * slope <= root * steepness * (steepness + magnitude(slope))};
  }
};

/// Walks the monotone pieces of the squared distance on (0, end] and returns the first root of
/// |d(t)| = distance with the distance falling. Points that start nearer than that by rounding have
/// entered when they are back at `start` without having been further apart than `distance`: each
/// contact then starts from its own depth or from none, and rounding does not add up.
template <class Real>
class EntrySearch {
 public:
  EntrySearch(const Relative<Real>& motion, Real distance, Real start, EntryFinder finder)
      : motion_(motion),
        distance_(distance),
        floor_(start < distance ? start : distance),
        finder_(finder),
        cubic_(dot(motion.acceleration, motion.acceleration) / 2),
        square_(3 * dot(motion.velocity, motion.acceleration) / 2),
        linear_(dot(motion.velocity, motion.velocity) + dot(motion.position, motion.acceleration)) {
  }

  /// `released`: the points touch now and count as not approaching, however the last bits fell.
  std::optional<Real> first(Real end, bool released) const {
    QuadraticRoots<Real> turns;
    if (!only_bends_up(end)) turns = quadratic_roots(3 * cubic_, 2 * square_, linear_, end);
    Real from = 0;
    Real slope = released ? Real(0) : motion_.closing(Real(0));
    for (int i = 0; i <= turns.count; ++i) {
      const Real to = i < turns.count ? turns.t[static_cast<std::size_t>(i)] : end;
      const Real slope_to = motion_.closing(to);
      if (const auto t = on_piece(from, slope, to, slope_to)) return t;
      from = to;
      slope = slope_to;
    }
    return std::nullopt;
  }

  /// Released points without relative approach that begin to close at once.
  bool closes_at_once() const { return linear_ < 0 || (linear_ == 0 && square_ < 0); }

 private:
  /// Guesses before the turn is looked for instead of the inside; and before bisection helps.
  static constexpr int patient_steps = 8;

  /// On a piece the slope of the squared distance is monotone: it changes its sign once at most.
  std::optional<Real> on_piece(Real from, Real slope, Real to, Real slope_to) const {
    if (slope < 0 && slope_to > 0) return dip(from, to);
    if (slope < 0) return falling(from, to);
    if (slope_to < 0) return falling(slope > 0 ? turn(from, to, false) : from, to);
    return std::nullopt;
  }

  /// Whether the slope certainly grows all the time until `end`, as that of most pairs does.
  bool only_bends_up(Real end) const {
    return linear_ > 0 && (square_ >= 0 || linear_ > Real(-2.001) * square_ * end);
  }

  Real slope_of_closing(Real t) const { return linear_ + (2 * square_ + 3 * cubic_ * t) * t; }

  Real turn(Real from, Real to, bool rising) const {
    const Real guess = from - motion_.closing(from) / slope_of_closing(from);
    return bracketed_root(from, to, guess, rising, [this](Real t) {
      return std::array<Real, 2>{motion_.closing(t), slope_of_closing(t)};
    });
  }

  /// The entry on a stretch over which the distance falls and then grows. Where it turns need not
  /// be known if guesses from the start lead to the inside.
  std::optional<Real> dip(Real from, Real to) const {
    if (finder_ == EntryFinder::newton) return falling(from, turn(from, to, true));
    Real high = to;
    Quartic<Real> seen = quartic_at(from, distance_);
    // A value of 0 decides nothing yet: rounding makes one of what just grazes.
    for (int step = 0; seen.value > 0 && step < patient_steps; ++step) {
      Real next = seen.time - seen.slope / seen.bend;
      if (seen.slope < 0 && seen.steepness > 0) {
        const auto root = seen.root();
        if (root.exact && root.time > from && root.time < high) return root.time;
        next = root.time;
      }
      if (!(next > from && next < high)) break;
      seen = quartic_at(next, distance_);
      if (seen.value < 0) return by_quartics(from, next, seen, distance_);
      (seen.slope < 0 ? from : high) = next;
    }
    return falling(from, turn(from, to, true));
  }

  /// The entry on a stretch over which the distance falls.
  std::optional<Real> falling(Real from, Real to) const {
    const bool apart = is_apart(from);
    const Real distance = apart ? distance_ : floor_;
    const Real below = excess(motion_.at(to), distance);
    if (!(below < 0)) return std::nullopt;
    if (finder_ == EntryFinder::newton) return by_newton(from, to, below, distance);
    return by_quartics(from, to, quartic_at(apart ? from : to, distance), distance);
  }

  bool is_apart(Real t) const { return excess(motion_.at(t), distance_) > 0; }

  /// Seen from the end of the stretch the squared distance is nearly a parabola, which gives the
  /// guess. `below` is what it has there.
  Real by_newton(Real from, Real to, Real below, Real distance) const {
    using std::sqrt;
    const Real slope = -motion_.closing(to);
    const Real bend = slope_of_closing(to);
    const Real root = slope * slope - bend * below;
    const Real guess = root > 0 ? to + below / (slope + sqrt(root)) : from;
    return bracketed_root(from, to, guess, false, [this, distance](Real t) {
      return std::array<Real, 2>{excess(motion_.at(t), distance), 2 * motion_.closing(t)};
    });
  }

  /// Between `low`, outside, and `high`, inside, both as `seen` from one of them: from guess to
  /// guess, kept between the two by bisection.
  Real by_quartics(Real low, Real high, Quartic<Real> seen, Real distance) const {
    for (int step = 0; step < max_root_steps<Real>; ++step) {
      if (seen.value == 0) return seen.time;
      (seen.value > 0 ? low : high) = seen.time;
      Real next = low;
      if (seen.steepness > 0) {
        const auto root = seen.root();
        next = root.time;
        if (root.exact && is_between(low, next, high)) return smaller(larger(next, low), high);
      }
      const bool halve = step > patient_steps && step % 2 == 0;
      if (halve || !(next > low && next < high)) next = low + (high - low) / 2;
      if (!(next > low && next < high)) return next;
      seen = quartic_at(next, distance);
    }
    return seen.time;
  }

  /// Whether rounding alone may have put `t` beyond one of the others.
  static bool is_between(Real low, Real t, Real high) {
    const Real slack = 4 * std::numeric_limits<Real>::epsilon() * t;
    return t >= low - slack && t <= high + slack;
  }

  Quartic<Real> quartic_at(Real t, Real distance) const {
    using std::sqrt;
    const Real value = excess(motion_.at(t), distance);
    const Real slope = motion_.closing(t);
    const Real bend = slope_of_closing(t);
    const Real square = slope * slope - bend * value;
    const Real steepness = square > 0 ? sqrt(square) : Real(0);
    return {t, value, slope, bend, 2 * (square_ + 3 * cubic_ * t) / 3, cubic_ / 2, steepness};
  }

  Relative<Real> motion_;
  Real distance_;
  Real floor_;
  EntryFinder finder_;
  // d . v as a polynomial: (d . v)(0) + linear t + square t^2 + cubic t^3.
  Real cubic_;
  Real square_;
  Real linear_;
};

}  // namespace breakshot::physics
