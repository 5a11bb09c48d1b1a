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
  // So many that memory is fetched ahead; of those that drop as well.
  for (const bool drop : {false, true}) {
    Gas gas = gas_in_a_box(5000, 0.3, 17);
    if (drop) gas.scene.pockets = StandardPockets{};
    EXPECT_GT(events_of_both(gas.scene, gas.state, std::nullopt, {}, until(0.2)), 5'000u);
  }
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
      const std::size_t row = k / 12;
      gas.state.balls[k].position = {(static_cast<double>(k % 12) - 5.5) * square,
                                     (static_cast<double>(row) - 5.5) * square};
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

TEST(CellCalendar, GivesTheTablesShotOfABallFrozenToACushionThatIsPushedAgainstIt) {
  // The push leaves it an approach that rounding explains and that another meeting follows closely.
  for (const Motion& motion : {Motion{Frictionless{}}, Motion{Straight{0.2, 0.01, 1.0}}}) {
    Scene scene = table(motion, Mirror{}, Elastic{});
    scene.ball.radius_m = 0.04;
    scene.bed.length_m = 2;
    scene.bed.width_m = 1;
    double y = 0.46;
    for (int ulps = 0; ulps < 5; ++ulps) y = std::nextafter(y, 0.0);
    const State state = balls({ball(0, {-0.5, y}, {1, 0}), ball(1, {-0.3, std::nextafter(y, 1.0)}),
                               ball(2, {-0.2, 0.42})});
    EXPECT_GT(events_of_both(scene, state, std::nullopt, {}, until(1)), 2u);
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

// ---- What it is made of

std::vector<Vec2> scattered(Chance& chance, std::size_t count, double extent) {
  std::vector<Vec2> places(count);
  for (Vec2& place : places) {
    place = {chance.between(-extent, extent), chance.between(-extent, extent)};
  }
  return places;
}

struct Grid {
  template <class Present>
  Grid(const std::vector<Vec2>& positions, const Present& present)
      : cells(positions.size(), 0.05715), at(positions.size()) {
    cells.build(
        0, present, [&positions](std::uint32_t ball) { return positions[ball]; },
        [this](std::uint32_t ball) -> Place& { return at[ball]; });
  }

  Cells<double> cells;
  std::vector<Place> at;  ///< of each ball
};

TEST(Cells, FindEveryBallWithinReach) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Chance chance(seed);
    const double extent = std::pow(10.0, chance.between(-2, 6));
    std::vector<Vec2> places = scattered(chance, 2 + chance.below(200), extent);
    for (Vec2& place : places) {
      if (chance.coin()) place = place * 1e-3;  // a crowd, in chains of lists
    }
    const auto present = [](std::uint32_t ball) { return ball % 7 != 6; };
    Grid grid(places, present);
    if (places.size() > 3) grid.cells.remove(3, grid.at[3]);
    Gathered found;
    for (std::uint32_t ball = 0; ball < places.size(); ++ball) {
      if (!present(ball) || ball == 3) continue;
      grid.cells.find_beside(grid.at[ball], found);
      std::vector<std::uint32_t> all(found.begin(), found.end());
      std::sort(all.begin(), all.end());
      ASSERT_EQ(std::adjacent_find(all.begin(), all.end()), all.end()) << "seed " << seed;
      for (std::uint32_t other = 0; other < places.size(); ++other) {
        if (!present(other) || other == 3) continue;
        if (length(places[other] - places[ball]) > grid.cells.reach()) continue;
        ASSERT_TRUE(std::binary_search(all.begin(), all.end(), other)) << "seed " << seed;
      }
    }
  }
}

TEST(Cells, TakeMemoryForBallsAndNotForTheArea) {
  Chance chance(1);
  for (const double extent : {1e-3, 1.0, 1e3, 1e6}) {
    std::vector<Vec2> places = scattered(chance, 1000, extent);
    EXPECT_LE(Grid(places, [](std::uint32_t) { return true; }).cells.lists(), 8'000u) << extent;
    // All in one place but for two, so that the cells are small and the area is large.
    for (std::size_t k = 2; k < places.size(); ++k) places[k] = places[k] * (1 / extent);
    EXPECT_LE(Grid(places, [](std::uint32_t) { return true; }).cells.lists(), 8'000u) << extent;
  }
}

TEST(Cells, AreCrossedOneAfterTheOther) {
  // A ball thrown up an incline and back: wherever it crosses, it is in the cell beyond.
  Chance chance(9);
  std::vector<Vec2> places = scattered(chance, 1000, 1);
  places[0] = {};
  Grid grid(places, [](std::uint32_t) { return true; });
  const Vec2 velocity{0.31, 2.0};
  const Vec2 acceleration{0.01, -0.5};
  double time = 0;
  std::size_t crossings = 0;
  double highest = 0;
  while (time < 8 && crossings < 10'000) {
    const Vec2 p = (velocity + acceleration * (time / 2)) * time;
    highest = std::max(highest, p.y);
    const Crossing<double> next =
        grid.cells.crossing(grid.at[0], p, velocity + acceleration * time, acceleration);
    ASSERT_GE(next.after_s, 0);
    time += next.after_s;
    grid.cells.cross(0, grid.at[0], next.side);
    ++crossings;
  }
  EXPECT_GT(highest, 3.5);
  // Up and down, and some three metres aside.
  const auto sides = [&grid](double way) {
    return static_cast<std::size_t>(way / grid.cells.side());
  };
  EXPECT_GE(crossings, sides(2 * highest + 2) - 3);
  EXPECT_LE(crossings, sides(2 * highest + 4) + 3);
}

TEST(EventHeap, KnowsTheEarliestOfAll) {
  for (const std::size_t count : {1u, 2u, 8u, 9u, 64u, 65u, 1000u}) {
    Chance chance(count);
    EventHeap<double> heap(count);
    EXPECT_EQ(heap.earliest(), never<double>);
    std::vector<double> times(count, never<double>);
    for (int step = 0; step < 2000; ++step) {
      const auto ball = static_cast<std::uint32_t>(chance.below(count));
      // Few different times, so that many are at one.
      const double time =
          chance.below(5) == 0 ? never<double> : static_cast<double>(chance.below(20));
      times[ball] = time;
      std::uint32_t risen = heap.first();
      heap.set(ball, time, [&risen](std::size_t others, std::uint32_t next) {
        if (others == 1) risen = next;
      });
      ASSERT_EQ(heap.first(), risen);
      ASSERT_EQ(heap.time_of(ball), time);
      const double earliest = *std::min_element(times.begin(), times.end());
      ASSERT_EQ(heap.earliest(), earliest);
      if (earliest == never<double>) continue;
      std::vector<std::uint32_t> expected;
      for (std::uint32_t k = 0; k < count; ++k) {
        if (times[k] == earliest) expected.push_back(k);
      }
      std::vector<std::uint32_t> found;
      heap.each_earliest([&found](std::uint32_t k) { found.push_back(k); });
      ASSERT_EQ(found, expected);
      ASSERT_EQ(heap.first(), expected.front());
      ASSERT_EQ(heap.first_is_alone(), expected.size() == 1);
    }
  }
}

}  // namespace
}  // namespace breakshot::physics
