// Breaks: a whole shot, and the pairs that detection is asked about in it.
#include <benchmark/benchmark.h>

#include "bench/support.hpp"
#include "bench/timing.hpp"
#include "common/physics/simulation.hpp"
#include "common/physics/timeline.hpp"

namespace breakshot::bench {
namespace {

constexpr std::uint32_t seeds = 1000;

physics::Shot break_of(const wire::Scenario& scenario, std::uint32_t number) {
  auto outcome = physics::simulate(scenario.scene, scenario.state, scenario.strike, seed(number),
                                   scenario.limits);
  return std::get<physics::Shot>(std::move(outcome));
}

/// Median and worst of a thousand seeds, in processor time, and what an event takes: the median of
/// runs of all of them in a row, for reading the clock takes as long as an event does.
void breaks(benchmark::State& state, const char* scene) {
  const wire::Scenario scenario = bench::scenario(scene);
  std::vector<double> times, event_times;
  double events = 0;
  for (auto _ : state) {
    events = 0;
    const double from = thread_seconds();
    for (std::uint32_t number = 0; number < seeds; ++number) {
      events += static_cast<double>(break_of(scenario, number).events.size());
    }
    event_times.push_back((thread_seconds() - from) / events);
    for (std::uint32_t number = 0; number < seeds; ++number) {
      const double before = thread_seconds();
      benchmark::DoNotOptimize(break_of(scenario, number));
      times.push_back(thread_seconds() - before);
    }
  }
  state.counters["shot_median_us"] = 1e6 * median(times);
  state.counters["shot_worst_us"] = 1e6 * *std::max_element(times.begin(), times.end());
  state.counters["events_a_shot"] = events / seeds;
  state.counters["event_us"] = 1e6 * median(event_times);
}
BENCHMARK_CAPTURE(breaks, straight, "break_8ft.json")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(10);
/// Spin, throw, cushions after Han, jaws: ten thousand breaks.
BENCHMARK_CAPTURE(breaks, full_model, "break_8ft_full.json")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(10);

/// One question to detection: two paths, the present, and how long the answer matters.
struct Query {
  physics::Path<double> a;
  physics::Path<double> b;
  double now_s;
  double span_s;
};

physics::Path<double> path_of(const physics::Laws<double>& laws, const physics::Segment& s) {
  physics::Path<double> path =
      laws.cloth.path_from(s.ball, s.start_s, s.position, {s.velocity, s.spin});
  path.segment = s;
  return path;
}

/// Every pair that an event makes the calendar look at: each ball of it against all others, unless
/// both rest, until the next event of either.
class Recorder {
 public:
  explicit Recorder(const wire::Scenario& scenario) : laws_(scenario.scene) {}

  void record(const physics::Shot& shot) {
    const physics::Timeline timeline(shot);
    for (const physics::Segment& fresh : shot.segments) {
      if (fresh.phase == physics::Phase::pocketed || fresh.start_s == 0) continue;
      for (const physics::BallId other : timeline.balls()) {
        const auto& path = timeline.path(other);
        const auto next =
            std::upper_bound(path.begin(), path.end(), fresh.start_s,
                             [](double t, const physics::Segment& s) { return t < s.start_s; });
        const physics::Segment& now = *(next - 1);
        const bool resting =
            now.phase == physics::Phase::rest && fresh.phase == physics::Phase::rest;
        if (other == fresh.ball || now.phase == physics::Phase::pocketed || resting) continue;
        const double until =
            std::min(next_start(timeline.path(fresh.ball), fresh.start_s, shot.end_s),
                     next == path.end() ? shot.end_s : next->start_s);
        queries_.push_back(
            {path_of(laws_, fresh), path_of(laws_, now), fresh.start_s, until - fresh.start_s});
      }
    }
  }

  const std::vector<Query>& queries() const { return queries_; }
  const physics::Laws<double>& laws() const { return laws_; }

 private:
  static double next_start(const std::vector<physics::Segment>& path, double now_s, double end_s) {
    for (const physics::Segment& s : path) {
      if (s.start_s > now_s) return s.start_s;
    }
    return end_s;
  }

  physics::Laws<double> laws_;
  std::vector<Query> queries_;
};

/// What the calendar does for one pair.
double answer(const Query& query, const physics::PairDetector<double>& detector) {
  const physics::Segment& a = query.a.segment;
  const physics::Segment& b = query.b.segment;
  const physics::Vec2 d = position_at(b, query.now_s) - position_at(a, query.now_s);
  const physics::Vec2 w = velocity_at(b, query.now_s) - velocity_at(a, query.now_s);
  const double apart = detector.separation(d, w, b.acceleration - a.acceleration, query.span_s);
  return apart > 0 ? physics::never<double> : detector.time(query.a, query.b);
}

/// The median over recorded queries of the time that one takes, each asked many times in a row.
void pair_detection(benchmark::State& state) {
  const wire::Scenario scenario = bench::scenario("break_8ft.json");
  Recorder recorder(scenario);
  for (std::uint32_t number = 0; number < 20; ++number) {
    recorder.record(break_of(scenario, number));
  }
  const physics::PairDetector<double> detector(
      recorder.laws().diameter, 1 + scenario.strike->speed_m_s, recorder.laws().finder);
  constexpr int repeats = 200;
  std::vector<double> times;
  for (auto _ : state) {
    times.clear();
    for (const Query& query : recorder.queries()) {
      const double before = thread_seconds();
      for (int i = 0; i < repeats; ++i) benchmark::DoNotOptimize(answer(query, detector));
      times.push_back((thread_seconds() - before) / repeats);
    }
  }
  double total = 0;
  for (const double time : times) total += time;
  state.counters["queries"] = static_cast<double>(times.size());
  state.counters["pair_median_ns"] = 1e9 * median(times);
  state.counters["pair_mean_ns"] = 1e9 * total / static_cast<double>(times.size());
  state.counters["pair_worst_ns"] = 1e9 * *std::max_element(times.begin(), times.end());
}
BENCHMARK(pair_detection)->Unit(benchmark::kMillisecond)->Iterations(3);

}  // namespace
}  // namespace breakshot::bench

BENCHMARK_MAIN();
