// The table calendar: for every ball the earliest event that is known of it, no heap. After an
// event the balls that changed are compared with all others, which is O(N) and fastest for few
// balls.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

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
  explicit TableCalendar(const Laws<Real>& laws, Real top_speed)
      : laws_(laws), top_speed_(top_speed) {}

  void resize(std::size_t balls) {
    paths_.resize(balls);
    next_.resize(balls);
    own_.resize(balls);
    here_.resize(balls);
    present_.assign(balls, true);
    fresh_.assign(balls, true);
  }

  const Path<Real>& path(std::size_t ball) const { return paths_[ball]; }
  bool present(std::size_t ball) const { return present_[ball]; }
  const Appointment<Real>& next(std::size_t ball) const { return next_[ball]; }
  std::size_t size() const { return paths_.size(); }
  /// Faster than any ball can become, m/s.
  Real top_speed() const { return top_speed_; }

  /// Gives a ball a new path. update() must follow before next() is asked again.
  void set(std::size_t ball, const Path<Real>& path) {
    paths_[ball] = path;
    mark(ball);
  }

  /// Takes a pocketed ball out.
  void remove(std::size_t ball) {
    present_[ball] = false;
    mark(ball);
  }

  /// Predicts anew for the balls that changed at `now_s`, and for those that had an appointment
  /// with one of them.
  void update(Real now_s) {
    for (std::size_t i = 0; i < size(); ++i) {
      const bool stood_up = next_[i].due == Due::ball && fresh_[next_[i].with];
      if (stood_up && !fresh_[i]) stale_.push_back(i);
    }
    look_around(now_s);
    for (const std::size_t i : changed_) {
      own_[i] = own_event(i);
      next_[i] = own_[i];
    }
    for (const std::size_t i : stale_) next_[i] = own_[i];
    if (laws_.ball_ball) {
      for (const std::size_t i : changed_) meet_all(i, now_s);
      for (const std::size_t i : stale_) meet_all(i, now_s);
    }
    for (const std::size_t i : changed_) fresh_[i] = false;
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
  /// What is seen of a ball from the present: a basis for rejections, never for times.
  struct Glimpse {
    BasicVec2<Real> position;
    BasicVec2<Real> velocity;
    BasicVec2<Real> acceleration;
    bool rests = true;
  };

  void mark(std::size_t ball) {
    if (std::find(changed_.begin(), changed_.end(), ball) == changed_.end()) {
      changed_.push_back(ball);
    }
    fresh_[ball] = true;
  }

  void look_around(Real now_s) {
    for (std::size_t i = 0; i < size(); ++i) {
      const BasicSegment<Real>& s = paths_[i].segment;
      here_[i] = {position_at(s, now_s), velocity_at(s, now_s), s.acceleration,
                  s.phase == Phase::rest};
    }
  }

  Appointment<Real> own_event(std::size_t ball) const {
    Appointment<Real> first;
    const Path<Real>& path = paths_[ball];
    if (!present_[ball] || path.segment.phase == Phase::rest) return first;
    if (path.end_s < never<Real>) first = {path.end_s, Due::phase_end, 0};
    for (std::size_t nose = 0; nose < laws_.noses.size(); ++nose) {
      const Real t = cushion_time(path, laws_.noses[nose], laws_.radius, top_speed_);
      if (t < first.time_s) first = {t, Due::cushion, static_cast<std::uint32_t>(nose)};
    }
    return first;
  }

  void meet_all(std::size_t i, Real now_s) {
    if (!present_[i]) return;
    for (std::size_t j = 0; j < size(); ++j) {
      if (j == i || !present_[j] || (here_[i].rests && here_[j].rests)) continue;
      const Real until = next_[i].time_s < next_[j].time_s ? next_[i].time_s : next_[j].time_s;
      if (out_of_reach(here_[i], here_[j], until - now_s)) continue;
      const Real t = contact_time(paths_[std::min(i, j)], paths_[std::max(i, j)], laws_.diameter);
      if (t < next_[i].time_s) {
        next_[i] = {t, Due::ball, static_cast<std::uint32_t>(j)};
      }
      if (t < next_[j].time_s) {
        next_[j] = {t, Due::ball, static_cast<std::uint32_t>(i)};
      }
    }
  }

  /// Whether two balls certainly stay apart for `span` seconds: two axes that may separate them,
  /// the line of centres and the normal of their relative velocity. A margin covers rounding, so
  /// that what is decided here never differs from what contact_time would say.
  bool out_of_reach(const Glimpse& a, const Glimpse& b, Real span) const {
    using std::sqrt;
    const BasicVec2<Real> d = b.position - a.position;
    const BasicVec2<Real> w = b.velocity - a.velocity;
    const BasicVec2<Real> bend = b.acceleration - a.acceleration;
    const Real square = dot(d, d);
    const Real reach = laws_.diameter * margin;
    if (!(square > reach * reach)) return false;
    const Real closing = dot(d, w);
    if (a.rests || b.rests) {
      if (closing >= 0) return true;
      const Real miss = cross(d, w);
      if (miss * miss > reach * reach * dot(w, w)) return true;
    }
    // Along the line of centres: |d|^2 + (d . w) t + (d . bend) t^2 / 2 stays above reach |d|.
    const Real sagging = dot(d, bend);
    const Real floor = reach * sqrt(square);
    if (span < never<Real>) {
      const Real drop = (closing < 0 ? closing * span : Real(0)) +
                        (sagging < 0 ? sagging * span * span / 2 : Real(0));
      if (square + drop > floor) return true;
    } else if (closing >= 0 && sagging >= 0) {
      return true;
    }
    return false;
  }

  /// Far above rounding, far below anything that matters for speed.
  static constexpr double margin = 1 + 1e-6;

  const Laws<Real>& laws_;
  Real top_speed_;
  std::vector<Path<Real>> paths_;
  std::vector<Appointment<Real>> next_;
  std::vector<Appointment<Real>> own_;
  std::vector<Glimpse> here_;
  std::vector<bool> present_;
  std::vector<bool> fresh_;
  std::vector<std::size_t> changed_;
  std::vector<std::size_t> stale_;
};

}  // namespace breakshot::physics
