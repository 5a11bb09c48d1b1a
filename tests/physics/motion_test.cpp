// Closed forms of every motion, phase by phase.
#include <cmath>

#include "common/physics/simulation.hpp"
#include "tests/support/gases.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

TEST(Frictionless, KeepsItsVelocityForEver) {
  const Shot shot =
      shot_of(gas(), balls({ball(4, {1, 2}, {-3, 0.5})}), std::nullopt, {}, until(1e6));
  EXPECT_TRUE(shot.events.empty());
  EXPECT_EQ(shot.stop, Stop::horizon);
  EXPECT_EQ(shot.end_s, 1e6);
  const BallState end = Timeline(shot).state(BallId{4}, 1e6);
  EXPECT_EQ(end.position, (Vec2{1 - 3e6, 2 + 0.5e6}));
  EXPECT_EQ(end.velocity, (Vec2{-3, 0.5}));
}

TEST(Straight, SlidesThenRollsThenRests) {
  const double slide = 0.2 * 9.81;
  const double roll = 0.01 * 9.81;
  const Shot shot = shot_of(cloth(), balls({ball(0, {0, 0})}), Strike{BallId{0}, {0.6, 0.8}, 3});
  const auto rolls = all_of<Rolls>(shot);
  const auto rests = all_of<Rests>(shot);
  ASSERT_EQ(shot.events.size(), 3u);
  ASSERT_EQ(rolls.size(), 1u);
  ASSERT_EQ(rests.size(), 1u);
  const double sliding = (3 - 1) / slide;
  const double slid = 3 * sliding - slide * sliding * sliding / 2;
  const double rolled = 1 / (2 * roll);
  EXPECT_NEAR(rolls[0].time_s, sliding, 1e-15);
  EXPECT_NEAR(rests[0].time_s, sliding + 1 / roll, 1e-14);
  const Timeline timeline(shot);
  const BallState rolling = timeline.state(BallId{0}, rolls[0].time_s);
  EXPECT_EQ(rolling.phase, Phase::roll);
  EXPECT_NEAR(length(rolling.velocity), 1, 2e-16);
  EXPECT_NEAR(rolling.position.x, 0.6 * slid, 1e-15);
  const BallState end = timeline.state(BallId{0}, shot.end_s);
  EXPECT_EQ(end.phase, Phase::rest);
  EXPECT_EQ(end.velocity, Vec2{});
  EXPECT_NEAR(end.position.x, 0.6 * (slid + rolled), 1e-14);
  EXPECT_NEAR(end.position.y, 0.8 * (slid + rolled), 1e-14);
}

TEST(Straight, WithoutARollingRangeSlidesToRest) {
  Scene scene = cloth();
  scene.bed.motion = Straight{0.2, 0.01, 0};
  const Shot shot = shot_of(scene, balls({ball(0, {0, 0})}), Strike{BallId{0}, {1, 0}, 1});
  EXPECT_EQ(all_of<Rolls>(shot).size(), 0u);
  ASSERT_EQ(all_of<Rests>(shot).size(), 1u);
  EXPECT_NEAR(shot.end_s, 1 / 1.962, 1e-15);
  EXPECT_NEAR(Timeline(shot).state(BallId{0}, 9).position.x, 1 / (2 * 1.962), 1e-15);
}

TEST(Strike, OfSpeedZeroLeavesTheBallAtRest) {
  const Shot shot = shot_of(cloth(), balls({ball(0, {0, 0})}), Strike{BallId{0}, {1, 0}, 0});
  ASSERT_EQ(shot.events.size(), 1u);
  EXPECT_EQ(shot.end_s, 0);
  EXPECT_EQ(shot.stop, Stop::rest);
}

TEST(Timeline, HoldsTheFirstAndTheLastInstant) {
  const Shot shot = shot_of(cloth(), balls({ball(0, {0, 0})}), Strike{BallId{0}, {1, 0}, 0.5});
  const Timeline timeline(shot);
  EXPECT_EQ(timeline.state(BallId{0}, -1), timeline.state(BallId{0}, 0));
  EXPECT_EQ(timeline.state(BallId{0}, 1e9), timeline.state(BallId{0}, shot.end_s));
  EXPECT_EQ(timeline.state(BallId{0}, 0).velocity, (Vec2{0.5, 0}));
}

/// A random shot on a full table of random balls.
struct RandomShot {
  Scene scene;
  State state;
  Strike strike;
};

RandomShot random_shot(Chance& chance) {
  RandomShot random;
  const bool elastic = chance.coin();
  random.scene = table(Straight{0.2, 0.01, 0.5},
                       elastic ? CushionModel{Mirror{}} : CushionModel{CushionRestitution{}},
                       elastic ? BallBallModel{Elastic{}} : BallBallModel{BallRestitution{}});
  random.scene.perturbation = Perturbation{1e-3, 1e-3};
  if (chance.coin()) random.scene.pockets = StandardPockets{};
  while (random.state.balls.size() < 10) {
    random.state.balls.push_back(ball(static_cast<std::uint32_t>(random.state.balls.size()),
                                      {chance.between(-1.1, 1.1), chance.between(-0.5, 0.5)}));
    if (!faults_of(random.scene, random.state).empty()) random.state.balls.pop_back();
  }
  const double angle = chance.between(0, 6.28);
  random.strike = {BallId{0}, {std::cos(angle), std::sin(angle)}, chance.between(0.2, 8)};
  return random;
}

