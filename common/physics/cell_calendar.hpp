// The cell calendar, for many balls: the turns of all balls in a heap, and cells of which only the
// neighbours are looked at. What an event costs does not grow with the number of balls, but for the
// height of the heap. (One event a ball, and stale ones known by a counter:
// Bannerman, Sargant and Lue 2011, "DynamO".) Two kinds of appointment are its own affair and are
// seen by nobody: a ball leaves its cell, and a ball finds that the one that it was to meet has
// been diverted.
//
// It finds the same events as the table calendar, bit for bit: when two balls meet is a function of
// their paths alone, whenever it is asked; a pair that is not asked about is too far apart to meet
// before one of the two is looked at again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/physics/appointment.hpp"
#include "common/physics/cells.hpp"
#include "common/physics/courses.hpp"
#include "common/physics/entry.hpp"
#include "common/physics/event_heap.hpp"
#include "common/physics/fetcher.hpp"

namespace breakshot::physics {

template <class Real>
class CellCalendar {
 public:
  CellCalendar(const Laws<Real>& laws, Real top_speed, std::size_t balls)
      : laws_(laws),
        top_speed_(top_speed),
        own_events_(laws, top_speed),
        detector_(laws.diameter, top_speed, laws.finder),
        straight_(!laws.cloth.slows()),
        cells_(balls, laws.diameter),
        heap_(balls),
        courses_(balls, detector_, straight_),
        entries_(balls),
        spins_(laws.cloth.spins() ? balls : 0),
        fetcher_(heap_, cells_, courses_, entries_) {}

  CellCalendar(const CellCalendar&) = delete;
  CellCalendar& operator=(const CellCalendar&) = delete;

  Path<Real> path(std::size_t ball) const {
    const Course<Real>& c = courses_[ball];
    const Entry<Real>& e = entries_[ball];
    Path<Real> path;
    path.segment = {e.id, e.phase, c.start_s, c.position, c.velocity, c.acceleration, {}, {}};
    path.speed = e.speed;
    path.end_s = e.end_s;
    path.curved = e.curved;
    if (!spins_.empty()) {
      path.segment.spin = spins_[ball].at_start;
      path.segment.spin_change = spins_[ball].change;
    }
    return path;
  }

  /// Faster than any ball can become, m/s.
  Real top_speed() const { return top_speed_; }

  /// The time of the earliest event of all; if that is not by `limit_s`, some time after `limit_s`
  /// at which there is none yet, or never.
  Real earliest(Real limit_s) {
    for (;;) {
      const Real time_s = heap_.earliest();
      due_.clear();
      if (time_s > limit_s || time_s == never<Real>) return time_s;
      const std::uint32_t first = heap_.first();
      if (is_internal(first)) {
        now_s_ = time_s;
        attend(first);
        continue;
      }
      if (heap_.first_is_alone()) {
        due_.push_back(first);
        return time_s;
      }
      // What is internal at the very instant comes first: it may bring more events to it.
      bool settled = true;
      heap_.each_earliest([&](std::uint32_t ball) {
        settled = settled && !is_internal(ball);
        due_.push_back(ball);
      });
      if (settled) return time_s;
      now_s_ = time_s;
      for (const std::uint32_t ball : due_) {
        if (heap_.time_of(ball) == time_s && is_internal(ball)) attend(ball);
      }
    }
  }

  /// Whether any ball moves, or spins in place.
  bool moving() const { return moving_ + spinning_ > 0; }

  /// Goes on to `time_s`. All that is asked from now on is asked of that instant.
  void move_to(Real time_s) { now_s_ = time_s; }

  /// Calls `due(ball, appointment)` for every event at `time_s`, the time that earliest() has just
  /// given, ascending by the lowest ball that takes part.
  template <class OnDue>
  void each_due(Real time_s, const OnDue& due) {
    if (due_.size() > 1) {
      std::sort(due_.begin(), due_.end(), [this](std::uint32_t a, std::uint32_t b) {
        return std::pair(lowest_of(a), a) < std::pair(lowest_of(b), b);
      });
    }
    for (const std::uint32_t ball : due_) {
      due(ball, Appointment<Real>{time_s, entries_[ball].due, entries_[ball].with});
    }
  }

  /// Calls `near(other)` for every other ball, ascending, whose centre is within `reach` of that of
  /// `ball`.
  template <class OnNear>
  void each_near(std::uint32_t ball, Real reach, const OnNear& near) {
    if (reach < cells_.reach()) {
      cells_.find_beside(entries_[ball].place, found_);
    } else {
      // Only where rounding is greater than a ball.
      found_.gather_all(entries_.size());
    }
    courses_.find_within(ball, reach, now_s_, found_, likely_);
    for (const std::uint32_t other : likely_) {
      if (other != ball) near(other);
    }
  }

