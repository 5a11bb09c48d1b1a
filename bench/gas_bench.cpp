// Gases: frictionless elastic discs that cover a fifth of a box with mirror cushions. What an event
// costs for few and for very many, and with either calendar.
#include <benchmark/benchmark.h>

#include <ctime>
#include <limits>

#include "common/physics/simulation.hpp"
#include "tests/support/gases.hpp"

namespace breakshot::bench {
namespace {

constexpr double cover = 0.2;
/// Events that are counted in one run; every one is stored.
constexpr std::size_t events_a_run = 200'000;

/// Processor time of this thread, s: a shared machine takes the processor away at any time.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

physics::Limits limit(std::size_t events) {
  physics::Limits limits;
  limits.max_events = events;
  limits.horizon_s = 1e9;
  return limits;
}

/// Events a second, placing the discs and their first appointments left out.
template <class Simulation>
void gas(benchmark::State& state) {
  const auto discs = static_cast<std::size_t>(state.range(0));
  const support::Gas gas = support::gas_in_a_box(discs, cover, 1);

  // A disc has about nine events a second: the first part is that of the wanted number.
  const double start_s = 0.3;
  double spent = 0;
  std::size_t events = 0;
  for (auto _ : state) {
    Simulation simulation(gas.scene, gas.state, std::nullopt, {}, limit(20 * discs + events_a_run));
    simulation.advance_to(start_s);
    const std::size_t already = simulation.shot().events.size();
    const double from = thread_seconds();
    simulation.advance_to(std::numeric_limits<double>::infinity());
    spent += thread_seconds() - from;
    events += simulation.shot().events.size() - already;
  }
  state.counters["events_s"] = static_cast<double>(events) / spent;
  state.counters["event_ns"] = 1e9 * spent / static_cast<double>(events);
}

void at_a_table(benchmark::State& state) {
  gas<physics::Loop<double, physics::TableCalendar>>(state);
}
void in_cells(benchmark::State& state) {
  gas<physics::Loop<double, physics::CellCalendar>>(state);
}
void chosen(benchmark::State& state) {
  gas<physics::Simulation>(state);
}

BENCHMARK(chosen)->Arg(16)->Arg(1'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
// The crossover: most_balls_at_a_table.
BENCHMARK(at_a_table)->DenseRange(16, 128, 16)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(in_cells)->DenseRange(16, 128, 16)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace breakshot::bench

BENCHMARK_MAIN();
