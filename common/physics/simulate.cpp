#include "common/physics/simulate.hpp"

#include "common/physics/simulation.hpp"

namespace breakshot::physics {

template class Loop<double, CellCalendar>;
template class BasicSimulation<double>;

std::variant<Shot, Stalled> simulate(const Scene& scene, const State& state,
                                     const std::optional<Strike>& strike, const ShotSeed& seed,
                                     const Limits& limits) {
  Simulation simulation(scene, state, strike, seed, limits);
  simulation.advance_to(never<double>);
  return std::move(simulation).take();
}

bool may_never_rest(const Scene& scene) {
  if (const auto* straight = std::get_if<Straight>(&scene.bed.motion)) {
    return straight->sliding_friction == 0 || straight->rolling_friction == 0;
  }
  const auto* spinning = std::get_if<Spinning>(&scene.bed.motion);
  return spinning == nullptr || spinning->sliding_friction == 0 ||
         spinning->rolling_friction == 0 || spinning->spin_friction == 0;
}

}  // namespace breakshot::physics
