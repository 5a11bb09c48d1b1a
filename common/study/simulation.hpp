// A shot by any method in any number type, behind one face: what physics::Simulation is for the
// exact method in double, whose bits it gives.
#pragma once

#include <memory>
#include <variant>

#include "common/physics/loop.hpp"
#include "common/study/method.hpp"
#include "common/study/reference.hpp"

namespace breakshot::study {

/// A shot with all digits that any number type here has.
using WideShot = physics::BasicShot<Reference>;

struct Input {
  const physics::Scene& scene;
  const physics::State& state;
  const std::optional<physics::Strike>& strike;
  const physics::ShotSeed& seed;
  const physics::Limits& limits;
};

/// A simulation that is going on, whatever its method and its numbers.
class Running {
 public:
  Running() = default;
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  virtual ~Running() = default;

  virtual physics::Progress advance_to(double time_s) = 0;
  virtual physics::Shot shot() const = 0;
  virtual WideShot wide_shot() const = 0;
  virtual std::variant<physics::Shot, physics::Stalled> take() = 0;
};

class Simulation {
 public:
  /// The input must be free of faults, and the method must not be refused for its scene.
  Simulation(const Method& method, Scalar scalar, const Input& input);

  /// As physics::Simulation: all events up to and including `time_s`.
  physics::Progress advance_to(double time_s) { return running_->advance_to(time_s); }
  /// What has happened so far; complete once finished.
  physics::Shot shot() const { return running_->shot(); }
  WideShot wide_shot() const { return running_->wide_shot(); }
  /// What has happened up to `time_s`, to which the simulation has advanced.
  physics::Shot shot_until(double time_s) const;
  /// The outcome of a finished or stalled simulation, which is used up.
  std::variant<physics::Shot, physics::Stalled> take() && { return running_->take(); }

 private:
  std::unique_ptr<Running> running_;
};

/// One number type's simulations; defined for those of `Scalar`, each compiled on its own.
template <class Real>
std::unique_ptr<Running> running_in(const Method& method, const Input& input);

extern template std::unique_ptr<Running> running_in<float>(const Method&, const Input&);
extern template std::unique_ptr<Running> running_in<double>(const Method&, const Input&);
extern template std::unique_ptr<Running> running_in<long double>(const Method&, const Input&);
extern template std::unique_ptr<Running> running_in<Reference>(const Method&, const Input&);

}  // namespace breakshot::study
