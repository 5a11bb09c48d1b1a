// Whole worlds without sockets, each from one seed. A failure names the seed and the step.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/simulation/broken.hpp"
#include "tests/simulation/world.hpp"

namespace breakshot::simulation {
namespace {

constexpr std::size_t clients = 6;
constexpr std::size_t steps = 6000;
constexpr std::uint64_t worlds_a_test = 8;

/// Lives through one world; what went wrong in it, or nothing.
std::optional<std::string> fault_of(World& world) {
  std::size_t step = 0;
  try {
    for (; step < steps; ++step) world.live(1);
    world.calm_down();
    world.check();
  } catch (const std::exception& error) {
    return "at step " + std::to_string(step) + ": " + error.what();
  }
  return std::nullopt;
}

class AnyWorld : public testing::TestWithParam<std::uint64_t> {};

TEST_P(AnyWorld, KeepsEveryPromiseWhateverFails) {
  World::Totals sum;
  for (std::uint64_t i = 0; i < worlds_a_test; ++i) {
    const std::uint64_t seed = GetParam() * worlds_a_test + i;
    World world(seed, clients);
    const auto fault = fault_of(world);
    ASSERT_FALSE(fault) << "seed " << seed << " " << *fault;
    const World::Totals totals = world.totals();
    sum.crashes += totals.crashes;
    sum.store_failures += totals.store_failures;
    sum.disconnects += totals.disconnects;
    sum.finished += totals.finished;
    sum.entries += totals.entries;
    sum.entries_told += totals.entries_told;
    sum.outcomes_repeated += totals.outcomes_repeated;
    sum.repeats_answered += totals.repeats_answered;
    sum.wishes_repeated += totals.wishes_repeated;
    sum.fetched += totals.fetched;
    sum.refused += totals.refused;
  }
  // The worlds are not empty: everything that they are to try has happened.
  std::cout << sum.entries << " entries, " << sum.entries_told << " told, " << sum.finished
            << " matches finished, " << sum.crashes << " crashes, " << sum.store_failures
            << " store failures, " << sum.disconnects << " disconnects, " << sum.outcomes_repeated
            << " outcomes repeated, " << sum.repeats_answered << " repeats answered, "
            << sum.wishes_repeated << " wishes repeated, " << sum.fetched << " fetched, "
            << sum.refused << " refused\n";
  EXPECT_GT(sum.entries, 300u);
  EXPECT_GT(sum.entries_told, 300u);
  EXPECT_GT(sum.finished, 10u);
  EXPECT_GT(sum.crashes, 10u);
  EXPECT_GT(sum.store_failures, 20u);
  EXPECT_GT(sum.disconnects, 50u);
  EXPECT_GT(sum.outcomes_repeated, 2u);
  EXPECT_GT(sum.repeats_answered, 5u);
  EXPECT_GT(sum.wishes_repeated, 2u);
  EXPECT_GT(sum.fetched, 10u);
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnyWorld, testing::Range<std::uint64_t>(0, 4));

TEST(World, TheSameSeedGivesTheSameWorld) {
  World one(7, clients);
  World two(7, clients);
  World other(8, clients);
  ASSERT_FALSE(fault_of(one));
  ASSERT_FALSE(fault_of(two));
  ASSERT_FALSE(fault_of(other));
  EXPECT_EQ(one.trace(), two.trace());
  EXPECT_NE(one.trace(), other.trace());
}

}  // namespace
}  // namespace breakshot::simulation
