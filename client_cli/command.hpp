// The shape that every command of `breakshot` has: one file under commands/, one function that adds
// it to the program, one line in commands.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "client_cli/command_error.hpp"

namespace breakshot::client {

enum class Colour { automatic, always, never };

/// Options that may stand before or after the name of any command.
struct Globals {
  std::string server;  ///< HOST, HOST:PORT or [HOST]:PORT, see server_address.hpp
  bool json = false;   ///< one JSON object a line instead of text for people
  Colour colour = Colour::automatic;
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
