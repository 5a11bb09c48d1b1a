#include "client_cli/draw/abilities.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace breakshot::client {
namespace {

std::optional<std::string> process_environment(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr) return std::nullopt;
  return value;
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

/// The codeset by the names that POSIX gives precedence. Where none is set, as in containers,
/// terminals of today still take UTF-8.
bool speaks_unicode(const Environment& environment) {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    std::string value = environment(name).value_or("");
    if (value.empty()) continue;
    std::transform(value.begin(), value.end(), value.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return contains(value, "utf-8") || contains(value, "utf8");
  }
  return true;
}

ColourDepth depth_of(const Environment& environment) {
  const std::string colours = environment("COLORTERM").value_or("");
  if (colours == "truecolor" || colours == "24bit") return ColourDepth::direct;
  return contains(environment("TERM").value_or(""), "direct") ? ColourDepth::direct
                                                              : ColourDepth::indexed;
}

std::optional<int> side_of(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  int value = 0;
  const char* end = text->data() + text->size();
  const auto [last, error] = std::from_chars(text->data(), end, value);
  if (error != std::errc{} || last != end || value < 1 || value > max_terminal_side) {
    return std::nullopt;
  }
  return value;
}

}  // namespace

Abilities abilities_of(Colour wish, bool is_terminal, const Environment& environment) {
  const std::string term = environment("TERM").value_or("");
  Abilities abilities;
  abilities.interactive = is_terminal && !term.empty() && term != "dumb";
  abilities.unicode = speaks_unicode(environment);
  const bool unwanted = !environment("NO_COLOR").value_or("").empty();
  const bool coloured =
      wish == Colour::always || (wish == Colour::automatic && abilities.interactive && !unwanted);
  if (coloured) abilities.colours = depth_of(environment);
  return abilities;
}

Abilities abilities_of(Colour wish) {
  return abilities_of(wish, ::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1,
                      process_environment);
}

TerminalSize terminal_size(std::optional<TerminalSize> asked, const Environment& environment) {
  TerminalSize size = asked.value_or(TerminalSize{});
  size.columns = side_of(environment("COLUMNS")).value_or(size.columns);
  size.rows = side_of(environment("LINES")).value_or(size.rows);
  return {std::clamp(size.columns, 1, max_terminal_side),
          std::clamp(size.rows, 1, max_terminal_side)};
}

TerminalSize terminal_size() {
  winsize window{};
  std::optional<TerminalSize> asked;
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col > 0 && window.ws_row > 0) {
    asked = TerminalSize{window.ws_col, window.ws_row};
  }
  return terminal_size(asked, process_environment);
}

}  // namespace breakshot::client
