// The terminal is given back as it was found, whatever ends the program.
#include "client_cli/draw/terminal.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <array>
#include <functional>

#include "client_cli/command.hpp"

namespace breakshot::client {
namespace {

constexpr Abilities abilities{true, ColourDepth::direct, true};
constexpr const char* leaves_alternate_screen = "\x1b[?1049l";
constexpr const char* shows_cursor = "\x1b[?25h";

/// A child process on a pseudo-terminal of its own.
class OnTerminal {
 public:
  explicit OnTerminal(const std::function<void()>& child) {
    winsize size{};
    size.ws_col = 60;
    size.ws_row = 20;
    if (::openpty(&master_, &slave_, nullptr, nullptr, &size) != 0) std::abort();
    ::tcgetattr(slave_, &before_);
    child_ = ::fork();
    if (child_ != 0) return;
    ::close(master_);
    ::login_tty(slave_);
    child();
    ::_exit(0);
  }
  ~OnTerminal() {
    ::close(master_);
    ::close(slave_);
  }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  int child() const { return child_; }
  const std::string& seen() const { return seen_; }

  /// Reads until `text` has been written; false if the child ended before.
  bool wait_for(const std::string& text) {
    while (seen_.find(text) == std::string::npos) {
      if (!read_some(20000)) return false;
    }
    return true;
  }

  void type(const std::string& keys) {
    ASSERT_EQ(::write(master_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }

  void resize(unsigned short columns, unsigned short rows) {
    winsize size{};
    size.ws_col = columns;
    size.ws_row = rows;
    ::ioctl(master_, TIOCSWINSZ, &size);
  }

  /// Waits for the child; the slave end that we hold keeps what it wrote readable.
  int finish() {
    int status = 0;
    ::waitpid(child_, &status, 0);
    while (read_some(0)) {
    }
    return status;
  }

  bool modes_are_as_before() const {
    termios now{};
    ::tcgetattr(slave_, &now);
    return now.c_lflag == before_.c_lflag && now.c_iflag == before_.c_iflag;
  }

 private:
  int master_ = -1;
  int slave_ = -1;
  pid_t child_ = -1;
  termios before_{};
  std::string seen_;

  bool read_some(int wait_ms) {
    pollfd ready{master_, POLLIN, 0};
    if (::poll(&ready, 1, wait_ms) <= 0) return false;
    std::array<char, 4096> buffer{};
    const ssize_t got = ::read(master_, buffer.data(), buffer.size());
    if (got <= 0) return false;
    seen_.append(buffer.data(), static_cast<std::size_t>(got));
    return true;
  }
};

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

void expect_given_back(const OnTerminal& terminal) {
  const std::size_t last_text = terminal.seen().rfind("ready");
  ASSERT_NE(last_text, std::string::npos);
  EXPECT_NE(terminal.seen().find(leaves_alternate_screen, last_text), std::string::npos);
  EXPECT_NE(terminal.seen().find(shows_cursor, last_text), std::string::npos);
  EXPECT_TRUE(terminal.modes_are_as_before());
}

TEST(Terminal, IsGivenBackOnEveryDeadlySignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT}) {
    SCOPED_TRACE(strsignal(signal));
    OnTerminal program(show_and_wait);
    ASSERT_TRUE(program.wait_for("ready"));
    EXPECT_FALSE(program.modes_are_as_before());
    ::kill(program.child(), signal);
    const int status = program.finish();
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    expect_given_back(program);
  }
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
    OnTerminal program(way);
    EXPECT_EQ(program.finish(), 0);
    expect_given_back(program);
  }
}

TEST(Terminal, StopsAndComesBackWithItsPicture) {
  OnTerminal program(show_and_wait);
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
  OnTerminal program([] {
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
  OnTerminal program([] {
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
