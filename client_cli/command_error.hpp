// How a command ends where it cannot do what was asked. Apart from command.hpp, so that what a
// command is made of does not have to know how command lines are read.
#pragma once

#include <stdexcept>
#include <string>

namespace breakshot::client {

// Exit statuses. A command that needs others documents them in its --help.
inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;        ///< the answer is no, or the world failed
inline constexpr int exit_usage = 2;         ///< the command line or its input cannot be understood
inline constexpr int exit_not_revealed = 3;  ///< `verify`: the match still keeps its secret

/// Ends a command: main prints "breakshot: <what>" on standard error and exits with `status`.
class CommandError : public std::runtime_error {
 public:
  explicit CommandError(const std::string& what, int status = exit_failed)
      : std::runtime_error(what), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

}  // namespace breakshot::client
