// The table calendar, for few balls: for every ball the earliest event that is known of it, no
// heap. After an event the balls that changed are compared with all others, which is O(N).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/physics/appointment.hpp"
#include "common/physics/field.hpp"

namespace breakshot::physics {

template <class Real>
class TableCalendar {
 public:
  TableCalendar(const Laws<Real>& laws, Real top_speed, std::size_t balls)
      : laws_(laws),
        top_speed_(top_speed),
        own_events_(laws, top_speed),
        field_(balls, laws.diameter),
        paths_(balls),
        own_(balls),
        next_(balls),
        fresh_(balls) {}

  const Path<Real>& path(std::size_t ball) const { return paths_[ball]; }
  /// Faster than any ball can become, m/s.
  Real top_speed() const { return top_speed_; }

  /// The time of the earliest event of all, or never. Whether that is by `limit_s` makes no
  /// difference here.
  Real earliest(Real /*limit_s*/) const { return field_.earliest(); }

  /// Whether any ball moves, or spins in place.
  bool moving() const { return moving_ + spinning_ > 0; }

  /// Goes on to `time_s`. All that is asked from now on is asked of that instant.
  void move_to(Real time_s) { field_.move_to(time_s); }

  /// Calls `due(ball, appointment)` for every ball, ascending, whose next event is at `time_s`.
  template <class OnDue>
  void each_due(Real time_s, const OnDue& due) const {
    field_.each_due(time_s,
                    [&](std::size_t ball) { due(static_cast<std::uint32_t>(ball), next_[ball]); });
  }

  /// Calls `near(other)` for every other ball, ascending, whose centre is within `reach` of that of
  /// `ball`.
  template <class OnNear>
  void each_near(std::uint32_t ball, Real reach, const OnNear& near) {
    field_.each_within(ball, reach,
                       [&near](std::size_t other) { near(static_cast<std::uint32_t>(other)); });
  }

  /// Gives a ball a new path, which starts at this instant. update() must follow before anything is
  /// asked again.
  void set(std::uint32_t ball, const Path<Real>& path) {
    const Phase before = paths_[ball].segment.phase;
    moving_ = moving_ + !is_still(path.segment.phase) - !is_still(before);
    spinning_ = spinning_ + (path.segment.phase == Phase::spin) - (before == Phase::spin);
    paths_[ball] = path;
    field_.set(ball, path);
    if (fresh_[ball] == Freshness::known) changed_.push_back(ball);
    fresh_[ball] = Freshness::changed;
  }

  /// Predicts anew for the balls that changed at this instant, and for those that had an
  /// appointment with one of them.
  void update() {
    const std::size_t changed = changed_.size();
    std::uint32_t ball = 0;
    for (const Appointment<Real>& next : next_) {
      if (next.due == Due::ball && fresh_[next.with] != Freshness::known &&
          fresh_[ball] == Freshness::known) {
        changed_.push_back(ball);
      }
      ++ball;
    }
    for (std::size_t k = 0; k < changed; ++k)
      own_[changed_[k]] = own_events_.next(paths_[changed_[k]]);
    for (const std::uint32_t i : changed_) meet_first(i, own_[i]);
    if (laws_.ball_ball) {
      // A ball at rest has only those to meet that move and have not met it already.
      std::size_t unmet = moving_;
      for (const std::uint32_t i : changed_) {
        if (is_still(paths_[i].segment.phase)) continue;
        meet_all(i);
        --unmet;
      }
      for (const std::uint32_t i : changed_) {
        if (unmet > 0 && is_still(paths_[i].segment.phase)) meet_all(i);
      }
    }
    for (const std::uint32_t i : changed_) fresh_[i] = Freshness::known;
    changed_.clear();
  }

 private:
  void meet_first(std::uint32_t ball, const Appointment<Real>& appointment) {
    next_[ball] = appointment;
    field_.set_until(ball, appointment.time_s);
  }

  void meet_all(std::uint32_t i) {
    const bool still = is_still(paths_[i].segment.phase);
    fresh_[i] = Freshness::met;
    if (paths_[i].segment.phase == Phase::pocketed) return;
    field_.each_that_may_meet(i, [&](std::size_t other) {
      const auto j = static_cast<std::uint32_t>(other);
      const Phase phase = paths_[j].segment.phase;
      if (fresh_[j] == Freshness::met || phase == Phase::pocketed) return;
      if (still && is_still(phase)) return;
      const Real t = field_.detector().time(paths_[std::min(i, j)], paths_[std::max(i, j)]);
      agree(i, {t, Due::ball, j});
      agree(j, {t, Due::ball, i});
    });
  }

  void agree(std::uint32_t ball, const Appointment<Real>& meeting) {
    if (meeting.time_s > field_.until(ball)) return;
    if (comes_first(meeting, next_[ball])) meet_first(ball, meeting);
  }

  enum class Freshness : std::uint8_t { known, changed, met };

  const Laws<Real>& laws_;
  Real top_speed_;
  OwnEvents<Real> own_events_;
  Field<Real> field_;
  std::vector<Path<Real>> paths_;
  std::vector<Appointment<Real>> own_;  ///< the next event that takes no other ball
  std::vector<Appointment<Real>> next_;
  std::vector<Freshness> fresh_;
  std::size_t moving_ = 0;              ///< balls that change their place
  std::size_t spinning_ = 0;            ///< balls that spin in place
  std::vector<std::uint32_t> changed_;  ///< by a new path; then those whose partner did
};

}  // namespace breakshot::physics
