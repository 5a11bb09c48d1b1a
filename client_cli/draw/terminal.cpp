#include "client_cli/draw/terminal.hpp"

#include <poll.h>
#include <signal.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <string_view>

#include "client_cli/command.hpp"

namespace breakshot::client {
namespace {

// Alternate screen, no cursor, no automatic wrapping; and back.
constexpr std::string_view enter_screen = "\x1b[?1049h\x1b[?25l\x1b[?7l\x1b[2J";
constexpr std::string_view leave_screen = "\x1b[?7h\x1b[?25h\x1b[0m\x1b[?1049l";
// Terminals that know it show a frame as a whole; the others ignore it.
constexpr std::string_view begin_frame = "\x1b[?2026h";
constexpr std::string_view end_frame = "\x1b[?2026l";

/// After a lone escape byte, the rest of a sequence comes within this time or never.
constexpr std::chrono::milliseconds escape_wait{40};

// A signal handler has no other way to its data than objects of static storage.
termios found_modes{};                // the terminal's modes before we came
termios own_modes{};                  // and ours
std::atomic<bool> taken = false;      // whether the terminal is ours at the moment
std::atomic<bool> size_news = false;  // SIGWINCH or SIGCONT came
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr std::array<int, 11> deadly = {SIGINT,  SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGABRT,
                                        SIGSEGV, SIGBUS,  SIGFPE, SIGILL,  SIGXCPU};
std::array<struct sigaction, deadly.size()> found_deadly{};
struct sigaction found_stop {};
struct sigaction found_continue {};
struct sigaction found_resize {};

/// Writes all of it; only async-signal-safe calls.
void write_all(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
    if (written > 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      pollfd ready{STDOUT_FILENO, POLLOUT, 0};
      ::poll(&ready, 1, -1);
    } else if (errno != EINTR) {
      return;
    }
  }
}

void give_back() {
  if (!taken.exchange(false)) return;
  write_all(leave_screen);
  ::tcsetattr(STDIN_FILENO, TCSANOW, &found_modes);
}

void take() {
  ::tcsetattr(STDIN_FILENO, TCSANOW, &own_modes);
  write_all(enter_screen);
  taken = true;
}

/// Gives the terminal back and then lets the signal do what it does by default.
void on_deadly(int signal) {
  give_back();
  struct sigaction standard {};
  standard.sa_handler = SIG_DFL;
  ::sigaction(signal, &standard, nullptr);
  ::raise(signal);
}

/// SIGTSTP: stops for real, having given the terminal back; SIGCONT takes it again.
void on_stop(int) {
  const int before = errno;
  give_back();
  ::raise(SIGSTOP);
  errno = before;
}

/// Only in the foreground: a job that goes on in the background leaves the terminal to the shell.
void on_continue(int) {
  const int before = errno;
  if (::tcgetpgrp(STDIN_FILENO) == ::getpgrp()) take();
  size_news = true;
  errno = before;
}

void on_resize(int) {
  size_news = true;
}

/// Leaves alone what is ignored: whoever started us (nohup, say) wants it so.
void catch_signal(int signal, void (*function)(int), struct sigaction& found) {
  ::sigaction(signal, nullptr, &found);
  if (found.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = function;
  ::sigfillset(&action.sa_mask);
  ::sigaction(signal, &action, nullptr);
}

void catch_signals() {
  for (std::size_t i = 0; i < deadly.size(); ++i) {
    catch_signal(deadly[i], on_deadly, found_deadly[i]);
  }
  catch_signal(SIGTSTP, on_stop, found_stop);
  catch_signal(SIGCONT, on_continue, found_continue);
  catch_signal(SIGWINCH, on_resize, found_resize);
}

void leave_signals() {
  for (std::size_t i = 0; i < deadly.size(); ++i) {
    ::sigaction(deadly[i], &found_deadly[i], nullptr);
  }
  ::sigaction(SIGTSTP, &found_stop, nullptr);
  ::sigaction(SIGCONT, &found_continue, nullptr);
  ::sigaction(SIGWINCH, &found_resize, nullptr);
}

}  // namespace

Terminal::Terminal(const Abilities& abilities) : abilities_(abilities) {
  if (::tcgetattr(STDIN_FILENO, &found_modes) != 0 || ::isatty(STDOUT_FILENO) != 1) {
    throw CommandError("standard input and output are not a terminal");
  }
  own_modes = found_modes;
  // Signals stay on, so that Ctrl-C and Ctrl-Z work as everywhere.
  own_modes.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  own_modes.c_cc[VMIN] = 1;
  own_modes.c_cc[VTIME] = 0;
  static const bool at_exit = std::atexit(give_back) == 0;
  if (!at_exit) throw CommandError("the terminal cannot be taken over: too many exit handlers");
  catch_signals();
  take();
}

Terminal::~Terminal() {
  give_back();
  leave_signals();
}

void Terminal::show(const Grid& grid) {
  const std::string change = transition(shown_ ? &*shown_ : nullptr, grid, abilities_.colours);
  shown_ = grid;
  if (change.empty() || !taken) return;
  std::string frame(begin_frame);
  frame += change;
  frame += end_frame;
  write_all(frame);
}

std::optional<Key> Terminal::key(std::chrono::milliseconds wait) {
  if (const auto key = decoder_.next()) return key;
  const bool came = read_bytes(wait);
  if (size_news.exchange(false)) {
    // Whatever the terminal made of the old picture, it is drawn afresh.
    shown_.reset();
    write_all("\x1b[2J");
    return Special::resized;
  }
  if (!came) return std::nullopt;
  if (const auto key = decoder_.next()) return key;
  if (read_bytes(escape_wait)) return decoder_.next();
  decoder_.pause();
  return decoder_.next();
}

/// Whether something came in time. The end of the terminal counts as a key.
bool Terminal::read_bytes(std::chrono::milliseconds wait) {
  pollfd ready{STDIN_FILENO, POLLIN, 0};
  const int count = ::poll(&ready, 1, static_cast<int>(std::max<std::int64_t>(wait.count(), 0)));
  if (count <= 0) return false;
  std::array<char, 256> buffer{};
  const ssize_t got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
  if (got > 0) {
    decoder_.feed({buffer.data(), static_cast<std::size_t>(got)});
    return true;
  }
  const bool over = got == 0 || (errno != EINTR && errno != EAGAIN);
  if (over) decoder_.close();
  return over;
}

}  // namespace breakshot::client
