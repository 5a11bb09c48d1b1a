// Both calendars give the same shot, bit for bit.
#include <cmath>

#include "common/physics/simulation.hpp"
#include "tests/support/gases.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

using AtATable = Loop<double, TableCalendar>;
using InCells = Loop<double, CellCalendar>;

/// What a scene comes to with one of the calendars.
struct Outcome {
  Progress progress;
  Shot shot;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

template <class Loop>
Outcome outcome_of(const Scene& scene, const State& state, const std::optional<Strike>& strike,
                   const ShotSeed& seed, const Limits& limits) {
  Loop loop(scene, state, strike, seed, limits);
  const Progress progress = loop.advance_to(never<double>);
  return {progress, loop.shot()};
}

/// The events that both calendars find, which must be the same.
std::size_t events_of_both(const Scene& scene, const State& state,
                           const std::optional<Strike>& strike = std::nullopt,
                           const ShotSeed& seed = {}, const Limits& limits = {}) {
  EXPECT_TRUE(faults_of(scene).empty());
  EXPECT_TRUE(faults_of(scene, state).empty());
  const Outcome expected = outcome_of<AtATable>(scene, state, strike, seed, limits);
  const Outcome found = outcome_of<InCells>(scene, state, strike, seed, limits);
  const auto differ = std::mismatch(expected.shot.events.begin(), expected.shot.events.end(),
                                    found.shot.events.begin(), found.shot.events.end());
  EXPECT_TRUE(found == expected) << found.shot.events.size() << " events instead of "
                                 << expected.shot.events.size() << ", the same up to event "
                                 << differ.first - expected.shot.events.begin();
  return found.shot.events.size();
}

Vec2 direction_at(double angle) {
  const Vec2 direction{std::cos(angle), std::sin(angle)};
  return direction / length(direction);
}

Scene full_model() {
  Scene scene = table(Spinning{}, Han2005{}, BallFriction{});
  scene.pockets = JawedPockets{};
  scene.perturbation = Perturbation{0.001, 0.001};
  return scene;
}

/// Balls in a hexagonal block of rows, each `pitch_m` from its neighbours.
State block(std::size_t rows, std::size_t columns, double pitch_m, Vec2 corner = {}) {
  State state;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const Vec2 offset{(static_cast<double>(column) + (row % 2 == 0 ? 0 : 0.5)) * pitch_m,
                        static_cast<double>(row) * pitch_m * std::sqrt(0.75)};
      state.balls.push_back(ball(static_cast<std::uint32_t>(state.balls.size()), corner + offset));
    }
  }
  return state;
}

TEST(CellCalendar, GivesTheTablesShotOfGasesInABox) {
  std::size_t events = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Chance chance(seed);
    const std::size_t count = 2 + chance.below(seed % 8 == 0 ? 199 : 40);
    const Gas gas = gas_in_a_box(count, chance.between(0.001, 0.7), seed);
    events += events_of_both(gas.scene, gas.state, std::nullopt, {},
                             until(300.0 / static_cast<double>(count)));
    ASSERT_FALSE(HasFailure()) << "seed " << seed << ", " << count << " balls";
  }
  EXPECT_GT(events, 100'000u);
}

