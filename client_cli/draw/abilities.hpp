// What the terminal can show, decided from the user's wish and the environment.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "client_cli/command.hpp"

namespace breakshot::client {

enum class ColourDepth { none, indexed, direct };

struct Abilities {
  bool interactive = false;  ///< standard input and output are a terminal that can move its cursor
  ColourDepth colours = ColourDepth::none;  ///< 256 (indexed) or 24 bits (direct)
  bool unicode = false;

  friend bool operator==(const Abilities&, const Abilities&) = default;
};

/// The value of a variable of the environment, if it is set.
using Environment = std::function<std::optional<std::string>(const char* name)>;

/// `is_terminal`: whether standard input and output both are one. `Colour::automatic` honours
/// NO_COLOR (no-color.org) and TERM=dumb.
Abilities abilities_of(Colour wish, bool is_terminal, const Environment& environment);

/// Of this process.
Abilities abilities_of(Colour wish);

struct TerminalSize {
  int columns = 80;
  int rows = 24;

  friend bool operator==(const TerminalSize&, const TerminalSize&) = default;
};

inline constexpr int max_terminal_side = 1000;

/// COLUMNS and LINES where they are numbers in [1, max_terminal_side], as everywhere in Unix, else
/// what the terminal says, else 80 x 24.
TerminalSize terminal_size(std::optional<TerminalSize> asked, const Environment& environment);

/// Of this process's standard output.
TerminalSize terminal_size();

}  // namespace breakshot::client
