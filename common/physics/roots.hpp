// The first entry into contact of one point moving relative to another: the first time on an
// interval at which their distance falls below a given one. Linear paths lead to a quadratic,
// quadratic paths to a quartic, which is bracketed by the roots of its derivatives and never solved
// in closed form: closed forms and companion matrices fail near double roots, which is where
// grazing happens.
#pragma once

#include <array>
#include <optional>

#include "common/physics/exact.hpp"
#include "common/physics/vec.hpp"

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

/// A root of `value` in [low, high], where its signs differ: Newton's method from `guess`, kept
/// inside the bracket by bisection. `value` gives {f(t), f'(t)}.
template <class Real, class Value>
Real bracketed_root(Real low, Real high, Real guess, bool rising, const Value& value) {
  // Bisection alone halves the bracket to the last bit within this many steps for every scalar.
  constexpr int max_steps = 2 * std::numeric_limits<Real>::digits + 64;
  std::optional<Real> settled;
  Real t = guess > low && guess < high ? guess : low + (high - low) / 2;
  for (int step = 0; step < max_steps; ++step) {
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

/// Walks the monotone pieces of the squared distance on (0, end] and returns the first root of
/// |d(t)| = distance with the distance falling. Points that start nearer than that by rounding have
/// entered when they are back at `start` without having been further apart than `distance`: each
/// contact then starts from its own depth or from none, and rounding does not add up.
template <class Real>
class EntrySearch {
 public:
  EntrySearch(const Relative<Real>& motion, Real distance, Real start)
      : motion_(motion),
        distance_(distance),
        floor_(start < distance ? start : distance),
        cubic_(dot(motion.acceleration, motion.acceleration) / 2),
        square_(3 * dot(motion.velocity, motion.acceleration) / 2),
        linear_(dot(motion.velocity, motion.velocity) + dot(motion.position, motion.acceleration)) {
  }

  /// `released`: the points touch now and count as not approaching, however the last bits fell.
  std::optional<Real> first(Real end, bool released) const {
    const QuadraticRoots<Real> turns = quadratic_roots(3 * cubic_, 2 * square_, linear_, end);
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
  /// On a piece the slope of the squared distance is monotone: it changes its sign once at most.
  std::optional<Real> on_piece(Real from, Real slope, Real to, Real slope_to) const {
    if (slope < 0 && slope_to > 0) return falling(from, turn(from, to, true));
    if (slope < 0) return falling(from, to);
    if (slope_to < 0) return falling(slope > 0 ? turn(from, to, false) : from, to);
    return std::nullopt;
  }

  Real slope_of_closing(Real t) const { return linear_ + (2 * square_ + 3 * cubic_ * t) * t; }

  Real turn(Real from, Real to, bool rising) const {
    const Real guess = from - motion_.closing(from) / slope_of_closing(from);
    return bracketed_root(from, to, guess, rising, [this](Real t) {
      return std::array<Real, 2>{motion_.closing(t), slope_of_closing(t)};
    });
  }

  /// The entry on a stretch over which the distance falls. Seen from the end of the stretch the
  /// squared distance is nearly a parabola, which gives the guess.
  std::optional<Real> falling(Real from, Real to) const {
    using std::sqrt;
    const Real distance = excess(motion_.at(from), distance_) > 0 ? distance_ : floor_;
    const Real below = excess(motion_.at(to), distance);
    if (!(below < 0)) return std::nullopt;
    const Real slope = -motion_.closing(to);
    const Real bend = slope_of_closing(to);
    const Real root = slope * slope - bend * below;
    const Real guess = root > 0 ? to + below / (slope + sqrt(root)) : from;
    return bracketed_root(from, to, guess, false, [this, distance](Real t) {
      return std::array<Real, 2>{excess(motion_.at(t), distance), 2 * motion_.closing(t)};
    });
  }

  Relative<Real> motion_;
  Real distance_;
  Real floor_;
  // d . v as a polynomial: (d . v)(0) + linear t + square t^2 + cubic t^3.
  Real cubic_;
  Real square_;
  Real linear_;
};

}  // namespace breakshot::physics
