// Constant step, continuous detection inside it ("swept" or "continuous collision detection" in
// game engines; Ericson 2005, "Real-Time Collision Detection", 5.5). Within a step every ball is
// taken to move evenly along the chord of its path, so that the first contact of each pair is a
// quadratic; the balls of the earliest are put where their chords meet, and what is left of the
// step is taken anew for all. A chord is up to a dt^2 / 8 away from its path: contacts are wrong by
// that (second order in the step), and exact without friction. Nothing tunnels.
//
// A contact that parts and is pressed together again inside one step is not seen by chords. It is
// met at the end of the step, as with a fixed step, if it overlaps then.
#pragma once

#include "common/study/step_calendar.hpp"

namespace breakshot::study {

template <class Real>
class SweptCalendar : public StepCalendar<Real> {
 public:
  using Base = StepCalendar<Real>;
  using typename Base::Path;
  using typename Base::Vec;

  SweptCalendar(const physics::Laws<Real>& laws, Real top_speed, std::size_t balls)
      : Base(laws, top_speed, balls),
        own_events_(laws, top_speed),
        detector_(laws.diameter, top_speed, laws.finder),
        chords_(balls) {}

  /// What changed at this instant is followed from this instant.
  void update() {
    this->begin_anew();
    clear_until_s_ = this->now_s_;
  }

  Real earliest(Real limit_s) {
    if (!due_.empty()) return due_.front().appointment.time_s;
    if (this->moving_ == 0) return this->end_phases();
    for (;;) {
      while (this->end_of_step(step_) <= clear_until_s_) ++step_;
      if (next_end_s_ <= clear_until_s_) return this->end_phases();
      if (clear_until_s_ > limit_s) return clear_until_s_;
      const Real end = physics::smaller(this->end_of_step(step_), next_end_s_);
      look_along(clear_until_s_, end);
      if (!due_.empty()) return due_.front().appointment.time_s;
      clear_until_s_ = end;
    }
  }

 private:
  /// Finds the first contacts after `from` and up to `end`.
  void look_along(Real from, Real end) {
    first_s_ = physics::never<Real>;
    pressed_pairs_.clear();
    pressed_balls_.clear();
    this->place_all(from);
    for (std::uint32_t ball = 0; ball < chords_.size(); ++ball) {
      if (this->present(ball)) lay_chord(ball, from, end);
    }
    for (std::uint32_t ball = 0; ball < chords_.size(); ++ball) {
      if (this->present(ball) && !this->still(ball)) meet_rails(ball, from, end);
    }
    if (laws_.ball_ball) {
      this->sweep_.sort();
      this->sweep_.each_pair([&](std::uint32_t a, std::uint32_t b) {
        if (!this->still(a) || !this->still(b)) meet_pair(a, b, from, end);
      });
    }
    if (first_s_ < physics::never<Real>) {
      put_on_chords();
    } else {
      meet_pressed(end);
    }
    this->sort_due();
    this->put_all_back();
  }

  void lay_chord(std::uint32_t ball, Real from, Real end) {
    const physics::BasicSegment<Real>& s = this->paths_[ball].segment;
    const Vec start = places_[ball];
    const Vec stop = this->still(ball) ? start : position_at(s, end);
    Path& chord = chords_[ball];
    chord.segment = {s.ball, s.phase, from, start, (stop - start) / (end - from), {}, {}, {}};
    chord.speed = length(chord.segment.velocity);
    chord.end_s = end;
    const Real& radius = laws_.radius;
    this->sweep_.set(ball, physics::smaller(start.x, stop.x) - radius,
                     physics::larger(start.x, stop.x) + radius);
  }

  void meet_rails(std::uint32_t ball, Real from, Real end) {
    const auto own = own_events_.next(chords_[ball]);
    if (own.due == physics::Due::phase_end || own.due == physics::Due::nothing) return;
    if (own.time_s <= from && own.due == physics::Due::cushion &&
        !this->approaches(ball, from, outward(ball, own.with))) {
      pressed_balls_.push_back(ball);
    } else if (own.time_s <= end) {
      meet(ball, own.time_s, own.due, own.with);
    }
  }

  /// Towards the cushion.
  Vec outward(std::uint32_t ball, std::uint32_t cushion) const {
    if (cushion < laws_.noses.size()) return -laws_.noses[cushion].inward;
    return laws_.arcs[cushion - laws_.noses.size()].centre.segment.position - places_[ball];
  }

  void meet_pair(std::uint32_t a, std::uint32_t b, Real from, Real end) {
    const physics::BasicSegment<Real>& p = chords_[a].segment;
    const physics::BasicSegment<Real>& q = chords_[b].segment;
    const Vec d = q.position - p.position;
    if (detector_.separation(d, q.velocity - p.velocity, end - from) > 0) return;
    const Real t = detector_.time(chords_[a], chords_[b]);
    if (!(t <= end)) return;
    if (t <= from && !this->approach_one_another(a, b, from)) {
      pressed_pairs_.push_back({a, b});
    } else {
      meet(a, t, physics::Due::ball, b);
    }
  }

  void meet(std::uint32_t ball, Real time_s, physics::Due due, std::uint32_t with) {
    if (time_s > first_s_) return;
    if (time_s < first_s_) due_.clear();
    first_s_ = time_s;
    this->add_due(ball, time_s, due, with);
  }

  void put_on_chords() {
    this->place_all(first_s_);
    for (const auto& due : due_) {
      put_on_chord(due.ball);
      if (due.appointment.due == physics::Due::ball) put_on_chord(due.appointment.with);
    }
  }

  void put_on_chord(std::uint32_t ball) {
    if (this->still(ball)) return;
    this->displace(ball, position_at(chords_[ball].segment, first_s_) - places_[ball]);
  }

  void meet_pressed(Real end) {
    this->place_all(end);
    for (const std::uint32_t ball : pressed_balls_) this->add_overlapped_rails(ball, end);
    for (const auto& [a, b] : pressed_pairs_) this->add_overlapped_pair(a, b, end);
  }

  using Base::due_;
  using Base::laws_;
  using Base::next_end_s_;
  using Base::places_;

  physics::OwnEvents<Real> own_events_;
  physics::PairDetector<Real> detector_;
  std::vector<Path> chords_;
  std::vector<std::uint32_t> pressed_balls_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pressed_pairs_;
  Real first_s_ = physics::never<Real>;
  Real clear_until_s_{};
  std::uint64_t step_ = 0;  ///< that is going on
};

}  // namespace breakshot::study
