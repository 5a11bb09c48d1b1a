// Breaks and nothing else, for a tool that counts instructions: two runs of different length differ
// by the breaks alone. Prints how many events there were.
#include <cstdio>
#include <cstdlib>

#include "bench/support.hpp"
#include "common/physics/simulate.hpp"

int main(int argc, char** argv) {
  using namespace breakshot;
  if (argc != 3) {
    std::fprintf(stderr, "usage: count_breaks SCENE.json BREAKS\n");
    return 2;
  }
  const wire::Scenario scenario = bench::scenario(argv[1]);
  const auto breaks = static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10));
  std::size_t events = 0;
  for (std::uint32_t number = 0; number < breaks; ++number) {
    const auto outcome = physics::simulate(scenario.scene, scenario.state, scenario.strike,
                                           bench::seed(number), scenario.limits);
    events += std::get<physics::Shot>(outcome).events.size();
  }
  std::printf("%zu\n", events);
  return 0;
}
