// Shots from one number type to another.
#pragma once

#include <variant>

#include "common/physics/event.hpp"

namespace breakshot::study {

template <class To>
struct EventAs {
  template <class Real>
  using Event = physics::BasicEvent<Real>;

  template <class Real>
  Event<To> operator()(const physics::BasicStruck<Real>& e) const {
    return physics::BasicStruck<To>{To(e.time_s), e.ball};
  }
  template <class Real>
  Event<To> operator()(const physics::BasicBallBall<Real>& e) const {
    return physics::BasicBallBall<To>{To(e.time_s), e.pass, e.lower, e.higher};
  }
  template <class Real>
  Event<To> operator()(const physics::BasicBallCushion<Real>& e) const {
    return physics::BasicBallCushion<To>{To(e.time_s), e.pass, e.ball, e.cushion};
  }
  template <class Real>
  Event<To> operator()(const physics::BasicBallPocket<Real>& e) const {
    return physics::BasicBallPocket<To>{To(e.time_s), e.pass, e.ball, e.pocket};
  }
  template <class Real>
  Event<To> operator()(const physics::BasicRolls<Real>& e) const {
    return physics::BasicRolls<To>{To(e.time_s), e.ball};
  }
  template <class Real>
  Event<To> operator()(const physics::BasicSpins<Real>& e) const {
    return physics::BasicSpins<To>{To(e.time_s), e.ball};
  }
  template <class Real>
  Event<To> operator()(const physics::BasicRests<Real>& e) const {
    return physics::BasicRests<To>{To(e.time_s), e.ball};
  }
};

template <class To, class Real>
physics::BasicVec2<To> vec_as(const physics::BasicVec2<Real>& v) {
  return {To(v.x), To(v.y)};
}

template <class To, class Real>
physics::BasicVec3<To> vec_as(const physics::BasicVec3<Real>& v) {
  return {To(v.x), To(v.y), To(v.z)};
}

template <class To, class Real>
physics::BasicSegment<To> segment_as(const physics::BasicSegment<Real>& s) {
  return {s.ball,
          s.phase,
          To(s.start_s),
          vec_as<To>(s.position),
          vec_as<To>(s.velocity),
          vec_as<To>(s.acceleration),
          vec_as<To>(s.spin),
          vec_as<To>(s.spin_change)};
}

/// The same shot, every number rounded to `To`.
template <class To, class Real>
physics::BasicShot<To> shot_as(const physics::BasicShot<Real>& shot) {
  physics::BasicShot<To> same;
  same.events.reserve(shot.events.size());
  same.segments.reserve(shot.segments.size());
  for (const auto& event : shot.events) same.events.push_back(std::visit(EventAs<To>{}, event));
  for (const auto& segment : shot.segments) same.segments.push_back(segment_as<To>(segment));
  same.end_s = To(shot.end_s);
  same.stop = shot.stop;
  return same;
}

}  // namespace breakshot::study
