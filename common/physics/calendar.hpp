// The table calendar, for few balls: for every ball the earliest event that is known of it, no
// heap. After an event the balls that changed are compared with all others, which is O(N).
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
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
        field_(balls, {laws.diameter, top_speed, laws.finder}, !laws.cloth.slows()),
        paths_(balls),
        own_(balls),
        next_(balls),
        versions_(balls),
        version_met_(balls),
        fresh_(balls) {
    changed_.reserve(balls);
    due_.reserve(balls);
  }

  const Path<Real>& path(std::size_t ball) const { return paths_[ball]; }
  /// Faster than any ball can become, m/s.
  Real top_speed() const { return top_speed_; }

  /// The time of the earliest event of all, or never. Whether that is by `limit_s` makes no
  /// difference here.
  Real earliest(Real /*limit_s*/) {
    for (;;) {
      const Real time_s = field_.earliest();
      due_.clear();
      if (time_s == never<Real>) return time_s;
      bool settled = true;
      field_.each_due(time_s, [&](std::size_t number) {
        const auto ball = static_cast<std::uint32_t>(number);
        if (is_stale(ball)) {
          settled = false;
          predict(ball);
        } else {
          due_.push_back(ball);
        }
      });
      if (settled) return time_s;
    }
  }

  /// Whether any ball moves, or spins in place.
  bool moving() const { return moving_ + spinning_ > 0; }

  /// Goes on to `time_s`. All that is asked from now on is asked of that instant.
  void move_to(Real time_s) { field_.move_to(time_s); }

  /// Calls `due(ball, appointment)` for every event at `time_s`, the time that earliest() has just
  /// given, ascending by the lowest ball that takes part.
  template <class OnDue>
  void each_due(Real /*time_s*/, const OnDue& due) {
    if (is_one_meeting()) {
      due(due_.front(), next_[due_.front()]);
      return;
    }
    if (due_.size() > 1) {
      std::sort(due_.begin(), due_.end(), [this](std::uint32_t a, std::uint32_t b) {
        return std::pair(lowest_of(a), a) < std::pair(lowest_of(b), b);
      });
    }
    for (const std::uint32_t ball : due_) due(ball, next_[ball]);
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
    copy_in_parts(path, paths_[ball]);
    field_.set(ball, path);
    ++versions_[ball];
    if (fresh_[ball] == Freshness::known) changed_.push_back(ball);
    fresh_[ball] = Freshness::changed;
  }

  /// Predicts anew for the balls that changed at this instant.
  void update() {
    for (const std::uint32_t i : changed_) {
      own_[i] = own_events_.next(paths_[i]);
      meet_first(i, own_[i]);
    }
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
  bool is_stale(std::uint32_t ball) const {
    const Appointment<Real>& next = next_[ball];
    return next.due == Due::ball && versions_[next.with] != version_met_[ball];
  }

  void predict(std::uint32_t ball) {
    meet_first(ball, own_[ball]);
    meet_all(ball);
    fresh_[ball] = Freshness::known;
  }

  void meet_first(std::uint32_t ball, const Appointment<Real>& appointment) {
    // One by one, as they were written: read together, what was written in parts has to wait.
    const auto [time_s, due, with] = appointment;
    next_[ball].time_s = time_s;
    next_[ball].due = due;
    next_[ball].with = with;
    version_met_[ball] = versions_[due == Due::ball ? with : ball];
    field_.set_until(ball, time_s);
  }

  void meet_all(std::uint32_t i) {
    const bool moves = !is_still(paths_[i].segment.phase);
    fresh_[i] = Freshness::met;
    if (paths_[i].segment.phase == Phase::pocketed) return;
    field_.each_that_may_meet(i, [&](std::size_t other) {
      const auto j = static_cast<std::uint32_t>(other);
      if (fresh_[j] == Freshness::met) return;
      const Real until_s = smaller(field_.until(i), field_.until(j));
      const Real t =
          field_.detector().time(paths_[std::min(i, j)], paths_[std::max(i, j)], until_s);
      if (moves) agree(i, {t, Due::ball, j});
      if (!is_still(paths_[j].segment.phase)) agree(j, {t, Due::ball, i});
    });
  }

  /// Takes down what a moving ball meets, if that comes first. A ball at rest does not take part in
  /// this, whoever is about to hit it: its next event is that of the other one. Only where that one
  /// has another event at the very time, of which it can note one, the ball at rest notes it.
  void agree(std::uint32_t ball, Appointment<Real> meeting) {
    const Real until = field_.until(ball);
    if (meeting.time_s > until || meeting.time_s == never<Real>) return;
    if (meeting.time_s < until) {
      meet_first(ball, meeting);
    } else if (!is_stale(ball)) {
      Appointment<Real> other = next_[ball];
      if (comes_first(meeting, other)) {
        std::swap(meeting, other);
        meet_first(ball, other);
      }
      if (meeting.due != Due::ball || !is_still(paths_[meeting.with].segment.phase)) return;
      const Appointment<Real> back{meeting.time_s, Due::ball, ball};
      if (comes_first(back, next_[meeting.with])) meet_first(meeting.with, back);
    }
  }

  /// Whether all that is due is that two balls meet, as both of them have it.
  bool is_one_meeting() const {
    if (due_.size() != 2) return false;
    const Appointment<Real>& first = next_[due_.front()];
    const Appointment<Real>& second = next_[due_.back()];
    return first.due == Due::ball && first.with == due_.back() && second.due == Due::ball &&
           second.with == due_.front();
  }

  std::uint32_t lowest_of(std::uint32_t ball) const {
    const Appointment<Real>& next = next_[ball];
    return next.due == Due::ball ? std::min(ball, next.with) : ball;
  }

  enum class Freshness : std::uint8_t { known, changed, met };

  const Laws<Real>& laws_;
  Real top_speed_;
  OwnEvents<Real> own_events_;
  Field<Real> field_;
  std::vector<Path<Real>> paths_;
  std::vector<Appointment<Real>> own_;  ///< the next event that takes no other ball
  std::vector<Appointment<Real>> next_;
  std::vector<std::uint32_t> versions_;     ///< how many paths a ball has had
  std::vector<std::uint32_t> version_met_;  ///< of the ball that `next_` is with, then
  std::vector<Freshness> fresh_;
  std::size_t moving_ = 0;              ///< balls that change their place
  std::size_t spinning_ = 0;            ///< balls that spin in place
  std::vector<std::uint32_t> changed_;  ///< by a new path
  std::vector<std::uint32_t> due_;      ///< those with an event at the earliest time
};

}  // namespace breakshot::physics
