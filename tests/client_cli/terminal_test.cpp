// The terminal is given back as it was found, whatever ends the program.
#include "client_cli/draw/terminal.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <functional>

#include "client_cli/command.hpp"
#include "tests/support/pseudo_terminal.hpp"

namespace breakshot::client {
namespace {

constexpr Abilities abilities{true, ColourDepth::direct, true};
constexpr const char* leaves_alternate_screen = "\x1b[?1049l";
constexpr const char* shows_cursor = "\x1b[?25h";

Grid saying(const std::string& text) {
  Grid grid({20, 1});
  grid.write(0, 0, text);
  return grid;
}

/// What a program does until it is ended from outside.
void show_and_wait() {
  Terminal terminal(abilities);
  terminal.show(saying("ready"));
  for (;;) terminal.key(std::chrono::milliseconds(1000));
}

void expect_given_back(const support::OnTerminal& terminal) {
  const std::size_t last_text = terminal.seen().rfind("ready");
  ASSERT_NE(last_text, std::string::npos);
  EXPECT_NE(terminal.seen().find(leaves_alternate_screen, last_text), std::string::npos);
  EXPECT_NE(terminal.seen().find(shows_cursor, last_text), std::string::npos);
  EXPECT_TRUE(terminal.modes_are_as_before());
}

TEST(Terminal, IsGivenBackOnEveryDeadlySignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT}) {
    SCOPED_TRACE(strsignal(signal));
    support::OnTerminal program(show_and_wait);
    ASSERT_TRUE(program.wait_for("ready"));
    EXPECT_FALSE(program.modes_are_as_before());
    ::kill(program.child(), signal);
    const int status = program.finish();
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    expect_given_back(program);
  }
}

TEST(Terminal, LeavesIgnoredSignalsIgnored) {
  support::OnTerminal program([] {
    ::signal(SIGHUP, SIG_IGN);
    Terminal terminal(abilities);
    terminal.show(saying("ready"));
    while (terminal.key(std::chrono::milliseconds(1000)) != Key(U'q')) {
    }
  });
  ASSERT_TRUE(program.wait_for("ready"));
  ::kill(program.child(), SIGHUP);
  program.type("q");
  EXPECT_EQ(program.finish(), 0);
}

TEST(Terminal, IsGivenBackByTheDestructorAnExceptionAndExit) {
  const std::array<std::function<void()>, 3> ways = {[] {
                                                       Terminal terminal(abilities);
                                                       terminal.show(saying("ready"));
                                                     },
                                                     [] {
                                                       try {
                                                         Terminal terminal(abilities);
                                                         terminal.show(saying("ready"));
                                                         throw std::runtime_error("no");
                                                       } catch (const std::exception&) {
                                                       }
                                                     },
                                                     [] {
                                                       Terminal terminal(abilities);
                                                       terminal.show(saying("ready"));
                                                       std::exit(0);
                                                     }};
  for (const auto& way : ways) {
    support::OnTerminal program(way);
    EXPECT_EQ(program.finish(), 0);
    expect_given_back(program);
  }
}

TEST(Terminal, StopsAndComesBackWithItsPicture) {
  support::OnTerminal program(show_and_wait);
  ASSERT_TRUE(program.wait_for("ready"));
  ::kill(program.child(), SIGTSTP);
  int status = 0;
  ASSERT_EQ(::waitpid(program.child(), &status, WUNTRACED), program.child());
  EXPECT_TRUE(WIFSTOPPED(status));
  ASSERT_TRUE(program.wait_for(leaves_alternate_screen));
  EXPECT_TRUE(program.modes_are_as_before());
  const std::string again = "\x1b[?1049h";
  const std::size_t entered_before = program.seen().find(again);
  ::kill(program.child(), SIGCONT);
  ASSERT_TRUE(program.wait_for("\x1b[2J\x1b[2J"));
  EXPECT_NE(program.seen().find(again, entered_before + 1), std::string::npos);
  EXPECT_FALSE(program.modes_are_as_before());
  ::kill(program.child(), SIGTERM);
  program.finish();
  EXPECT_TRUE(program.modes_are_as_before());
}

TEST(Terminal, TellsKeysAndChangesOfSize) {
  support::OnTerminal program([] {
    Terminal terminal(abilities);
    terminal.show(saying("ready"));
    for (;;) {
      const auto key = terminal.key(std::chrono::milliseconds(1000));
      if (key == Key(Special::up)) terminal.show(saying("UP"));
      if (key == Key(Special::escape)) terminal.show(saying("ESC"));
      if (key == Key(Special::resized)) {
        terminal.show(saying("W" + std::to_string(terminal.size().columns)));
      }
      if (key == Key(U'q')) return;
    }
  });
  ASSERT_TRUE(program.wait_for("ready"));
  program.type("\x1b[A");
  EXPECT_TRUE(program.wait_for("UP"));
  program.type("\x1b");
  EXPECT_TRUE(program.wait_for("ESC"));
  program.resize(91, 30);
  EXPECT_TRUE(program.wait_for("W91"));
  program.type("q");
  EXPECT_EQ(program.finish(), 0);
  EXPECT_TRUE(program.modes_are_as_before());
}

TEST(Terminal, RefusesWhatIsNoTerminal) {
  support::OnTerminal program([] {
    ::close(STDIN_FILENO);
    try {
      Terminal terminal(abilities);
    } catch (const CommandError&) {
      ::_exit(3);
    }
  });
  EXPECT_EQ(WEXITSTATUS(program.finish()), 3);
  EXPECT_EQ(program.seen(), "");
}

}  // namespace
}  // namespace breakshot::client
