// The loops of common/physics under the calendars of all methods, for one number type.
#pragma once

#include <utility>

#include "common/physics/simulation.hpp"
#include "common/study/fixed.hpp"
#include "common/study/literal.hpp"
#include "common/study/shots.hpp"
#include "common/study/simulation.hpp"
#include "common/study/swept.hpp"

namespace breakshot::study {

/// `Engine` is a loop, or the choice of two.
template <class Real, class Engine>
class RunningIn final : public Running {
 public:
  explicit RunningIn(const Input& input)
      : engine_(input.scene, input.state, input.strike, input.seed, input.limits) {}

  Engine& engine() { return engine_; }

  physics::Progress advance_to(double time_s) override { return engine_.advance_to(Real(time_s)); }
  physics::Shot shot() const override { return shot_as<double>(engine_.shot()); }
  WideShot wide_shot() const override { return shot_as<Reference>(engine_.shot()); }

  std::variant<physics::Shot, physics::Stalled> take() override {
    auto outcome = std::move(engine_).take();
    if (auto* stalled = std::get_if<physics::BasicStalled<Real>>(&outcome)) {
      return physics::Stalled{stalled->cause, std::move(stalled->balls),
                              shot_as<double>(stalled->so_far)};
    }
    return shot_as<double>(std::get<physics::BasicShot<Real>>(outcome));
  }

 private:
  Engine engine_;
};

template <class Real, template <class> class Calendar>
std::unique_ptr<Running> stepping(const Input& input, std::optional<double> step_s) {
  auto running = std::make_unique<RunningIn<Real, physics::Loop<Real, Calendar>>>(input);
  if (step_s) running->engine().calendar().set_step(Real(*step_s));
  return running;
}

template <class Real>
struct MethodIn {
  const Input& input;

  std::unique_ptr<Running> operator()(Exact) const {
    return std::make_unique<RunningIn<Real, physics::BasicSimulation<Real>>>(input);
  }
  std::unique_ptr<Running> operator()(FixedStep m) const {
    return stepping<Real, FixedCalendar>(input, m.step_s);
  }
  std::unique_ptr<Running> operator()(SweptStep m) const {
    return stepping<Real, SweptCalendar>(input, m.step_s);
  }
  std::unique_ptr<Running> operator()(Literal m) const {
    return stepping<Real, LiteralCalendar>(input, m.frame_s);
  }
};

template <class Real>
std::unique_ptr<Running> running_in(const Method& method, const Input& input) {
  return std::visit(MethodIn<Real>{input}, method);
}

}  // namespace breakshot::study
