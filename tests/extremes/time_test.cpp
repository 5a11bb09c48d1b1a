// Times at the edges: none, tiny ones, endless ones; slices; back in time; states taken out and put
// back.
#include "common/physics/simulation.hpp"
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

/// Six balls and a spinning cue ball on the full table.
struct Played {
  Scene scene = full_table();
  State state;
  Strike strike{BallId{0}, {1, 0}, 4, {0.2, -0.3}};

  explicit Played(std::uint32_t seed) {
    Chance chance(seed);
    while (state.balls.size() < 7) {
      state.balls.push_back(ball(static_cast<std::uint32_t>(state.balls.size()),
                                 {chance.between(-1.1, 1.1), chance.between(-0.5, 0.5)}));
      if (!faults_of(scene, state).empty()) state.balls.pop_back();
    }
    const Vec2 way = state.balls[1].position - state.balls[0].position;
    strike.direction = way * (1 / length(way));
  }
};

TEST(Time, OfZeroShowsTheInput) {
  for (const Scene& scene : every_table()) {
    const State state = racked(scene, 1e-4);
    Simulation simulation(scene, state, Strike{BallId{0}, {1, 0}, 5, {}}, {}, until(1));
    EXPECT_EQ(simulation.advance_to(0), Progress::paused);
    const Shot none = simulation.shot_until(0);
    EXPECT_EQ(none.events.size(), 1u);
    EXPECT_EQ(none.end_s, 0);
    for (const BallState& b : Timeline(none).states(0)) {
      EXPECT_EQ(b.position, state.balls[number(b.id)].position) << name_of(scene);
    }
  }
}

TEST(Time, Of1e18SecondsAMillionTimesChangesNothing) {
  const Played played(1);
  const Shot whole = shot_of(played.scene, played.state, played.strike);
  Simulation sliced(played.scene, played.state, played.strike, {}, {});
  for (int i = 0; i < 1'000'000; ++i) ASSERT_EQ(sliced.advance_to(i * 1e-18), Progress::paused);
  sliced.advance_to(never<double>);
  EXPECT_EQ(sliced.shot(), whole);
}

TEST(Time, Of1e12SecondsWithFrictionEndsAtRest) {
  const Played played(2);
  const Shot whole = shot_of(played.scene, played.state, played.strike);
  EXPECT_EQ(shot_of(played.scene, played.state, played.strike, {}, until(1e12)), whole);
  Simulation at_once(played.scene, played.state, played.strike, {}, {});
  EXPECT_EQ(at_once.advance_to(1e12), Progress::finished);
  EXPECT_EQ(at_once.shot(), whole);
}

TEST(Time, Of1e12SecondsWithoutFrictionOnAnEndlessBedIsALine) {
  const Shot shot =
      shot_of(gas(), balls({ball(0, {1, 2}, {3, -0.5})}), std::nullopt, {}, until(1e12));
  EXPECT_EQ(state_of(shot, 0).position, (Vec2{1 + 3e12, 2 - 0.5e12}));
}

TEST(Time, Of1e12SecondsWithoutFrictionOnATableStopsAtTheEventLimit) {
  const Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  Limits limits = until(1e12);
  limits.max_events = 10'000;
  const auto outcome = simulate(scene, balls({ball(0, {0, 0}, {3, 1})}), std::nullopt, {}, limits);
  ASSERT_TRUE(std::holds_alternative<Stalled>(outcome));
  EXPECT_EQ(std::get<Stalled>(outcome).cause, StallCause::events);
}

TEST(Slices, OnAndOneUlpAroundEveryEventChangeNoBit) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const Played played(seed);
    const Shot whole = shot_of(played.scene, played.state, played.strike);
    Simulation sliced(played.scene, played.state, played.strike, {}, {});
    for (const Event& event : whole.events) {
      const double t = time_of(event);
      sliced.advance_to(std::nextafter(t, 0.0));
      const std::size_t before = sliced.shot().events.size();
      sliced.advance_to(t);
      EXPECT_TRUE(t == 0 || sliced.shot().events.size() > before ||
                  time_of(sliced.shot().events.back()) == t);
      sliced.advance_to(t);
      sliced.advance_to(std::nextafter(t, 1e9));
      sliced.advance_to(0);
    }
    sliced.advance_to(never<double>);
    ASSERT_EQ(sliced.shot(), whole) << "seed " << seed;
  }
}

TEST(TimeReversal, BringsBallsBackWhereTheyCameFrom) {
  const Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  std::size_t hits = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    Chance chance(seed);
    State state;
    while (state.balls.size() < 5) {
      state.balls.push_back(ball(static_cast<std::uint32_t>(state.balls.size()),
                                 {chance.between(-1.1, 1.1), chance.between(-0.5, 0.5)},
                                 {chance.between(-1, 1), chance.between(-1, 1)}));
      if (!faults_of(scene, state).empty()) state.balls.pop_back();
    }
    const double t = 2;
    const Shot there = shot_of(scene, state, std::nullopt, {}, until(t));
    State back;
    for (const BallState& b : Timeline(there).states(t)) {
      back.balls.push_back({b.id, b.position, -b.velocity, {}});
    }
    const Shot again = shot_of(scene, back, std::nullopt, {}, until(t));
    ASSERT_EQ(again.events.size(), there.events.size()) << "seed " << seed;
    for (std::size_t k = 0; k < there.events.size(); ++k) {
      const Event& first = there.events[k];
      const Event& last = again.events[there.events.size() - 1 - k];
      EXPECT_EQ(first.index(), last.index());
      EXPECT_EQ(balls_of(first).first, balls_of(last).first);
      EXPECT_NEAR(time_of(first), t - time_of(last), 1e-8);
    }
    for (const BallState& b : Timeline(again).states(t)) {
      EXPECT_LE(length(b.position - state.balls[number(b.id)].position), 1e-7) << "seed " << seed;
    }
    hits += all_of<BallBall>(there).size();
  }
  EXPECT_GT(hits, 200u);
}

TEST(Snapshot, TakenOutAndPutBackGoesOnAsTheWhole) {
  int compared = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    const Played played(seed);
    const Shot whole = shot_of(played.scene, played.state, played.strike);
    Chance chance(seed);
    const double t = chance.between(0, whole.end_s);
    State middle;
    for (const BallState& b : Timeline(whole).states(t)) {
      if (b.phase != Phase::pocketed) {
        middle.balls.push_back({b.id, b.position, b.velocity, b.spin});
      }
    }
    if (!faults_of(played.scene, middle).empty()) continue;  // over the edge of a hole
    Shot rest = shot_of(played.scene, middle);
    // A state does not say that its ball rolls: where rounding has left it some slip, that is gone
    // within 1e-12 s.
    rest.events.erase(std::remove_if(rest.events.begin(), rest.events.end(),
                                     [](const Event& event) {
                                       return std::holds_alternative<Rolls>(event) &&
                                              time_of(event) < 1e-12;
                                     }),
                      rest.events.end());
    std::vector<Event> expected;
    for (const Event& event : whole.events) {
      if (time_of(event) > t) expected.push_back(event);
    }
    ASSERT_EQ(rest.events.size(), expected.size()) << "seed " << seed;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_EQ(rest.events[k].index(), expected[k].index()) << "seed " << seed;
      EXPECT_EQ(balls_of(rest.events[k]).first, balls_of(expected[k]).first) << "seed " << seed;
      EXPECT_NEAR(time_of(rest.events[k]) + t, time_of(expected[k]), 1e-6) << "seed " << seed;
    }
    ++compared;
  }
  EXPECT_GT(compared, 250);
}

}  // namespace
}  // namespace breakshot::physics
