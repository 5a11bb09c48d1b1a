// Detection as the calendars ask for it: first whether a pair matters at all, then when it meets.
#pragma once

#include "common/physics/body.hpp"
#include "common/physics/detect.hpp"

namespace breakshot::physics {

template <class Real>
class PairDetector {
 public:
  explicit PairDetector(Real diameter)
      : diameter_(diameter), reach_square_(diameter * Real(margin) * (diameter * Real(margin))) {}

  /// Whether two balls certainly do not come to meet within `span` seconds: two axes that may
  /// separate them, the line of centres and the normal of their relative velocity. Balls that touch
  /// are never apart on either. A margin covers rounding, so that what is decided here never
  /// differs from what contact_time would say.
  bool stay_apart(const Body<Real>& a, const Body<Real>& b, Real span) const {
    const BasicVec2<Real> d = b.position - a.position;
    const BasicVec2<Real> w = b.velocity - a.velocity;
    const Real closing = dot(d, w);
    const Real miss = cross(d, w);
    const Real passing = reach_square_ * dot(w, w);
    if (a.rests || b.rests) {  // a deceleration towards rest only keeps balls apart
      return closing >= 0 || miss * miss > passing || beyond_reach(d, closing * span);
    }
    const BasicVec2<Real> bend = (b.acceleration - a.acceleration) * (span * span / 2);
    const Real sag = dot(d, bend);
    const Real drop = (closing < 0 ? closing * span : Real(0)) + (sag < 0 ? sag : Real(0));
    if (beyond_reach(d, drop)) return true;
    const Real nearest = magnitude(miss) - magnitude(cross(bend, w));
    return nearest > 0 && nearest * nearest > passing;
  }

  Real time(const Path<Real>& a, const Path<Real>& b) const {
    return contact_time(a, b, diameter_);
  }

 private:
  /// Far above rounding, far below anything that matters for speed.
  static constexpr double margin = 1 + 1e-6;

  /// |d|^2 + drop > reach |d|.
  bool beyond_reach(BasicVec2<Real> d, Real drop) const {
    const Real square = dot(d, d);
    const Real left = square + drop;
    return left > 0 && left * left > reach_square_ * square;
  }

  Real diameter_;
  Real reach_square_;
};

}  // namespace breakshot::physics
