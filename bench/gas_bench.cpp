// Gases: frictionless elastic discs that cover a fifth of a box with mirror cushions. What an event
// costs for few and for very many, and with either calendar.
#include <benchmark/benchmark.h>

#include "bench/timing.hpp"
#include "common/physics/simulation.hpp"
#include "tests/support/gases.hpp"

namespace breakshot::bench {
namespace {

constexpr double cover = 0.2;
/// About so many events are counted in one run, and forgotten after so many: a gas has no end, and
/// who follows one takes what happens as it comes.
constexpr double events_a_run = 200'000;
constexpr double events_a_slice = 500;
/// Time for the grid that a gas starts from to be forgotten, s: a disc has a few events in it.
constexpr double start_s = 0.5;

/// Goes on to `to_s` in slices. The events on the way.
template <class Simulation>
std::size_t follow(Simulation& simulation, double from_s, double to_s) {
  constexpr int slices = static_cast<int>(events_a_run / events_a_slice);
  std::size_t events = 0;
  for (int slice = 1; slice <= slices; ++slice) {
    simulation.forget();
    simulation.advance_to(from_s + (to_s - from_s) * slice / slices);
    events += simulation.shot().events.size();
  }
  return events;
}

/// Events a second; placing the discs, their first appointments and the start are left out.
template <class Simulation>
void gas(benchmark::State& state) {
  const auto discs = static_cast<std::size_t>(state.range(0));
  const support::Gas gas = support::gas_in_a_box(discs, cover, 1);
  physics::Limits limits;
  limits.max_events = 10'000'000;
  limits.horizon_s = 1e9;
  double spent = 0;
  std::size_t events = 0;
  for (auto _ : state) {
    Simulation simulation(gas.scene, gas.state, std::nullopt, {}, limits);
    simulation.advance_to(start_s);
    const std::size_t already = simulation.shot().events.size();
    const double span_s = events_a_run * start_s / static_cast<double>(already);
    const double from = thread_seconds();
    events += follow(simulation, start_s, start_s + span_s);
    spent += thread_seconds() - from;
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
