// Runs code or a program on a pseudo-terminal of its own, as in a window of 60 columns and 20 rows.
#pragma once

#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <array>
#include <functional>
#include <stdexcept>
#include <string>

namespace breakshot::support {

inline constexpr int terminal_columns = 60;
inline constexpr int terminal_rows = 20;

/// A child process that has the terminal as its standard input, output and error.
class OnTerminal {
 public:
  /// `child` runs in the child process, which exits with 0 when it returns.
  explicit OnTerminal(const std::function<void()>& child) {
    winsize size = size_of(terminal_columns, terminal_rows);
    if (::openpty(&master_, &slave_, nullptr, nullptr, &size) != 0) {
      throw std::runtime_error("openpty failed");
    }
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

  pid_t child() const { return child_; }
  /// All that has been written so far.
  const std::string& seen() const { return seen_; }

  /// Reads until what was seen satisfies `done`; false if nothing more comes.
  bool wait_until(const std::function<bool(const std::string& seen)>& done) {
    while (!done(seen_)) {
      if (!read_some(patience_ms)) return false;
    }
    return true;
  }
  bool wait_for(const std::string& text) {
    return wait_until(
        [&](const std::string& seen) { return seen.find(text) != std::string::npos; });
  }

  void type(const std::string& keys) {
    if (::write(master_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
      throw std::runtime_error("the terminal does not take keys");
    }
  }

  void resize(unsigned short columns, unsigned short rows) {
    const winsize size = size_of(columns, rows);
    ::ioctl(master_, TIOCSWINSZ, &size);
  }

  /// Waits for the child to end and returns its status as waitpid gives it. The slave end that we
  /// hold keeps what it wrote readable.
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
  /// Only a child that hangs is waited for so long.
  static constexpr int patience_ms = 20000;

  int master_ = -1;
  int slave_ = -1;
  pid_t child_ = -1;
  termios before_{};
  std::string seen_;

  static winsize size_of(unsigned short columns, unsigned short rows) {
    winsize size{};
    size.ws_col = columns;
    size.ws_row = rows;
    return size;
  }

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

}  // namespace breakshot::support
