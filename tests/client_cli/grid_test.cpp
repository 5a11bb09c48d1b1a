#include "client_cli/draw/grid.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "tests/client_cli/screen.hpp"

namespace breakshot::client {
namespace {

constexpr Rgb red{255, 0, 0};
constexpr Rgb black{0, 0, 0};

TEST(Grid, WritesTextAndCutsItOffAtTheEdge) {
  Grid grid({6, 2});
  EXPECT_EQ(grid.write(2, 0, "abcdef"), 6);
  grid.write(0, 1, "xy");
  EXPECT_EQ(text_of(grid), "  abcd\nxy\n");
}

TEST(Grid, GivesWideCharactersTwoCellsAndNeverHalfOfOne) {
  Grid grid({5, 1});
  EXPECT_EQ(grid.write(0, 0, "\u7389\u7389\u7389"), 4);
  EXPECT_EQ(text_of(grid), "\u7389\u7389\n");
}

TEST(Grid, ShowsNothingThatCouldMoveTheCursor) {
  Grid grid({12, 1});
  grid.write(0, 0, "a\x1b[2Jb\xff\u202e");
  EXPECT_EQ(text_of(grid), "a?[2Jb??\n");
}

TEST(Grid, OutsideItsEdgesIsNothing) {
  Grid grid({3, 3});
  grid.write(0, 3, "a");
  grid.write(3, 0, "a");
  grid.write(-1, 0, "a");
  EXPECT_EQ(grid, Grid({3, 3}));
}

TEST(Transition, WritesNothingWhereNothingChanged) {
  Grid grid({10, 3});
  grid.write(1, 1, "hello");
  EXPECT_EQ(transition(&grid, grid, ColourDepth::direct), "");
}

TEST(Transition, WritesOnlyWhatChanged) {
  Grid before({80, 24});
  Grid after = before;
  after.write(4, 2, "8", red, black);
  EXPECT_EQ(transition(&before, after, ColourDepth::direct),
            "\x1b[3;5H\x1b[38;2;255;0;0m\x1b[48;2;0;0;0m8\x1b[0m");
  EXPECT_EQ(transition(&before, after, ColourDepth::indexed),
            "\x1b[3;5H\x1b[38;5;196m\x1b[48;5;16m8\x1b[0m");
  EXPECT_EQ(transition(&before, after, ColourDepth::none), "\x1b[3;5H8");
}

TEST(Transition, BringsAnyScreenToAnyOther) {
  const unsigned seed = 20;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const auto below = [&](unsigned limit) { return static_cast<int>(random() % limit); };
  const TerminalSize size{17, 5};
  Screen screen(size);
  std::optional<Grid> before;
  for (int round = 0; round < 200; ++round) {
    Grid next = before.value_or(Grid(size));
    for (int change = 0; change < 6; ++change) {
      const Rgb ink{static_cast<std::uint8_t>(below(256)), 0, 0};
      const char* text = below(4) == 0 ? "\u7389" : "ab";
      // Wide characters stand on even columns, so that none is cut in half by another.
      next.write(2 * below(8), below(5), text, ink, below(2) == 0 ? red : black);
    }
    screen.write(transition(before ? &*before : nullptr, next, ColourDepth::direct));
    ASSERT_EQ(screen.grid(), next) << "round " << round;
    before = next;
  }
}

TEST(IndexedColour, IsTheNearestOfTheCubeAndTheGreys) {
  EXPECT_EQ(indexed_colour({0, 0, 0}), 16);
  EXPECT_EQ(indexed_colour({255, 255, 255}), 231);
  EXPECT_EQ(indexed_colour({255, 0, 0}), 196);
  EXPECT_EQ(indexed_colour({0, 95, 135}), 24);
  EXPECT_EQ(indexed_colour({8, 8, 8}), 232);
  EXPECT_EQ(indexed_colour({238, 238, 238}), 255);
}

}  // namespace
}  // namespace breakshot::client
