// The paper's section 4.2 as printed: Progress(T) asks, for every ball and every pair, in how much
// time Tn it meets something if it keeps its velocity (3.1, 3.2); moves all balls by that, slowing
// down (3.3); and lets meet what was to meet, wherever it is by now. Since balls slow down on the
// way they stop short of one another and collide across a gap that grows with the square of Tn; so
// what happens depends on the length of the frames, which the paper says it does not.
//
// Mended only where it would not run, or not stop (design section 2): Tn is the least of all hits;
// hits at one instant are a set; each pair is looked at once, no ball with itself; without a hit
// within T balls move by T, and that is that; a ball that has come to rest stays there; walls are
// met by the surface of the ball, within their extent. Detection is that of common/physics on paths
// of constant velocity: the paper's quadratic, without its cancellation.
#pragma once

#include "common/study/step_calendar.hpp"

namespace breakshot::study {

template <class Real>
class LiteralCalendar : public StepCalendar<Real> {
 public:
  using Base = StepCalendar<Real>;
  using typename Base::Path;

  LiteralCalendar(const physics::Laws<Real>& laws, Real top_speed, std::size_t balls)
      : Base(laws, top_speed, balls), own_events_(laws, top_speed), tangents_(balls) {}

  /// The end of a phase is part of a move: what was asked before it holds.
  void update() {
    const bool collided = met_;
    this->begin_anew();
    if (collided || !asked_) asked_ = met_ = false;
  }

  Real earliest(Real limit_s) {
    if (!due_.empty()) return due_.front().appointment.time_s;
    if (this->moving_ == 0) return this->end_phases();
    for (;;) {
      if (!asked_) ask(physics::larger(this->now_s_, frame_start_s_));
      const Real end = this->end_of_step(frame_);
      const Real next = physics::smaller(first_s_, end);
      if (next_end_s_ <= next) return this->end_phases();
      if (next > limit_s) return next;
      if (first_s_ <= end) {
        due_ = hits_;
        met_ = true;
        return first_s_;
      }
      frame_start_s_ = end;
      ++frame_;
      asked_ = false;
    }
  }

 private:
  using typename Base::Due;

  /// Lines 3 to 12 of the paper's pseudocode.
  void ask(Real from) {
    asked_ = true;
    first_s_ = physics::never<Real>;
    hits_.clear();
    for (std::uint32_t ball = 0; ball < tangents_.size(); ++ball) {
      const physics::BasicSegment<Real>& s = this->paths_[ball].segment;
      Path& tangent = tangents_[ball];
      tangent.segment = {s.ball, s.phase, from, position_at(s, from), velocity_at(s, from),
                         {},     {},      {}};
      tangent.speed = length(tangent.segment.velocity);
    }
    for (std::uint32_t ball = 0; ball < tangents_.size(); ++ball) {
      if (!this->present(ball)) continue;
      const auto own = own_events_.next(tangents_[ball]);
      if (own.due == physics::Due::cushion) hit(ball, own.time_s, own.due, own.with);
      if (laws_.ball_ball) ask_pairs(ball);
    }
  }

  void ask_pairs(std::uint32_t ball) {
    for (std::uint32_t other = ball + 1; other < tangents_.size(); ++other) {
      if (!this->present(other) || (this->still(ball) && this->still(other))) continue;
      const Real t = contact_time(tangents_[ball], tangents_[other], laws_.diameter, laws_.finder);
      if (t < physics::never<Real>) hit(ball, t, physics::Due::ball, other);
    }
  }

  void hit(std::uint32_t ball, Real time_s, physics::Due due, std::uint32_t with) {
    if (time_s > first_s_) return;
    if (time_s < first_s_) hits_.clear();
    first_s_ = time_s;
    hits_.push_back({ball, {time_s, due, with}});
  }

  using Base::due_;
  using Base::laws_;
  using Base::next_end_s_;

  physics::OwnEvents<Real> own_events_;
  std::vector<Path> tangents_;
  std::vector<Due> hits_;
  Real first_s_ = physics::never<Real>;
  Real frame_start_s_{};
  std::uint64_t frame_ = 0;
  bool asked_ = false;  ///< since the last collision or frame
  bool met_ = false;    ///< what was asked for has come
};

}  // namespace breakshot::study
