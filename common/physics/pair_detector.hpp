// Detection as the calendars ask for it: first whether a pair matters at all, then when it meets.
#pragma once

#include "common/physics/detect.hpp"

namespace breakshot::physics {

/// What never ends is looked at this far ahead: the square of it is a number still, s.
template <class Real>
inline constexpr double longest_span_s =
    std::numeric_limits<Real>::max_exponent > 256 ? 1e60 : 1e10;

template <class Real>
class PairDetector {
 public:
  /// No ball is faster than `top_speed`, m/s.
  PairDetector(Real diameter, Real top_speed, EntryFinder finder)
      : diameter_(diameter),
        finder_(finder),
        reach_square_(diameter * margin() * (diameter * margin())),
        unresolved_(16 * unresolved_speed(top_speed) * diameter) {}

  /// Above zero if two balls certainly do not come to meet within `span` seconds, one moving
  /// relative to the other from `d` at `w` with constant acceleration `a`: two axes may separate
  /// them, the line of centres and the normal of their relative velocity; or they only part, even
  /// if they touch. Margins cover rounding, so that what is decided here never differs from what
  /// contact_time would say. Without branches: compilers take several pairs in one go.
  template <class Number>
  Number separation(BasicVec2<Number> d, BasicVec2<Number> w, BasicVec2<Number> a,
                    Number span) const {
    const Number half(Real(1) / 2);
    const Number reach_square(reach_square_);
    const Number after = span * span * half;
    const Number square = dot(d, d);
    const Number straight = dot(d, w) * span;
    const Number last = straight + dot(d, a) * after;
    const Number parts = smaller(straight, last) - Number(unresolved_) * span;
    // d . w t + d . a t^2 / 2 is nowhere less: at the end of the span, or where it turns before.
    const Number left = square + smaller(straight * half, last);
    const Number ahead = left * magnitude(left) - reach_square * square;
    const Number pass = magnitude(cross(d, w)) - magnitude(cross(a, w) * after);
    const Number aside = pass * magnitude(pass) - reach_square * dot(w, w);
    return larger(parts, larger(ahead, aside));
  }

  /// The same where neither ball accelerates. Those that do not approach never meet, even if they
  /// touch.
  template <class Number>
  Number separation(BasicVec2<Number> d, BasicVec2<Number> w, Number span) const {
    const Number reach_square(reach_square_);
    const Number square = dot(d, d);
    const Number approach = dot(d, w);
    const Number left = square + approach * span;
    const Number ahead = left * magnitude(left) - reach_square * square;
    const Number miss = cross(d, w);
    const Number aside = miss * miss - reach_square * dot(w, w);
    return larger(approach, larger(ahead, aside));
  }

  /// When the balls of two paths next meet, or never if that is after `until_s`.
  template <PathLike Mover>
  Real time(const Mover& a, const Mover& b, Real until_s = never<Real>) const {
    return contact_time(a, b, diameter_, finder_, until_s);
  }

 private:
  /// Far above rounding, far below anything that matters for speed.
  static Real margin() {
    const Real rounding = 8192 * std::numeric_limits<Real>::epsilon();
    return 1 + larger(rounding, Real(1e-5));
  }

  Real diameter_;
  EntryFinder finder_;
  Real reach_square_;
  Real unresolved_;  ///< products of a distance of touching balls and a speed, m^2/s
};

}  // namespace breakshot::physics
