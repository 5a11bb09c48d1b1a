// The table calendar: for every ball the earliest event that is known of it, no heap. After an
// event the balls that changed are compared with all others, which is O(N) and fastest for few
// balls.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/physics/body.hpp"
#include "common/physics/detect.hpp"

namespace breakshot::physics {

enum class Due : std::uint8_t { nothing, phase_end, cushion, ball };

/// The next event of one ball.
template <class Real>
struct Appointment {
  Real time_s = never<Real>;
  Due due = Due::nothing;
  std::uint32_t with = 0;  ///< the nose or the other ball
};

template <class Real>
class TableCalendar {
 public:
  TableCalendar(const Laws<Real>& laws, Real top_speed, std::size_t balls)
      : laws_(laws),
        top_speed_(top_speed),
        reach_square_(laws.diameter * Real(margin) * (laws.diameter * Real(margin))),
        paths_(balls),
        next_(balls),
        own_(balls),
        fresh_(balls) {}

  const Path<Real>& path(std::size_t ball) const { return paths_[ball]; }
  const Appointment<Real>& next(std::size_t ball) const { return next_[ball]; }
  /// Faster than any ball can become, m/s.
  Real top_speed() const { return top_speed_; }

  /// Gives a ball a new path. update() must follow before next() is asked again.
  void set(std::size_t ball, const Path<Real>& path) {
    paths_[ball] = path;
    if (fresh_[ball] == Freshness::known) changed_.push_back(ball);
    fresh_[ball] = Freshness::changed;
  }

  /// Predicts anew for the balls that changed at `now_s`, and for those that had an appointment
  /// with one of them. `bodies` are all balls at that instant.
  void update(const std::vector<Body<Real>>& bodies, Real now_s) {
    for (std::size_t i = 0; i < next_.size(); ++i) {
      if (next_[i].due != Due::ball || fresh_[i] != Freshness::known) continue;
      if (fresh_[next_[i].with] != Freshness::known) stale_.push_back(i);
    }
    for (const std::size_t i : changed_) {
      own_[i] = own_event(bodies[i], paths_[i]);
      next_[i] = own_[i];
    }
    for (const std::size_t i : stale_) next_[i] = own_[i];
    if (laws_.ball_ball) {
      for (const std::size_t i : changed_) meet_all(bodies, i, now_s);
      for (const std::size_t i : stale_) meet_all(bodies, i, now_s);
    }
    for (const std::size_t i : changed_) fresh_[i] = Freshness::known;
    for (const std::size_t i : stale_) fresh_[i] = Freshness::known;
    changed_.clear();
    stale_.clear();
  }

  /// The earliest event of all, or never.
  Real earliest() const {
    Real time = never<Real>;
    for (const Appointment<Real>& appointment : next_) {
      time = appointment.time_s < time ? appointment.time_s : time;
    }
    return time;
  }

 private:
  Appointment<Real> own_event(const Body<Real>& body, const Path<Real>& path) const {
    Appointment<Real> first;
    if (body.rests) return first;
    if (path.end_s < never<Real>) first = {path.end_s, Due::phase_end, 0};
    for (std::size_t nose = 0; nose < laws_.noses.size(); ++nose) {
      const Real t = cushion_time(path, laws_.noses[nose], laws_.radius, top_speed_);
      if (t < first.time_s) first = {t, Due::cushion, static_cast<std::uint32_t>(nose)};
    }
    return first;
  }

  void meet_all(const std::vector<Body<Real>>& bodies, std::size_t i, Real now_s) {
    const Body<Real>& body = bodies[i];
    if (!body.present) return;
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      const Body<Real>& other = bodies[j];
      if ((body.rests && other.rests) || fresh_[j] == Freshness::met || j == i) continue;
      const Real until = next_[i].time_s < next_[j].time_s ? next_[i].time_s : next_[j].time_s;
      if (stay_apart(body, other, until - now_s) || !other.present) continue;
      const Real t = contact_time(paths_[std::min(i, j)], paths_[std::max(i, j)], laws_.diameter);
      if (t < next_[i].time_s) next_[i] = {t, Due::ball, static_cast<std::uint32_t>(j)};
      if (t < next_[j].time_s) next_[j] = {t, Due::ball, static_cast<std::uint32_t>(i)};
    }
    fresh_[i] = Freshness::met;
  }

  /// Whether two balls certainly do not come to meet within `span` seconds: two axes that may
  /// separate them, the line of centres and the normal of their relative velocity. Balls that touch
  /// are never apart on either. A margin covers rounding, so that what is decided here never
  /// differs from what contact_time would say.
  bool stay_apart(const Body<Real>& a, const Body<Real>& b, Real span) const {
    const BasicVec2<Real> d = b.position - a.position;
    const BasicVec2<Real> w = b.velocity - a.velocity;
    const Real closing = dot(d, w);
    const Real miss = magnitude(cross(d, w));
    const Real passing = reach_square_ * dot(w, w);
    if (a.rests || b.rests) {  // a deceleration towards rest only keeps balls apart
      return closing >= 0 || miss * miss > passing || beyond_reach(d, closing * span);
    }
    const BasicVec2<Real> bend = (b.acceleration - a.acceleration) * (span * span / 2);
    const Real sag = dot(d, bend);
    const Real drop = (closing < 0 ? closing * span : Real(0)) + (sag < 0 ? sag : Real(0));
    if (beyond_reach(d, drop)) return true;
    const Real nearest = miss - magnitude(cross(bend, w));
    return nearest > 0 && nearest * nearest > passing;
  }

  /// |d|^2 + drop > reach |d|.
  bool beyond_reach(BasicVec2<Real> d, Real drop) const {
    const Real square = dot(d, d);
    const Real left = square + drop;
    return left > 0 && left * left > reach_square_ * square;
  }

  /// Far above rounding, far below anything that matters for speed.
  static constexpr double margin = 1 + 1e-6;

  enum class Freshness : std::uint8_t { known, changed, met };

  const Laws<Real>& laws_;
  Real top_speed_;
  Real reach_square_;
  std::vector<Path<Real>> paths_;
  std::vector<Appointment<Real>> next_;
  std::vector<Appointment<Real>> own_;
  std::vector<Freshness> fresh_;
  std::vector<std::size_t> changed_;
  std::vector<std::size_t> stale_;
};

}  // namespace breakshot::physics
