// `breakshot replay` in a terminal: what is on the screen, and what the keys do.
#include <gtest/gtest.h>

#include <cstdlib>

#include "client_cli/draw/table_grid.hpp"
#include "tests/client_cli/match_files.hpp"
#include "tests/client_cli/picture_fixture.hpp"
#include "tests/client_cli/screen.hpp"
#include "tests/support/pseudo_terminal.hpp"

namespace breakshot::client {
namespace {

constexpr TerminalSize window{support::terminal_columns, support::terminal_rows};
constexpr const char* frame_end = "\x1b[?2026l";

/// The screen after the last whole frame.
Grid screen_of(const std::string& seen) {
  Screen screen(window);
  const std::size_t end = seen.rfind(frame_end);
  if (end != std::string::npos) screen.write(std::string_view(seen).substr(0, end));
  return screen.grid();
}

std::function<bool(const std::string&)> shows(const std::string& text) {
  return [text](const std::string& seen) {
    return text_of(screen_of(seen)).find(text) != std::string::npos;
  };
}

/// The last shot of the match: which it is, and how long it takes.
struct LastShot {
  int number = 0;
  double end_s = 0;
};

LastShot last_shot() {
  LastShot last;
  for (const record::Entry& entry : finished_match().entries) {
    if (entry.outcome.shot) last = {last.number + 1, entry.outcome.shot->end_s};
  }
  return last;
}

class ReplayInTerminal : public testing::Test {
 protected:
  MatchFiles files_;

  void replay(std::vector<std::string> words) const {
    ::setenv("TERM", "xterm-256color", 1);
    ::setenv("COLORTERM", "truecolor", 1);
    ::setenv("LC_ALL", "C.UTF-8", 1);
    for (const char* name : {"NO_COLOR", "COLUMNS", "LINES"}) ::unsetenv(name);
    words.insert(words.begin(), {BREAKSHOT_PROGRAM, "replay", files_.finished()});
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    ::execv(argv[0], argv.data());
  }
};

TEST_F(ReplayInTerminal, StartsWithTheTableOfTheFirstShot) {
  support::OnTerminal program([this] { replay({"--paused"}); });
  ASSERT_TRUE(program.wait_until(shows("Shot 1 of ")));
  Picture expected = empty_picture();
  const physics::Timeline timeline(*finished_match().entries[1].outcome.shot);
  expected.balls = balls_at(expected.table, timeline, 0);
  const auto& shoot = std::get<match::Shoot>(finished_match().entries[1].command);
  expected.cue =
      CueVector{timeline.state(rules::cue_ball, 0).position, shoot.direction, shoot.speed_m_s};
  const Grid table = grid_of(expected, {"", "", "", ""}, window, {true, ColourDepth::direct, true});
  const Grid screen = screen_of(program.seen());
  // Four lines and the caption follow the table.
  for (int row = 0; row < window.rows - 6; ++row) {
    for (int column = 0; column < window.columns; ++column) {
      ASSERT_EQ(screen.at(column, row), table.at(column, row)) << column << ' ' << row;
    }
  }
  program.type("q");
  EXPECT_EQ(program.finish(), 0);
}

TEST_F(ReplayInTerminal, ObeysItsKeysAndGivesTheTerminalBack) {
  support::OnTerminal program([this] { replay({"--paused", "--speed", "0.5"}); });
  ASSERT_TRUE(program.wait_until(shows("0.00000 of ")));
  EXPECT_TRUE(shows("0.5x, paused")(program.seen()));
  program.type("+");
  EXPECT_TRUE(program.wait_until(shows("1x, paused")));
  program.type("\x1b[C");
  EXPECT_TRUE(program.wait_until(shows("0.50000 of ")));
  program.type("n");
  EXPECT_TRUE(program.wait_until(shows("Shot 2 of ")));
  program.type("p");
  EXPECT_TRUE(program.wait_until(shows("Shot 1 of ")));
  program.type("\x1b[F");
  // The ruling comes once the balls have stopped.
  EXPECT_TRUE(program.wait_until(shows("The break is not legal")));
  program.type("q");
  EXPECT_EQ(program.finish(), 0);
  EXPECT_TRUE(program.modes_are_as_before());
  EXPECT_NE(program.seen().find("\x1b[?1049l"), std::string::npos);
}

TEST_F(ReplayInTerminal, PlaysByItselfToTheEndOfTheMatch) {
  const LastShot last = last_shot();
  const std::string number = std::to_string(last.number);
  support::OnTerminal program([&] { replay({"--speed", "16", "--shot", number}); });
  ASSERT_TRUE(program.wait_until(shows("Shot " + number + " of ")));
  char clock[32];
  std::snprintf(clock, sizeof clock, "%.2f of %.2f s", last.end_s, last.end_s);
  EXPECT_TRUE(program.wait_until(shows(clock)));
  program.type("q");
  EXPECT_EQ(program.finish(), 0);
}

}  // namespace
}  // namespace breakshot::client
