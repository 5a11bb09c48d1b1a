// What a terminal shows: character cells, and the escape sequences that bring a screen from one
// grid to the next.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client_cli/draw/abilities.hpp"
#include "client_cli/draw/palette.hpp"

namespace breakshot::client {

struct Cell {
  /// 0: covered by the wide character to the left.
  char32_t glyph = U' ';
  Rgb ink = palette::caption;
  Rgb ground = palette::background;

  friend bool operator==(const Cell&, const Cell&) = default;
};

class Grid {
 public:
  explicit Grid(TerminalSize size);

  TerminalSize size() const { return size_; }
  bool holds(int column, int row) const;
  /// Column 0, row 0 is the upper left cell; the cell must be within the grid.
  Cell& at(int column, int row);
  const Cell& at(int column, int row) const;

  /// Writes UTF-8 from a cell to the right and cuts it off at the edge; what would not print as
  /// itself becomes a question mark. Returns the column after the text.
  int write(int column, int row, std::string_view text, Rgb ink = palette::caption,
            Rgb ground = palette::background);

  friend bool operator==(const Grid&, const Grid&) = default;

 private:
  TerminalSize size_;
  std::vector<Cell> cells_;
};

inline bool operator!=(const Grid& a, const Grid& b) {
  return !(a == b);
}

/// How many columns a character takes: 0 for marks that combine with the one before, 2 for the wide
/// ones of East Asia and most emoji, 1 for all others.
int columns_of(char32_t glyph);

std::string utf8_of(char32_t code_point);

/// The nearest of the 256 indexed colours: its cube of 216 or its 24 greys.
int indexed_colour(Rgb colour);

/// Escape sequences that turn a screen showing `before` into one showing `next`; everything is
/// written where `before` is missing or of another size.
std::string transition(const Grid* before, const Grid& next, ColourDepth colours);

/// The grid as lines that scroll with the rest of a terminal's text: colours are set within each
/// line and taken back at its end; the last line has no end.
std::string scrolling_text_of(const Grid& grid, ColourDepth colours);

/// The grid's characters as lines of text without any escape, blanks at the end left out.
std::string text_of(const Grid& grid);

}  // namespace breakshot::client