  /// Gives a ball a new path, which starts at this instant. update() must follow before anything is
  /// asked again.
  void set(std::uint32_t ball, const Path<Real>& path) {
    Entry<Real>& entry = entries_[ball];
    const Phase before = entry.phase;
    const Phase after = path.segment.phase;
    moving_ = moving_ + !is_still(after) - !is_still(before);
    spinning_ = spinning_ + (after == Phase::spin) - (before == Phase::spin);
    if (built_ && after == Phase::pocketed && before != Phase::pocketed) {
      cells_.remove(ball, entry.place);
    }
    courses_.set(ball, path.segment);
    entry.set(path);
    if (!spins_.empty()) {
      copy_in_parts(path.segment.spin, spins_[ball].at_start);
      copy_in_parts(path.segment.spin_change, spins_[ball].change);
    }
    changed_.push_back(ball);
  }

  /// Predicts anew for the balls that changed at this instant.
  void update() {
    for (const std::uint32_t ball : changed_) forget(ball);
    give_back_turns();
    if (laws_.ball_ball && built_) {
      changes_ += changed_.size();
      // Of two that have just met, the first has asked about the second.
      const std::uint32_t met = changed_.size() == 2 ? changed_.front() : none;
      for (const std::uint32_t ball : changed_) {
        if (entries_[ball].phase != Phase::pocketed) {
          meet_beside(ball, met);
          plan_crossing(ball);
        } else {
          entries_[ball].crossing_s = never<Real>;
        }
        schedule(ball);
      }
    } else {
      for (const std::uint32_t ball : changed_) {
        foresee(ball, never<Real>);
        schedule(ball);
      }
      if (laws_.ball_ball) build(Real(0));
    }
    changed_.clear();
  }

 private:
  using Vec = BasicVec2<Real>;
  struct Spin {
    BasicVec3<Real> at_start;
    BasicVec3<Real> change;
  };
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  /// With so many crossings for every change of a path and every ball, the cells are too small.
  static constexpr std::size_t crossings_a_change = 16;
  /// What is kept of fewer balls stays in a processor's own caches.
  static constexpr std::size_t most_balls_at_hand = 4096;

  std::uint32_t lowest_of(std::uint32_t ball) const {
    const Entry<Real>& entry = entries_[ball];
    return entry.due == Due::ball ? std::min(ball, entry.with) : ball;
  }

  bool crosses(std::uint32_t ball) const {
    return physics::crosses(entries_[ball], courses_[ball]);
  }
  bool is_internal(std::uint32_t ball) const {
    const Entry<Real>& entry = entries_[ball];
    return crosses(ball) ||
           (entry.due == Due::ball && entries_[entry.with].paths != entry.paths_of_other);
  }

  void attend(std::uint32_t ball) {
    if (crosses(ball)) {
      cross(ball);
    } else {
      forget(ball);
      give_back_turns();
      meet_beside(ball, none);
      schedule(ball);
    }
  }

  /// give_back_turns() must follow.
  void forget(std::uint32_t ball) { note(ball, never<Real>, Due::nothing, none); }

  /// Takes another next event of a ball down. give_back_turns() must follow.
  void note(std::uint32_t ball, Real time_s, Due due, std::uint32_t with) {
    Entry<Real>& entry = entries_[ball];
    if (entry.turn == Turn::calls) left_.push_back(entry.with);
    courses_.set_until(ball, time_s);
    entry.due = due;
    entry.with = with;
    entry.turn = Turn::own;
  }

  /// Those whose meeting was called by a ball that has another event now have their own turn again.
  void give_back_turns() {
    for (const std::uint32_t ball : left_) {
      Entry<Real>& entry = entries_[ball];
      if (entry.turn != Turn::waits) continue;
      const Entry<Real>& caller = entries_[entry.with];
      if (caller.turn == Turn::calls && caller.with == ball) continue;
      entry.turn = Turn::own;
      schedule(ball);
    }
    left_.clear();
  }

  /// Takes down what comes to the ball alone, if that is not after `until_s`.
  void foresee(std::uint32_t ball, Real until_s) {
    const Appointment<Real> own = own_events_.next(mover(ball), until_s);
    if (own.due != Due::nothing && own.time_s <= until_s) {
      note(ball, own.time_s, own.due, own.with);
    }
  }

  void schedule(std::uint32_t ball) {
    const Entry<Real>& entry = entries_[ball];
    const Real time_s = entry.turn == Turn::waits
                            ? entry.crossing_s
                            : smaller(courses_[ball].until_s, entry.crossing_s);
    if (fetches_) {
      heap_.set(ball, time_s, fetcher_);
    } else {
      heap_.set(ball, time_s, [](std::size_t, std::uint32_t) {});
    }
  }

  void cross(std::uint32_t ball) {
    Entry<Real>& entry = entries_[ball];
    cells_.find_ahead(entry.place, entry.side, found_);
    cells_.cross(ball, entry.place, entry.side);
    ++crossings_;
    const Real doubt = 8 * std::numeric_limits<Real>::epsilon() * now_s_ * top_speed_;
    if (crossings_ > crossings_a_change * (entries_.size() + changes_) ||
        !cells_.resolves(position_at(courses_[ball], now_s_), doubt)) {
      build(2 * cells_.side());
      return;
    }
    agree_with_partners(ball, find_partners(ball, none));
    give_back_turns();
    plan_crossing(ball);
    schedule(ball);
  }