TEST(CellCalendar, GivesTheTablesShotOfALargeGas) {
  const Gas gas = gas_in_a_box(3000, 0.3, 17);
  EXPECT_GT(events_of_both(gas.scene, gas.state, std::nullopt, {}, until(0.3)), 5'000u);
}

TEST(CellCalendar, GivesTheTablesShotOfBreaksWithEverything) {
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    Chance chance(seed);
    const State state = racked(full_model(), seed % 3 == 0 ? 0.0 : chance.between(1e-6, 3e-3));
    const Strike strike{BallId{0},
                        direction_at(chance.between(-0.05, 0.05)),
                        chance.between(1, 10),
                        {chance.between(-0.3, 0.3), chance.between(-0.3, 0.3)}};
    EXPECT_GT(events_of_both(full_model(), state, strike, seed_of(seed)), 10u);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(CellCalendar, GivesTheTablesShotOfPaperBreaks) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    Chance chance(seed);
    Scene scene = table(Straight{}, CushionRestitution{}, BallRestitution{});
    scene.pockets = StandardPockets{};
    if (chance.coin()) scene.perturbation = Perturbation{0.01, 0.01};
    const State state = racked(scene, rack_gap_m);
    const Strike strike{BallId{0}, direction_at(chance.between(-0.1, 0.1)), 8, {}};
    events_of_both(scene, state, strike, seed_of(seed));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(CellCalendar, GivesTheTablesShotOfZeroGapRacksHitHeadOn) {
  // Everything here happens at the same instants: ties decide.
  for (const BallBallModel& model : {BallBallModel{Elastic{}}, BallBallModel{BallRestitution{}},
                                     BallBallModel{BallFriction{}}}) {
    Scene scene = table(Spinning{}, Mirror{}, model);
    events_of_both(scene, racked(scene, 0), Strike{BallId{0}, {1, 0}, 8, {}});
  }
}

TEST(CellCalendar, GivesTheTablesShotOfBlocksThatMoveInStep) {
  // A square lattice whose balls meet their neighbours all at once, time and again.
  for (const double speed : {1.0, 0.375}) {
    Gas gas = gas_in_a_box(144, 0.2, 0);
    const double square = *gas.scene.bed.length_m / 12;
    for (std::size_t k = 0; k < gas.state.balls.size(); ++k) {
      const auto column = static_cast<double>(k % 12);
      const auto row = static_cast<double>(k / 12);
      gas.state.balls[k].position = {(column - 5.5) * square, (row - 5.5) * square};
      gas.state.balls[k].velocity = {k % 2 == 0 ? speed : -speed, 0};
    }
    EXPECT_GT(events_of_both(gas.scene, gas.state, std::nullopt, {}, until(5)), 1'000u);
  }
}

TEST(CellCalendar, GivesTheTablesShotOfABlockThatFliesApart) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Chance chance(seed);
    State state = block(8, 8, 0.06, {chance.between(-1e3, 1e3), chance.between(-1e3, 1e3)});
    for (Ball& ball : state.balls) {
      ball.velocity = {chance.between(-5, 5), chance.between(-5, 5)};
    }
    Scene scene = gas();
    events_of_both(scene, state, std::nullopt, {}, until(seed % 2 == 0 ? 20 : 1e12));
    scene.gravity_m_s2 = 9.81;
    scene.bed.motion = Spinning{};
    events_of_both(scene, state);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(CellCalendar, GivesTheTablesShotOfABreakOnEndlessCloth) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Chance chance(seed);
    Scene scene = gas();
    scene.gravity_m_s2 = 9.81;
    scene.bed.motion = Spinning{};
    scene.ball_ball = BallFriction{};
    State state = block(10, 10, 0.05715 + chance.between(0, 1e-4));
    state.balls.push_back(ball(1000, {-3, chance.between(0.1, 0.4)}));
    EXPECT_GT(events_of_both(scene, state, Strike{BallId{1000}, {1, 0}, 15, {}}), 100u);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(CellCalendar, GivesTheTablesShotAcrossFreeCushions) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    Chance chance(seed);
    Scene scene = gas();
    FreeCushions wedge;
    wedge.segments = {{{-2, -0.2}, {2, -0.5}, Mirror{}}, {{2, 1.5}, {-2, 1.2}, Mirror{}}};
    wedge.arcs = {{{2.5, 0.5}, 0.4, {-0.6, 0.8}, {-0.6, -0.8}, Mirror{}}};
    scene.cushions = wedge;
    State state = block(6, 8, 0.08);
    for (Ball& ball : state.balls) {
      ball.velocity = {chance.between(-2, 3), chance.between(-1, 1)};
    }
    events_of_both(scene, state, std::nullopt, {}, until(30));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(CellCalendar, LeavesBallsAtRestAlone) {
  EXPECT_EQ(events_of_both(cloth(), block(40, 40, 0.05715)), 0u);
  EXPECT_EQ(events_of_both(gas(), block(3, 3, 0.1), std::nullopt, {}, until(1e12)), 0u);
}

TEST(CellCalendar, KnowsNoPairsWhereBallsPassThroughOneAnother) {
  Gas gas = gas_in_a_box(50, 0.3, 3);
  gas.scene.ball_ball.reset();
  EXPECT_GT(events_of_both(gas.scene, gas.state, std::nullopt, {}, until(10)), 100u);
}

TEST(CellCalendar, IsTheSameInAnySlices) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Chance chance(seed);
    const Gas gas = gas_in_a_box(30, 0.2, seed);
    const Outcome whole = outcome_of<InCells>(gas.scene, gas.state, std::nullopt, {}, until(5));
    InCells sliced(gas.scene, gas.state, std::nullopt, {}, until(5));
    double t = 0;
    while (sliced.advance_to(t) == Progress::paused) {
      t += chance.coin() ? chance.between(-0.01, 0.1) : 1e-18;
    }
    ASSERT_EQ(sliced.shot(), whole.shot) << "seed " << seed;
  }
}

TEST(CellCalendar, IsChosenAboveTheCrossover) {
  const Gas gas = gas_in_a_box(most_balls_at_a_table + 1, 0.2, 1);
  const Shot shot = shot_of(gas.scene, gas.state, std::nullopt, {}, until(2));
  EXPECT_EQ(shot, (outcome_of<AtATable>(gas.scene, gas.state, std::nullopt, {}, until(2)).shot));
}

}  // namespace
}  // namespace breakshot::physics
