// The shape that every command of `breakshot` has: one file under commands/, one function that adds
// it to the program, one line in commands.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace breakshot::client {

// Exit statuses. A command that needs others documents them in its --help.
inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;        ///< the answer is no, or the world failed
inline constexpr int exit_usage = 2;         ///< the command line or its input cannot be understood
inline constexpr int exit_not_revealed = 3;  ///< `verify`: the match still keeps its secret

enum class Colour { automatic, always, never };

/// Options that may stand before or after the name of any command.
struct Globals {
  std::string server;  ///< HOST, HOST:PORT or [HOST]:PORT, see server_address.hpp
  bool json = false;   ///< one JSON object a line instead of text for people
  Colour colour = Colour::automatic;
};

/// Ends a command: main prints "breakshot: <what>" on standard error and exits with `status`.
class CommandError : public std::runtime_error {
 public:
  explicit CommandError(const std::string& what, int status = exit_failed)
      : std::runtime_error(what), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

/// A command that has been added: its parser, and what to run once the line has been parsed.
struct Command {
  CLI::App* parser = nullptr;
  std::function<int()> run;  ///< returns the exit status
};

/// `globals` is filled in by the time the command runs and outlives it.
using AddCommand = Command (*)(CLI::App& program, const Globals& globals);

/// Every command of the program, in the order in which --help lists them.
const std::vector<AddCommand>& commands();

}  // namespace breakshot::client