  void plan_crossing(std::uint32_t ball) {
    const Course<Real>& m = courses_[ball];
    const Crossing<Real> next = cells_.crossing(entries_[ball].place, position_at(m, now_s_),
                                                velocity_at(m, now_s_), m.acceleration);
    entries_[ball].crossing_s = now_s_ + next.after_s;
    entries_[ball].side = next.side;
  }

  /// Cells round the balls where they are now; appointments stay.
  void build(Real least_side) {
    built_ = true;
    fetches_ = entries_.size() > most_balls_at_hand;
    crossings_ = changes_ = 0;
    const auto present = [this](std::uint32_t ball) {
      return entries_[ball].phase != Phase::pocketed;
    };
    cells_.build(
        least_side, present,
        [this](std::uint32_t ball) { return position_at(courses_[ball], now_s_); },
        [this](std::uint32_t ball) -> Place& { return entries_[ball].place; });
    for (std::uint32_t ball = 0; ball < entries_.size(); ++ball) {
      if (!present(ball)) continue;
      meet_beside(ball, none);
      plan_crossing(ball);
      schedule(ball);
    }
  }

  /// The next event of a ball of which nothing is known, or only its meeting with `met`.
  void meet_beside(std::uint32_t ball, std::uint32_t met) {
    cells_.find_beside(entries_[ball].place, found_);
    const Real first = find_partners(ball, met);
    foresee(ball, first);
    if (!(courses_[ball].until_s < first)) agree_with_partners(ball, first);
    give_back_turns();
  }

  /// Sets `partners_` to those of found_ that `ball` meets first, and gives the time; or to nobody
  /// if all that comes after another event of the ball. What would come after another event of
  /// either need not be known: then they are asked again.
  Real find_partners(std::uint32_t ball, std::uint32_t met) {
    Real first = smaller(courses_[ball].until_s, entries_[ball].end_s);
    partners_.clear();
    courses_.find_likely(ball, first, now_s_, found_, likely_);
    for (const std::uint32_t other : likely_) {
      if (other == ball || other == met) continue;
      const Real t = meeting_time(std::min(ball, other), std::max(ball, other),
                                  smaller(first, courses_[other].until_s));
      if (t > first || t > courses_[other].until_s || t == never<Real>) continue;
      if (t < first) partners_.clear();
      first = t;
      partners_.push_back(other);
    }
    return first;
  }

  Real meeting_time(std::uint32_t lower, std::uint32_t higher, Real until_s) const {
    return detector_.time(mover(lower), mover(higher), until_s);
  }

  CoursePath<Real> mover(std::uint32_t ball) const {
    const Course<Real>& course = courses_[ball];
    if (straight_) return even_path(course);
    const Entry<Real>& entry = entries_[ball];
    return {course, entry.speed, entry.end_s, entry.curved, is_still(entry.phase)};
  }

  /// give_back_turns() must follow.
  void agree_with_partners(std::uint32_t ball, Real time_s) {
    for (const std::uint32_t other : partners_) agree(ball, time_s, other);
    for (const std::uint32_t other : partners_) {
      if (!agree(other, time_s, ball)) continue;
      Entry<Real>& own = entries_[ball];
      if (own.due == Due::ball && own.with == other) {
        own.turn = Turn::calls;
        entries_[other].turn = Turn::waits;
      } else {
        schedule(other);
      }
    }
  }

  /// Takes an appointment with `other` down if it is the next event of `ball`. give_back_turns()
  /// must follow.
  bool agree(std::uint32_t ball, Real time_s, std::uint32_t other) {
    const Appointment<Real> known{courses_[ball].until_s, entries_[ball].due, entries_[ball].with};
    if (!comes_first(Appointment<Real>{time_s, Due::ball, other}, known)) return false;
    note(ball, time_s, Due::ball, other);
    entries_[ball].paths_of_other = entries_[other].paths;
    return true;
  }

  const Laws<Real>& laws_;
  Real top_speed_;
  OwnEvents<Real> own_events_;
  PairDetector<Real> detector_;
  bool straight_;  ///< paths, one as fast as at its start
  Cells<Real> cells_;
  EventHeap<Real> heap_;
  Courses<Real> courses_;
  std::vector<Entry<Real>> entries_;
  std::vector<Spin> spins_;  ///< of their paths, where balls have any
  Fetcher<Real> fetcher_;
  Real now_s_{};
  bool built_ = false;
  bool fetches_ = false;
  std::size_t moving_ = 0;     ///< balls that change their place
  std::size_t spinning_ = 0;   ///< balls that spin in place
  std::size_t crossings_ = 0;  ///< since the cells were built
  std::size_t changes_ = 0;    ///< of paths, likewise
  std::vector<std::uint32_t> changed_;
  std::vector<std::uint32_t> due_;  ///< with a turn at the earliest instant
  // Kept for their memory alone.
  std::vector<std::uint32_t> left_;  ///< that waited for a ball which has another event now
  Gathered found_;
  Gathered likely_;
  std::vector<std::uint32_t> partners_;  ///< all that `ball` meets at one time
};

}  // namespace breakshot::physics
