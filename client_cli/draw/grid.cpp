#include "client_cli/draw/grid.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

#include "common/record/text.hpp"

namespace breakshot::client {
namespace {

struct Range {
  char32_t first;
  char32_t last;
};

template <std::size_t N>
bool within(const std::array<Range, N>& ranges, char32_t glyph) {
  return std::any_of(ranges.begin(), ranges.end(), [glyph](const Range& range) {
    return glyph >= range.first && glyph <= range.last;
  });
}

/// "48;2;r;g;b" or "48;5;n".
std::string colour_code(int plane, Rgb colour, ColourDepth colours) {
  const std::string start = std::to_string(plane);
  if (colours == ColourDepth::indexed) {
    return start + ";5;" + std::to_string(indexed_colour(colour));
  }
  return start + ";2;" + std::to_string(colour.red) + ";" + std::to_string(colour.green) + ";" +
         std::to_string(colour.blue);
}

/// Remembers where the cursor is and in which colours it writes, to say no more than needed.
class Pen {
 public:
  explicit Pen(ColourDepth colours) : colours_(colours) {}

  void draw(int column, int row, const Cell& cell) {
    if (column != column_ || row != row_) {
      out_ += "\x1b[" + std::to_string(row + 1) + ";" + std::to_string(column + 1) + "H";
    }
    if (colours_ != ColourDepth::none) {
      if (ink_ != cell.ink) out_ += "\x1b[" + colour_code(38, cell.ink, colours_) + "m";
      if (ground_ != cell.ground) out_ += "\x1b[" + colour_code(48, cell.ground, colours_) + "m";
      ink_ = cell.ink;
      ground_ = cell.ground;
    }
    out_ += utf8_of(cell.glyph);
    column_ = column + columns_of(cell.glyph);
    row_ = row;
  }

  /// The cursor stands at the start of a row already.
  void begin_line(int row) {
    column_ = 0;
    row_ = row;
  }
  void plain() {
    if (ink_ || ground_) out_ += "\x1b[0m";
    ink_.reset();
    ground_.reset();
  }
  void end_line() {
    plain();
    out_ += '\n';
  }

  std::string take() {
    plain();
    return std::move(out_);
  }

 private:
  ColourDepth colours_;
  std::string out_;
  int column_ = -1;
  int row_ = -1;
  std::optional<Rgb> ink_;
  std::optional<Rgb> ground_;
};

}  // namespace

Grid::Grid(TerminalSize size)
    : size_(size),
      cells_(static_cast<std::size_t>(size.columns) * static_cast<std::size_t>(size.rows)) {}

bool Grid::holds(int column, int row) const {
  return column >= 0 && row >= 0 && column < size_.columns && row < size_.rows;
}

Cell& Grid::at(int column, int row) {
  return cells_.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.columns) +
                   static_cast<std::size_t>(column));
}

const Cell& Grid::at(int column, int row) const {
  return const_cast<Grid&>(*this).at(column, row);
}

int Grid::write(int column, int row, std::string_view text, Rgb ink, Rgb ground) {
  while (!text.empty()) {
    const record::Character character = record::first_of(text);
    const bool clean = character.bytes > 0 && !record::unprintable(character.code_point);
    const char32_t glyph = clean ? character.code_point : U'?';
    text.remove_prefix(std::max<std::size_t>(character.bytes, 1));
    const int width = columns_of(glyph);
    if (width == 0) continue;
    if (!holds(column, row) || !holds(column + width - 1, row)) break;
    at(column, row) = {glyph, ink, ground};
    if (width == 2) at(column + 1, row) = {0, ink, ground};
    column += width;
  }
  return column;
}

int columns_of(char32_t glyph) {
  // The blocks of Unicode's EastAsianWidth.txt and of its combining marks that names are made of.
  static constexpr std::array<Range, 4> combining = {
      {{0x300, 0x36f}, {0x1ab0, 0x1aff}, {0x20d0, 0x20ff}, {0xfe00, 0xfe0f}}};
  static constexpr std::array<Range, 9> wide = {{{0x1100, 0x115f},
                                                 {0x2e80, 0xa4cf},
                                                 {0xac00, 0xd7a3},
                                                 {0xf900, 0xfaff},
                                                 {0xfe30, 0xfe6f},
                                                 {0xff00, 0xff60},
                                                 {0xffe0, 0xffe6},
                                                 {0x1f300, 0x1faff},
                                                 {0x20000, 0x3fffd}}};
  if (glyph < 0x300) return 1;
  if (within(combining, glyph)) return 0;
  return within(wide, glyph) ? 2 : 1;
}

std::string utf8_of(char32_t code_point) {
  const auto byte = [](char32_t value) { return static_cast<char>(value); };
  const auto tail = [&](int shift) { return byte(0x80 | ((code_point >> shift) & 0x3f)); };
  if (code_point < 0x80) return {byte(code_point)};
  if (code_point < 0x800) return {byte(0xc0 | (code_point >> 6)), tail(0)};
  if (code_point < 0x10000) return {byte(0xe0 | (code_point >> 12)), tail(6), tail(0)};
  return {byte(0xf0 | (code_point >> 18)), tail(12), tail(6), tail(0)};
}

int indexed_colour(Rgb colour) {
  static constexpr std::array<int, 6> levels = {0, 95, 135, 175, 215, 255};
  const auto level_of = [](int value) {
    const auto nearer = [value](int a, int b) { return std::abs(a - value) < std::abs(b - value); };
    return static_cast<int>(std::min_element(levels.begin(), levels.end(), nearer) -
                            levels.begin());
  };
  const int red = level_of(colour.red);
  const int green = level_of(colour.green);
  const int blue = level_of(colour.blue);
  const auto distance = [&colour](int r, int g, int b) {
    return (r - colour.red) * (r - colour.red) + (g - colour.green) * (g - colour.green) +
           (b - colour.blue) * (b - colour.blue);
  };
  const auto level = [](int index) { return levels[static_cast<std::size_t>(index)]; };
  const int mean = (colour.red + colour.green + colour.blue) / 3;
  const int grey = std::clamp((mean - 3) / 10, 0, 23);
  const int shade = 8 + 10 * grey;
  const bool grey_is_nearer =
      distance(shade, shade, shade) < distance(level(red), level(green), level(blue));
  return grey_is_nearer ? 232 + grey : 16 + 36 * red + 6 * green + blue;
}

std::string transition(const Grid* before, const Grid& next, ColourDepth colours) {
  const bool whole = before == nullptr || before->size() != next.size();
  Pen pen(colours);
  for (int row = 0; row < next.size().rows; ++row) {
    for (int column = 0; column < next.size().columns; ++column) {
      const Cell& cell = next.at(column, row);
      if (cell.glyph == 0) continue;
      if (whole || before->at(column, row) != cell) pen.draw(column, row, cell);
    }
  }
  return pen.take();
}

std::string scrolling_text_of(const Grid& grid, ColourDepth colours) {
  Pen pen(colours);
  for (int row = 0; row < grid.size().rows; ++row) {
    if (row > 0) pen.end_line();
    pen.begin_line(row);
    for (int column = 0; column < grid.size().columns; ++column) {
      const Cell& cell = grid.at(column, row);
      if (cell.glyph != 0) pen.draw(column, row, cell);
    }
  }
  return pen.take();
}

std::string text_of(const Grid& grid) {
  std::string text;
  for (int row = 0; row < grid.size().rows; ++row) {
    std::string line;
    for (int column = 0; column < grid.size().columns; ++column) {
      if (grid.at(column, row).glyph != 0) line += utf8_of(grid.at(column, row).glyph);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

}  // namespace breakshot::client
