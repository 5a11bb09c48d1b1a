// Times at the edges: none, tiny ones, endless ones; slices; back in time; states taken out and put
// back; things that happen at one instant; millions of events.
#include "common/physics/detect.hpp"
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

/// Where a ball between mirrors is, unfolded: the bed becomes endless, and the way straight.
double unfolded(double from, double velocity, double time_s, double half) {
  const double reach = half - radius_m;
  const long double along =
      static_cast<long double>(from) + reach + static_cast<long double>(velocity) * time_s;
  const long double period = 4 * static_cast<long double>(reach);
  long double rest = std::fmod(along, period);
  if (rest < 0) rest += period;
  return static_cast<double>((rest > 2 * static_cast<long double>(reach) ? period - rest : rest) -
                             reach);
}

TEST(Time, Of1e12SecondsOfACreepingBallIsTheUnfoldedTable) {
  const Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  const Vec2 v{1.1e-9, 0.7e-9};
  const Shot shot = shot_of(scene, balls({ball(0, {0.1, 0.2}, v)}), std::nullopt, {}, until(1e12));
  EXPECT_GT(shot.events.size(), 900u);
  // An ulp of 1e12 s is 1.2e-4 s: 1e-13 m at this speed, at every hit.
  const double bound = 1.3e-13 * static_cast<double>(shot.events.size());
  EXPECT_NEAR(state_of(shot, 0).position.x, unfolded(0.1, v.x, 1e12, eight_foot_length_m / 2),
              bound);
  EXPECT_NEAR(state_of(shot, 0).position.y, unfolded(0.2, v.y, 1e12, eight_foot_width_m / 2),
              bound);
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

// ---- At one instant

/// Decelerations of 1 m/s^2 and radii of 1/32 m: times and places are exact.
Scene dyadic(const Motion& motion, const BallBallModel& pair) {
  Scene scene = gas();
  scene.gravity_m_s2 = 8;
  scene.ball.radius_m = 0.03125;
  scene.bed.motion = motion;
  scene.ball_ball = pair;
  return scene;
}

TEST(OneInstant, AStraightSlideThatTurnsToRollAtContactGivesOneCollision) {
  for (const BallBallModel& pair : pair_models()) {
    const Scene scene = dyadic(Straight{0.125, 0.0125, 1}, pair);
    // 2 m/s down to 1 m/s in 1 s and 1.5 m.
    const double place = 1.5 + 0.0625;
    for (const double x : {place, std::nextafter(place, 0.0), std::nextafter(place, 2.0)}) {
      const Shot shot = shot_of(scene, balls({ball(0, {0, 0}, {2, 0}), ball(1, {x, 0})}),
                                std::nullopt, {}, until(1.001));
      ASSERT_EQ(all_of<BallBall>(shot).size(), 1u) << name_of(scene);
      EXPECT_NEAR(all_of<BallBall>(shot)[0].time_s, 1, 1e-15);
      const double sum =
          state_of(shot, 0, 1.0 + 1e-12).velocity.x + state_of(shot, 1, 1.0 + 1e-12).velocity.x;
      EXPECT_NEAR(sum, 1, 0.03) << name_of(scene);
      expect_sound(scene, shot, name_of(scene));
    }
  }
}

TEST(OneInstant, ASpinningSlideThatTurnsToRollAtContactGivesOneCollision) {
  for (const BallBallModel& pair : pair_models()) {
    const Scene scene = dyadic(Spinning{0.125, 0.0125, 0.125}, pair);
    // 3.5 m/s without spin roll at 2.5 m/s after 1 s and 3 m.
    const double place = 3 + 0.0625;
    double speeds[3];
    int which = 0;
    for (const double x : {place, std::nextafter(place, 0.0), std::nextafter(place, 9.0)}) {
      const Shot shot = shot_of(scene, balls({ball(0, {0, 0}, {3.5, 0}), ball(1, {x, 0})}),
                                std::nullopt, {}, until(1.0001));
      ASSERT_EQ(all_of<BallBall>(shot).size(), 1u) << name_of(scene);
      EXPECT_NEAR(all_of<BallBall>(shot)[0].time_s, 1, 1e-14);
      speeds[which++] = state_of(shot, 1, 1.0 + 1e-12).velocity.x;
      expect_sound(scene, shot, name_of(scene));
    }
    EXPECT_NEAR(speeds[0], speeds[1], 1e-12) << name_of(scene);
    EXPECT_NEAR(speeds[0], speeds[2], 1e-12) << name_of(scene);
    EXPECT_GT(speeds[0], 2.2);
  }
}

TEST(OneInstant, ABallThatComesToRestAsItIsHitIsMovedOn) {
  for (const BallBallModel& pair : pair_models()) {
    const Scene scene = dyadic(Straight{0.125, 0.125, 1}, pair);
    // Ball 1 rolls 1/2 m to rest in 1 s; ball 0 comes at that place at that instant, at 1 m/s.
    const double place = 0.5;
    const Shot shot =
        shot_of(scene, balls({ball(0, {place - 0.0625 - 1.5, 0}, {2, 0}), ball(1, {0, 0}, {1, 0})}),
                std::nullopt, {}, until(1.5));
    ASSERT_EQ(all_of<BallBall>(shot).size(), 1u) << name_of(scene);
    EXPECT_NEAR(all_of<BallBall>(shot)[0].time_s, 1, 1e-14) << name_of(scene);
    EXPECT_GT(state_of(shot, 1, 1.001).velocity.x, 0.9) << name_of(scene);
    expect_sound(scene, shot, name_of(scene));
  }
}

TEST(OneInstant, ABallDropsAsTwoOthersMeet) {
  for (const Pockets& pockets : {Pockets{StandardPockets{}}, Pockets{JawedPockets{}}}) {
    for (const Motion& motion : motions()) {
      Scene scene = table(motion, Han2005{}, BallFriction{});
      scene.pockets = pockets;
      // Ball 0 drops into the side pocket; when, a first shot tells.
      const Ball drops = moving(scene, 0, {0, 0.2}, {0, 1});
      const Shot alone = shot_of(scene, balls({drops}), std::nullopt, {}, until(3));
      ASSERT_EQ(all_of<BallPocket>(alone).size(), 1u) << name_of(scene);
      const double t = all_of<BallPocket>(alone)[0].time_s;
      // Ball 1 is then where it meets ball 2: as near as doubles allow.
      const Ball runs = moving(scene, 1, {-0.9, -0.3}, {1, 0});
      const Shot second = shot_of(scene, balls({runs}), std::nullopt, {}, until(t));
      const Vec2 there = state_of(second, 1, t).position;
      double x = there.x + diameter_m;
      for (int i = 0; i < 4; ++i) x = std::nextafter(x, -2.0);
      int together = 0;
      for (int i = 0; i < 9; ++i, x = std::nextafter(x, 2.0)) {
        const Shot shot = shot_of(scene, balls({drops, runs, ball(2, {x, -0.3})}), std::nullopt, {},
                                  limits_for(scene, 3));
        const auto drop = all_of<BallPocket>(shot);
        const auto hit = all_of<BallBall>(shot);
        ASSERT_GE(drop.size(), 1u) << name_of(scene);
        ASSERT_GE(hit.size(), 1u) << name_of(scene);
        EXPECT_EQ(drop[0].time_s, t) << name_of(scene);
        EXPECT_NEAR(hit[0].time_s, t, 4e-15) << name_of(scene);
        together += hit[0].time_s == t;
        expect_sound(scene, shot, name_of(scene));
      }
      EXPECT_GT(together, 0) << name_of(scene);
    }
  }
}

TEST(OneInstant, ABallAtAMouthDropsAsItIsHitOutwards) {
  for (const Motion& motion : motions()) {
    Scene scene = table(motion, Mirror{}, BallRestitution{});
    scene.pockets = StandardPockets{};
    const double y = eight_foot_width_m / 2 - radius_m;
    const Shot shot =
        shot_of(scene, balls({ball(0, {0, y}), moving(scene, 1, {0, y - 0.3}, {0, 2})}),
                std::nullopt, {}, until(0.5));
    const auto drops = all_of<BallPocket>(shot);
    ASSERT_GE(drops.size(), 1u) << name_of(scene);
    EXPECT_EQ(drops[0].ball, BallId{0});
    EXPECT_EQ(drops[0].time_s, all_of<BallBall>(shot).at(0).time_s) << name_of(scene);
  }
}

// ---- Millions of events

TEST(Millions, OfHitsOfOneBallAreThoseOfTheUnfoldedTable) {
  const Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  const Vec2 from{0.1, 0.2};
  const Vec2 v{1.234, 0.777};
  // About v.x / (L - 2R) + v.y / (W - 2R) hits a second.
  const double end = 1'000'000 / (v.x / (eight_foot_length_m - diameter_m) +
                                  v.y / (eight_foot_width_m - diameter_m));
  Limits limits = until(end);
  limits.max_events = 2'000'000;
  const Shot shot = shot_of(scene, balls({ball(0, from, v)}), std::nullopt, {}, limits);
  EXPECT_NEAR(static_cast<double>(shot.events.size()), 1e6, 10);
  EXPECT_EQ(
      length(Vec2{std::abs(state_of(shot, 0).velocity.x), std::abs(state_of(shot, 0).velocity.y)} -
             v),
      0);
  // Every hit rounds a time and a place: 1e6 times an ulp of 8e5 s at 1.5 m/s, if all fell one way.
  const double bound = 1e6 * 1.5 * ulp(end);
  EXPECT_NEAR(state_of(shot, 0).position.x, unfolded(from.x, v.x, end, eight_foot_length_m / 2),
              bound);
  EXPECT_NEAR(state_of(shot, 0).position.y, unfolded(from.y, v.y, end, eight_foot_width_m / 2),
              bound);
}

TEST(Millions, TenOfEventsWithoutFrictionKeepTheEnergy) {
  // Four discs in a small box. A shot keeps everything that happened: the ten million are taken in
  // pieces, each from the state that the last one ended with.
  Scene scene = gas();
  scene.bed.length_m = 0.3;
  scene.bed.width_m = 0.25;
  scene.cushions = RectangleCushions{Mirror{}};
  State state = balls({ball(0, {-0.08, -0.06}, {3, 1}), ball(1, {0.08, -0.06}, {-1, 2}),
                       ball(2, {-0.08, 0.06}, {0.5, -2}), ball(3, {0.08, 0.06}, {1, 1})});
  const auto energy = [](const State& s) {
    long double sum = 0;
    for (const Ball& b : s.balls) {
      sum += static_cast<long double>(b.velocity.x) * b.velocity.x +
             static_cast<long double>(b.velocity.y) * b.velocity.y;
    }
    return sum;
  };
  const long double start = energy(state);
  std::size_t events = 0;
  while (events < 10'000'000) {
    Limits limits = until(1e9);
    limits.max_events = 100'000;
    const auto outcome = simulate(scene, state, std::nullopt, {}, limits);
    const auto* full = std::get_if<Stalled>(&outcome);
    ASSERT_NE(full, nullptr);
    ASSERT_EQ(full->cause, StallCause::events);
    events += full->so_far.events.size();
    const double end = full->so_far.end_s;
    for (const BallState& b : Timeline(full->so_far).states(end)) {
      Ball& next = state.balls[number(b.id)];
      next.position = b.position;
      next.velocity = b.velocity;
    }
  }
  EXPECT_LT(std::abs(static_cast<double>(energy(state) / start - 1)), 1e-12);
}

}  // namespace
}  // namespace breakshot::physics
