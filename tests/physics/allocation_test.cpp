// Memory is taken when a shot begins and when its log grows, never for an event.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "common/physics/simulation.hpp"
#include "common/physics/table.hpp"
#include "tests/support/gases.hpp"

namespace {

thread_local std::size_t allocations = 0;

void* counted(std::size_t bytes) {
  ++allocations;
  if (void* const memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
  throw std::bad_alloc();
}

void* counted(std::size_t bytes, std::align_val_t alignment) {
  ++allocations;
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* const memory = std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit)) {
    return memory;
  }
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t bytes) {
  return counted(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, alignment);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
void* operator new[](std::size_t bytes) {
  return counted(bytes);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace breakshot::physics {
namespace {

/// How often memory was taken between two times.
std::size_t allocations_between(Simulation& simulation, double from_s, double to_s) {
  simulation.advance_to(from_s);
  const std::size_t before = allocations;
  simulation.advance_to(to_s);
  return allocations - before;
}

/// Two logs, each of which doubles as it grows.
std::size_t doublings(std::size_t from, std::size_t to) {
  std::size_t count = 2;
  for (; from < to; from *= 2) count += 2;
  return count;
}

class AGas : public testing::TestWithParam<std::size_t> {};

TEST_P(AGas, TakesMemoryForItsLogAlone) {
  const support::Gas gas = support::gas_in_a_box(GetParam(), 0.2, 1);
  Limits limits;
  limits.horizon_s = 1e9;
  limits.max_events = 10'000'000;
  Simulation simulation(gas.scene, gas.state, std::nullopt, {}, limits);
  simulation.advance_to(1);
  const std::size_t before = simulation.shot().events.size();
  const std::size_t taken = allocations_between(simulation, 1, 13);
  const std::size_t after = simulation.shot().events.size();
  ASSERT_GT(after, 10 * before);
  EXPECT_LE(taken, doublings(before, after)) << after - before << " events";
}

INSTANTIATE_TEST_SUITE_P(AtATableAndInCells, AGas,
                         testing::Values(16, most_balls_at_a_table + 20, 5'000));

/// Many triples, each of which is a ball that hits two at one instant, one after the other.
TEST(SetsOfContacts, TakeNoMemoryOfTheirOwn) {
  Scene scene = presets().front().scene;
  scene.bed = {};
  scene.bed.motion = Frictionless{};
  scene.cushions.reset();
  scene.pockets.reset();
  scene.ball_ball = BallFriction{};
  scene.perturbation.reset();
  const double radius = scene.ball.radius_m;
  State state;
  for (std::uint32_t k = 0; k < 10; ++k) {
    const double y = 10 * radius * k;
    const double gap = 0.01 * (k + 1);
    const double depth = 1.7320508075688772 * radius + gap;
    state.balls.push_back({BallId(3 * k), {0, y}, {1, 0}, {}});
    state.balls.push_back({BallId(3 * k + 1), {depth, y - radius}, {}, {}});
    state.balls.push_back({BallId(3 * k + 2), {depth, y + radius}, {}, {}});
  }
  Limits limits;
  limits.horizon_s = 1;
  ASSERT_TRUE(faults_of(scene, state).empty()) << faults_of(scene, state).front().field;
  Simulation simulation(scene, state, std::nullopt, {}, limits);
  EXPECT_EQ(allocations_between(simulation, 0.035, 0.5), 0u);
  EXPECT_GE(simulation.shot().events.size(), 20u);
}

/// Breaks of a rack without gaps have sets of all sizes; what they take does not grow with them.
TEST(ABreak, TakesMemoryInItsBeginningAlone) {
  const Preset& club = presets().front();
  State state;
  state.balls.push_back({BallId(0), head_spot(club.scene.bed), {}, {}});
  std::uint32_t id = 1;
  for (const Vec2 place : triangle_rack(club.scene.bed, club.scene.ball, 0)) {
    state.balls.push_back({BallId(id++), place, {}, {}});
  }
  const Strike strike{BallId(0), {1, 0}, 8, {}};
  ASSERT_TRUE(faults_of(club.scene, state).empty());
  Simulation simulation(club.scene, state, strike, {}, {});
  double time_s = 0;
  while (simulation.shot().events.size() < 60) simulation.advance_to(time_s += 0.01);
  const std::size_t before = allocations;
  simulation.advance_to(1e9);
  ASSERT_GT(simulation.shot().events.size(), 110u);
  EXPECT_LE(allocations - before, doublings(60, simulation.shot().events.size()));
}

}  // namespace
}  // namespace breakshot::physics
