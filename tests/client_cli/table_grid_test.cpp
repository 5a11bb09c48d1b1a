#include "client_cli/draw/table_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/client_cli/picture_fixture.hpp"

namespace breakshot::client {
namespace {

constexpr Abilities coloured{true, ColourDepth::direct, true};
constexpr Abilities plain{true, ColourDepth::none, true};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

struct Found {
  int column = -1;
  int row = -1;
};

/// Where a digit stands with the colours of a ball.
Found find_number(const Grid& grid, char32_t digit, Rgb ground) {
  for (int row = 0; row < grid.size().rows; ++row) {
    for (int column = 0; column < grid.size().columns; ++column) {
      const Cell& cell = grid.at(column, row);
      if (cell.glyph == digit && cell.ground == ground) return {column, row};
    }
  }
  return {};
}

TEST(TableGrid, NumbersEachBallOnItsOwnColour) {
  Picture picture = empty_picture();
  picture.balls = {ball_at(3, {-0.6, 0.3}), ball_at(6, {0, 0}), ball_at(9, {0.7, -0.4})};
  const TerminalSize size{120, 40};
  const Grid grid = grid_of(picture, {}, size, coloured);
  const Found three = find_number(grid, U'3', colour_of(physics::BallId{3}));
  const Found six = find_number(grid, U'6', colour_of(physics::BallId{6}));
  const Found nine = find_number(grid, U'9', palette::ivory);
  ASSERT_GE(three.row, 0);
  ASSERT_GE(six.row, 0);
  ASSERT_GE(nine.row, 0);
  // +x goes to the right and +y up.
  EXPECT_LT(three.column, six.column);
  EXPECT_LT(six.column, nine.column);
  EXPECT_LT(three.row, six.row);
  EXPECT_LT(six.row, nine.row);
  EXPECT_NEAR(six.column, size.columns / 2.0, 1);
}

TEST(TableGrid, ShowsTheCueBallWithoutANumber) {
  Picture picture = empty_picture();
  const Grid without = grid_of(picture, {}, {80, 24}, coloured);
  picture.balls = {ball_at(0, {0.3, 0})};
  const Grid with = grid_of(picture, {}, {80, 24}, coloured);
  int changed = 0;
  for (int row = 0; row < 24; ++row) {
    for (int column = 0; column < 80; ++column) {
      if (with.at(column, row) == without.at(column, row)) continue;
      ++changed;
      EXPECT_EQ(with.at(column, row).glyph, U'\u2580');
    }
  }
  EXPECT_GE(changed, 2);
  EXPECT_LE(changed, 16);
}

TEST(TableGrid, PutsTheLinesUnderTheTable) {
  Picture picture = racked_picture();
  picture.caption = "caption";
  picture.pocketed = {physics::BallId{11}, physics::BallId{2}};
  for (const Abilities& abilities : {coloured, plain}) {
    const auto lines = lines_of(text_of(grid_of(picture, {"one", "two"}, {80, 24}, abilities)));
    const auto caption = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find("caption") != std::string::npos;
    });
    ASSERT_NE(caption, lines.end());
    EXPECT_NE(caption->find("11"), std::string::npos);
    EXPECT_EQ(*std::next(caption), " one");
    EXPECT_EQ(*std::next(caption, 2), " two");
  }
}

TEST(TableGrid, TakesEverySizeThatATerminalMayHave) {
  const Picture picture = racked_picture();
  for (const Abilities& abilities : {coloured, plain}) {
    for (int columns = 1; columns <= 130; columns += 3) {
      for (int rows = 1; rows <= 50; rows += 3) {
        const Grid grid = grid_of(picture, {"line"}, {columns, rows}, abilities);
        EXPECT_EQ(grid.size(), (TerminalSize{columns, rows}));
      }
    }
  }
}

TEST(TableGrid, IsPlainCharactersWhereTheTerminalHasNoColourOrNoUnicode) {
  const Picture picture = racked_picture();
  for (const Abilities& abilities :
       {plain, Abilities{true, ColourDepth::direct, false}, Abilities{}}) {
    for (const char c : text_of(grid_of(picture, {}, {80, 24}, abilities))) {
      EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~'));
    }
  }
}

TEST(PlainText, ShowsEveryBallOnceAndGapsForPockets) {
  Picture picture = empty_picture();
  for (std::uint32_t id = 0; id < 16; ++id) {
    picture.balls.push_back(ball_at(id, {-1.0 + id * 0.13, 0.35 * ((id % 3) - 1.0)}));
  }
  const auto lines = lines_of(plain_text_of(picture, plain_columns));
  std::string table;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) table += lines[i];
  for (const char ball : std::string("0123456789abcdef")) {
    EXPECT_EQ(std::count(table.begin(), table.end(), ball), 1) << ball;
  }
  EXPECT_EQ(lines[0].substr(0, 2), "  ");
  EXPECT_EQ(lines[0][plain_columns / 2], ' ');
  EXPECT_EQ(lines[0][plain_columns / 4], '-');
}

TEST(PlainText, KeepsRackedBallsApart) {
  const std::string text = plain_text_of(racked_picture(), plain_columns);
  const std::string table = text.substr(0, text.rfind("0 cue ball"));
  for (const char ball : std::string("0123456789abcdef")) {
    EXPECT_EQ(std::count(table.begin(), table.end(), ball), 1) << ball << "\n" << text;
  }
}

TEST(PlainText, DrawsTheCueVectorAsDots) {
  Picture picture = racked_picture();
  picture.cue = CueVector{picture.balls[0].position, {1, 0}, 8};
  EXPECT_NE(plain_text_of(picture, plain_columns).find("0....."), std::string::npos);
}

}  // namespace
}  // namespace breakshot::client