TEST(Slices, ChangeNoBitOfAThousandRandomShots) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Chance chance(seed);
    const RandomShot random = random_shot(chance);
    const ShotSeed shot_seed = seed_of(static_cast<std::uint32_t>(seed));
    const Shot whole = shot_of(random.scene, random.state, random.strike, shot_seed);
    Simulation sliced(random.scene, random.state, random.strike, shot_seed, {});
    double time = 0;
    for (int slice = 0; slice < 40; ++slice) {
      // On event times, between them, backwards, and in steps of nothing.
      switch (chance.below(4)) {
        case 0:
          time = time_of(whole.events[chance.below(whole.events.size())]);
          break;
        case 1:
          time += 1e-18;
          break;
        default:
          time += chance.between(0, 0.5);
      }
      sliced.advance_to(time);
    }
    sliced.advance_to(never<double>);
    ASSERT_EQ(sliced.shot(), whole) << "seed " << seed;
  }
}

/// Advances in slices and forgets after each; what was forgotten makes up a whole shot.
Shot pieced_together(Simulation& simulation, double slice_s, double end_s) {
  Shot pieces;
  for (double time_s = 0; time_s < end_s; time_s += slice_s) {
    simulation.advance_to(time_s);
    const Shot& shot = simulation.shot();
    pieces.events.insert(pieces.events.end(), shot.events.begin(), shot.events.end());
    pieces.segments.insert(pieces.segments.end(), shot.segments.begin(), shot.segments.end());
    pieces.stop = shot.stop;
    pieces.end_s = shot.end_s;
    simulation.forget();
  }
  return pieces;
}

TEST(Slices, ForgottenAsTheyComeMakeUpTheWholeShot) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Chance chance(seed);
    const RandomShot random = random_shot(chance);
    const ShotSeed shot_seed = seed_of(static_cast<std::uint32_t>(seed));
    const Shot whole = shot_of(random.scene, random.state, random.strike, shot_seed);
    Simulation sliced(random.scene, random.state, random.strike, shot_seed, {});
    ASSERT_EQ(pieced_together(sliced, chance.between(0.001, 0.5), whole.end_s + 1), whole)
        << "seed " << seed;
  }
  for (const std::size_t discs : {std::size_t{9}, most_balls_at_a_table + 1}) {
    const Gas gas = gas_in_a_box(discs, 0.2, 1);
    const Shot whole = shot_of(gas.scene, gas.state, std::nullopt, {}, until(3));
    Simulation sliced(gas.scene, gas.state, std::nullopt, {}, until(3));
    ASSERT_EQ(pieced_together(sliced, 0.01, 3.1), whole) << discs << " discs";
  }
}

TEST(Slices, CountForgottenEventsTowardsTheLimit) {
  const Gas gas = gas_in_a_box(9, 0.2, 1);
  Limits limits = until(1e9);
  limits.max_events = 1'000;
  Simulation sliced(gas.scene, gas.state, std::nullopt, {}, limits);
  std::size_t events = 0;
  Progress progress = Progress::paused;
  for (double time_s = 0; progress == Progress::paused; time_s += 0.05) {
    progress = sliced.advance_to(time_s);
    events += sliced.shot().events.size();
    sliced.forget();
  }
  EXPECT_EQ(progress, Progress::stalled);
  // It is looked at between instants.
  EXPECT_GE(events, 1'000u);
  EXPECT_LT(events, 1'010u);
}

TEST(Slices, EndWithExactlyTheEventsUpToTheirTime) {
  Chance chance(5);
  const RandomShot random = random_shot(chance);
  const Shot whole = shot_of(random.scene, random.state, random.strike, seed_of(5));
  Simulation simulation(random.scene, random.state, random.strike, seed_of(5), {});
  for (const Event& event : whole.events) {
    simulation.advance_to(time_of(event));
    const Shot part = simulation.shot_until(time_of(event));
    ASSERT_EQ(time_of(part.events.back()), time_of(event));
    ASSERT_EQ(Timeline(part).states(time_of(event)), Timeline(whole).states(time_of(event)));
  }
}

TEST(Limits, StopAShotAtItsEventLimitWithWhatHasHappened) {
  Limits limits;
  limits.max_events = 7;
  const Scene scene = table(Straight{}, Mirror{}, Elastic{});
  const auto outcome =
      simulate(scene, racked(scene, rack_gap_m), Strike{BallId{0}, {1, 0}, 8}, {}, limits);
  const auto* stalled = std::get_if<Stalled>(&outcome);
  ASSERT_NE(stalled, nullptr);
  EXPECT_EQ(stalled->cause, StallCause::events);
  // The limit is looked at between instants, and two of the first contacts share one.
  EXPECT_EQ(stalled->so_far.events.size(), 8u);
  EXPECT_FALSE(stalled->balls.empty());
}

TEST(Limits, StopAShotAtItsHorizon) {
  const Shot shot =
      shot_of(cloth(), balls({ball(0, {0, 0})}), Strike{BallId{0}, {1, 0}, 3}, {}, until(0.25));
  EXPECT_EQ(shot.stop, Stop::horizon);
  EXPECT_EQ(shot.end_s, 0.25);
  EXPECT_EQ(shot.events.size(), 1u);
}

}  // namespace
}  // namespace breakshot::physics
