// What the stepping methods have in common. A method is a calendar for the loop of common/physics:
// it says when contacts are due, and that is all in which methods differ. Cloth, rails, response,
// pockets and the shot that is written are those of exact simulation, and so is the motion between
// contacts: every ball follows its closed form, and its phases end when they end.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/physics/appointment.hpp"
#include "common/physics/touching.hpp"
#include "common/study/sweep.hpp"

namespace breakshot::study {

template <class Real>
class StepCalendar {
 public:
  using Vec = physics::BasicVec2<Real>;
  using Path = physics::Path<Real>;
  using Appointment = physics::Appointment<Real>;

  StepCalendar(const physics::Laws<Real>& laws, Real top_speed, std::size_t balls)
      : laws_(laws), top_speed_(top_speed), paths_(balls), places_(balls), sweep_(balls) {}

  /// Steps end at whole multiples of this; the only one without end takes all in one step.
  void set_step(Real step_s) { step_s_ = step_s; }

  const Path& path(std::size_t ball) const { return paths_[ball]; }
  Real top_speed() const { return top_speed_; }
  bool moving() const { return moving_ + spinning_ > 0; }
  void move_to(Real time_s) { now_s_ = time_s; }

  template <class OnDue>
  void each_due(Real /*time_s*/, const OnDue& due) const {
    for (const auto& [ball, appointment] : due_) due(ball, appointment);
  }

  /// Every other ball, ascending, whose centre is within `reach` of that of `ball`.
  template <class OnNear>
  void each_near(std::uint32_t ball, Real reach, const OnNear& near) {
    const Vec place = place_of(ball);
    near_.clear();
    const auto look_at = [&](std::uint32_t other) {
      const Vec d = place_of(other) - place;
      if (other != ball && dot(d, d) <= reach * reach) near_.push_back(other);
    };
    if (swept_at_s_ == now_s_) {
      // Putting back has moved no ball by more than a diameter since they were put in order.
      const Real wide = reach + 2 * laws_.diameter;
      sweep_.each_between(place.x - wide, place.x + wide, look_at);
      std::sort(near_.begin(), near_.end());
    } else {
      for (std::uint32_t other = 0; other < paths_.size(); ++other) look_at(other);
    }
    for (const std::uint32_t other : near_) near(other);
  }

  void set(std::uint32_t ball, const Path& path) {
    using physics::Phase;
    const Phase before = paths_[ball].segment.phase;
    const Phase after = path.segment.phase;
    moving_ = moving_ + !is_still(after) - !is_still(before);
    spinning_ = spinning_ + (after == Phase::spin) - (before == Phase::spin);
    paths_[ball] = path;
    places_[ball] = path.segment.position;
    if (after == Phase::pocketed) sweep_.remove(ball);
  }

 protected:
  struct Due {
    std::uint32_t ball;
    Appointment appointment;
  };

  bool present(std::uint32_t ball) const {
    return paths_[ball].segment.phase != physics::Phase::pocketed;
  }
  bool still(std::uint32_t ball) const { return is_still(paths_[ball].segment.phase); }

  Real end_of_step(std::uint64_t step) const { return step_s_ * Real(step + 1); }

  /// Forgets what was due, and finds the next end of a phase.
  void begin_anew() {
    due_.clear();
    next_end_s_ = physics::never<Real>;
    for (const Path& path : paths_) next_end_s_ = physics::smaller(next_end_s_, path.end_s);
  }

  /// All phases that end next.
  Real end_phases() {
    due_.clear();
    for (std::uint32_t ball = 0; ball < paths_.size(); ++ball) {
      if (paths_[ball].end_s == next_end_s_ && next_end_s_ < physics::never<Real>) {
        due_.push_back({ball, {next_end_s_, physics::Due::phase_end, 0}});
      }
    }
    return next_end_s_;
  }

  /// Puts all balls where they are at `time_s`, for place_of() and for what follows.
  void place_all(Real time_s) {
    for (std::uint32_t ball = 0; ball < paths_.size(); ++ball) {
      if (!still(ball)) places_[ball] = position_at(paths_[ball].segment, time_s);
    }
  }

  /// Whether a ball comes to meet what rests in direction `d`, beyond rounding.
  bool approaches(std::uint32_t ball, Real time_s, Vec d) const {
    return dot(velocity_at(paths_[ball].segment, time_s), d) >
           physics::unresolved_speed(paths_[ball].speed) * length(d);
  }

  /// Whether two balls that are at their places at `time_s` come to meet one another.
  bool approach_one_another(std::uint32_t a, std::uint32_t b, Real time_s) const {
    const Vec d = places_[b] - places_[a];
    const Vec velocity =
        velocity_at(paths_[a].segment, time_s) - velocity_at(paths_[b].segment, time_s);
    return dot(velocity, d) >
           physics::unresolved_speed(paths_[a].speed + paths_[b].speed) * length(d);
  }

