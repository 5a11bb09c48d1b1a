// A shot that can be advanced in slices: the loop, with the calendar that is the faster one for so
// many balls.
#pragma once

#include <utility>
#include <variant>

#include "common/physics/calendar.hpp"
#include "common/physics/cell_calendar.hpp"
#include "common/physics/loop.hpp"

namespace breakshot::physics {

/// Up to this many balls the table calendar is the faster one; the outcome has the same bits.
/// Nanoseconds an event of table and cells: gases of bench/gas_bench.cpp, 16 discs 322 and 493,
/// 32 discs 411 and 521, 48 discs 498 and 528, 64 discs 577 and 535; breaks with the full model,
/// 16 balls 416 and 593, 29 balls 464 and 560, 46 balls 519 and 556, 56 balls 628 and 592.
inline constexpr std::size_t most_balls_at_a_table = 48;

template <class Real>
class BasicSimulation {
 public:
  /// The input must be free of faults. A strike sets its ball in motion at time 0.
  BasicSimulation(const Scene& scene, const State& state, const std::optional<Strike>& strike,
                  const ShotSeed& seed, const Limits& limits)
      : loop_(loop_for(scene, state, strike, seed, limits)) {}

  /// Processes all events up to and including `time_s`, an absolute time; earlier ones than the
  /// last change nothing.
  Progress advance_to(Real time_s) {
    return std::visit([time_s](auto& loop) { return loop.advance_to(time_s); }, loop_);
  }

  /// What has happened so far, or since forget(); complete once finished.
  const BasicShot<Real>& shot() const {
    return std::visit([](const auto& loop) -> const BasicShot<Real>& { return loop.shot(); },
                      loop_);
  }

  /// Forgets what happened up to the last advance, so that a simulation without an end needs no
  /// more memory than its slices: shot() then begins with what comes next. Forgotten events still
  /// count towards the limit.
  void forget() {
    std::visit([](auto& loop) { loop.forget(); }, loop_);
  }

  /// What has happened up to `time_s`, to which the simulation has advanced.
  BasicShot<Real> shot_until(Real time_s) const {
    BasicShot<Real> shot = this->shot();
    shot.stop = Stop::horizon;
    shot.end_s = time_s;
    return shot;
  }

  /// The outcome of a finished or stalled simulation, which is used up.
  std::variant<BasicShot<Real>, BasicStalled<Real>> take() && {
    return std::visit([](auto& loop) { return std::move(loop).take(); }, loop_);
  }

 private:
  using Table = Loop<Real, TableCalendar>;
  using Cellular = Loop<Real, CellCalendar>;
  using Either = std::variant<Table, Cellular>;

  template <class... Input>
  static Either loop_for(const Scene& scene, const State& state, const Input&... input) {
    if (state.balls.size() <= most_balls_at_a_table) {
      return Either(std::in_place_type<Table>, scene, state, input...);
    }
    return Either(std::in_place_type<Cellular>, scene, state, input...);
  }

  Either loop_;
};

using Simulation = BasicSimulation<double>;
extern template class Loop<double, TableCalendar>;
extern template class Loop<double, CellCalendar>;
extern template class BasicSimulation<double>;

}  // namespace breakshot::physics
