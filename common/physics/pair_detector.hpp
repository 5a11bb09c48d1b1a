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
  explicit PairDetector(Real diameter)
      : diameter_(diameter), reach_square_(diameter * Real(margin) * (diameter * Real(margin))) {}

  /// Above zero if two balls certainly do not come to meet within `span` seconds, one moving
  /// relative to the other from `d` at `w` with constant acceleration `a`: two axes may separate
  /// them, the line of centres and the normal of their relative velocity. Balls that touch are
  /// never apart on either. A margin covers rounding, so that what is decided here never differs
  /// from what contact_time would say. Without branches: compilers take several pairs in one go.
  Real separation(BasicVec2<Real> d, BasicVec2<Real> w, BasicVec2<Real> a, Real span) const {
    const BasicVec2<Real> bend = a * (span * span / 2);
    const Real straight = dot(d, w) * span;
    // d . w t + d . a t^2 / 2 is nowhere less: at the end of the span, or where it turns before.
    const Real least = smaller(smaller(straight / 2, straight + dot(d, bend)), Real(0));
    const Real left = larger(dot(d, d) + least, Real(0));
    const Real ahead = left * left - reach_square_ * dot(d, d);
    const Real miss = larger(cross(d, w), cross(w, d));
    const Real pass = larger(miss - larger(cross(bend, w), cross(w, bend)), Real(0));
    const Real aside = pass * pass - reach_square_ * dot(w, w);
    return larger(ahead, aside);
  }

  /// The same where neither ball accelerates. Those that do not approach never meet, even if they
  /// touch.
  Real separation(BasicVec2<Real> d, BasicVec2<Real> w, Real span) const {
    const Real square = dot(d, d);
    const Real approach = dot(d, w);
    const Real left = larger(square + approach * span, Real(0));
    const Real ahead = left * left - reach_square_ * square;
    const Real miss = cross(d, w);
    const Real aside = miss * miss - reach_square_ * dot(w, w);
    return larger(approach, larger(ahead, aside));
  }

  Real time(const Path<Real>& a, const Path<Real>& b) const {
    return contact_time(a, b, diameter_);
  }

 private:
  /// Far above rounding, far below anything that matters for speed.
  static constexpr double margin = 1 + 1e-5;

  Real diameter_;
  Real reach_square_;
};

}  // namespace breakshot::physics
