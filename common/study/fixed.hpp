// Constant step, corrective detection: the paper's section 4.1 and most game engines. At the end of
// every step all pairs are looked at; those that overlap and move into one another are put back
// until they touch, and meet there and then. So a contact comes up to a step too late, at a wrong
// place (first order in the step), and what passes through within a step has not happened: balls
// tunnel through one another, and through cushions, once a step is longer than what is to be hit.
#pragma once

#include "common/study/step_calendar.hpp"

namespace breakshot::study {

template <class Real>
class FixedCalendar : public StepCalendar<Real> {
 public:
  using Base = StepCalendar<Real>;
  using Base::Base;

  void update() { this->begin_anew(); }

  /// The end of the first step with a contact, or of a phase before it; beyond `limit_s` some time
  /// at which there is nothing yet, or never.
  Real earliest(Real limit_s) {
    if (!due_.empty()) return due_.front().appointment.time_s;
    if (this->moving_ == 0) return this->end_phases();
    for (;;) {
      const Real end = this->end_of_step(step_);
      if (next_end_s_ <= end) return this->end_phases();
      if (end > limit_s) return end;
      ++step_;
      look_round(end);
      if (!due_.empty()) return end;
    }
  }

 private:
  void look_round(Real time_s) {
    this->place_all(time_s);
    for (std::uint32_t ball = 0; ball < places_.size(); ++ball) {
      if (!this->present(ball)) continue;
      this->sweep_.set(ball, places_[ball].x - laws_.radius, places_[ball].x + laws_.radius);
      if (!this->still(ball)) this->add_overlapped_rails(ball, time_s);
    }
    this->sweep_.sort();
    this->swept_at_s_ = time_s;
    if (laws_.ball_ball) {
      this->sweep_.each_pair([&](std::uint32_t a, std::uint32_t b) {
        if (!this->still(a) || !this->still(b)) this->add_overlapped_pair(a, b, time_s);
      });
    }
    this->sort_due();
    this->put_all_back();
  }

  using Base::due_;
  using Base::laws_;
  using Base::next_end_s_;
  using Base::places_;

  std::uint64_t step_ = 0;  ///< that is going on
};

}  // namespace breakshot::study