  /// Moves a ball aside: its path goes on from there.
  void displace(std::uint32_t ball, Vec by) {
    paths_[ball].segment.position = paths_[ball].segment.position + by;
    places_[ball] = places_[ball] + by;
  }

  /// Two balls that overlap touch, each having given way by as much.
  void put_back(std::uint32_t a, std::uint32_t b) {
    const Vec d = places_[b] - places_[a];
    const Real distance = length(d);
    if (!(distance < laws_.diameter) || !(distance > 0)) return;
    const Vec by = d * ((laws_.diameter - distance) / (2 * distance));
    displace(a, -by);
    displace(b, by);
  }

  /// A ball that overlaps a cushion touches it.
  void put_back_from_cushion(std::uint32_t ball, std::uint32_t cushion) {
    if (cushion < laws_.noses.size()) {
      const physics::Nose<Real>& nose = laws_.noses[cushion];
      const Real gap = dot(places_[ball] - nose.from, nose.inward) - laws_.radius;
      if (gap < 0) displace(ball, nose.inward * -gap);
      return;
    }
    const physics::Arc<Real>& arc = laws_.arcs[cushion - laws_.noses.size()];
    const Vec d = places_[ball] - arc.centre.segment.position;
    const Real distance = length(d);
    if (distance < arc.distance && distance > 0) {
      displace(ball, d * ((arc.distance - distance) / distance));
    }
  }

  /// In the order in which they are due: what overlaps gives way.
  void put_all_back() {
    for (const Due& due : due_) {
      if (due.appointment.due == physics::Due::ball) put_back(due.ball, due.appointment.with);
      if (due.appointment.due == physics::Due::cushion) {
        put_back_from_cushion(due.ball, due.appointment.with);
      }
    }
  }

  void add_due(std::uint32_t ball, Real time_s, physics::Due due, std::uint32_t with) {
    due_.push_back({ball, {time_s, due, with}});
  }

  void sort_due() {
    std::sort(due_.begin(), due_.end(), [](const Due& p, const Due& q) {
      if (p.ball != q.ball) return p.ball < q.ball;
      if (p.appointment.due != q.appointment.due) return p.appointment.due < q.appointment.due;
      return p.appointment.with < q.appointment.with;
    });
  }

  /// Adds what `ball`, which is at its place at `time_s`, overlaps of the rails and moves into.
  void add_overlapped_rails(std::uint32_t ball, Real time_s) {
    const Vec place = places_[ball];
    if (laws_.is_inside(place)) return;
    std::uint32_t cushion = 0;
    for (const physics::Nose<Real>& nose : laws_.noses) {
      const Vec offset = place - nose.from;
      const Real gap = dot(offset, nose.inward) - laws_.radius;
      const Real foot = dot(offset, nose.along);
      // One that is wholly behind a nose has gone through it.
      if (gap < 0 && gap > -laws_.diameter && foot >= 0 && foot <= nose.extent &&
          approaches(ball, time_s, -nose.inward)) {
        add_due(ball, time_s, physics::Due::cushion, cushion);
      }
      ++cushion;
    }
    for (const physics::Arc<Real>& arc : laws_.arcs) {
      const Vec d = arc.centre.segment.position - place;
      if (dot(d, d) < arc.distance * arc.distance && faces(arc, place) &&
          approaches(ball, time_s, d)) {
        add_due(ball, time_s, physics::Due::cushion, cushion);
      }
      ++cushion;
    }
    std::uint32_t hole = 0;
    for (const physics::Drop<Real>& drop : laws_.drops) {
      const Vec d = drop.centre.segment.position - place;
      if (dot(d, d) < drop.radius * drop.radius && approaches(ball, time_s, d)) {
        add_due(ball, time_s, physics::Due::hole, hole);
      }
      ++hole;
    }
  }

  /// Adds two balls that are at their places at `time_s` if they overlap and move into one another.
  void add_overlapped_pair(std::uint32_t a, std::uint32_t b, Real time_s) {
    const Vec d = places_[b] - places_[a];
    if (!(dot(d, d) < laws_.diameter * laws_.diameter)) return;
    if (approach_one_another(a, b, time_s)) add_due(a, time_s, physics::Due::ball, b);
  }

  const physics::Laws<Real>& laws_;
  Real top_speed_;
  Real step_s_ = physics::never<Real>;
  Real now_s_{};
  Real next_end_s_ = physics::never<Real>;   ///< of a phase
  Real swept_at_s_ = -physics::never<Real>;  ///< when the sweep was of this very instant
  std::vector<Path> paths_;
  std::vector<Vec> places_;
  Sweep<Real> sweep_;
  std::vector<Due> due_;
  std::size_t moving_ = 0;
  std::size_t spinning_ = 0;

 private:
  Vec place_of(std::uint32_t ball) const {
    return swept_at_s_ == now_s_ || still(ball) ? places_[ball]
                                                : position_at(paths_[ball].segment, now_s_);
  }

  std::vector<std::uint32_t> near_;
};

}  // namespace breakshot::study
