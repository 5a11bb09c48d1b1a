// The table calendar: for every ball the earliest event that is known of it, no heap. After an
// event the balls that changed are compared with all others, which is O(N) and fastest for few
// balls.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/physics/pair_detector.hpp"

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
        pairs_(laws.diameter),
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
    const Body<Real> body = bodies[i];
    if (!body.present) return;
    const std::size_t balls = bodies.size();
    for (std::size_t j = 0; j < balls; ++j) {
      const Body<Real>& other = bodies[j];
      if ((body.rests && other.rests) || fresh_[j] == Freshness::met || j == i) continue;
      const Real until = next_[i].time_s < next_[j].time_s ? next_[i].time_s : next_[j].time_s;
      if (pairs_.stay_apart(body, other, until - now_s) || !other.present) continue;
      meet(i, j);
    }
    fresh_[i] = Freshness::met;
  }

  void meet(std::size_t i, std::size_t j) {
    const Real t = pairs_.time(paths_[std::min(i, j)], paths_[std::max(i, j)]);
    if (t < next_[i].time_s) next_[i] = {t, Due::ball, static_cast<std::uint32_t>(j)};
    if (t < next_[j].time_s) next_[j] = {t, Due::ball, static_cast<std::uint32_t>(i)};
  }

  enum class Freshness : std::uint8_t { known, changed, met };

  const Laws<Real>& laws_;
  Real top_speed_;
  PairDetector<Real> pairs_;
  std::vector<Path<Real>> paths_;
  std::vector<Appointment<Real>> next_;
  std::vector<Appointment<Real>> own_;
  std::vector<Freshness> fresh_;
  std::vector<std::size_t> changed_;
  std::vector<std::size_t> stale_;
};

}  // namespace breakshot::physics
