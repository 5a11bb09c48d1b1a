#include "client_cli/draw/table_grid.hpp"

#include <algorithm>
#include <cmath>

#include "client_cli/draw/image.hpp"

namespace breakshot::client {
namespace {

using physics::Vec2;

/// A rectangle of cells.
struct Region {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;
};

constexpr char32_t upper_half = U'\u2580';
/// Fewer rows of table than this tell nobody anything.
constexpr int least_table_rows = 4;
/// A ball is drawn at least this large, or it would be lost between two pixels.
constexpr double least_radius_px = 1.0;

/// The bed, the cushions and a strip of the wood: a terminal has no pixels for more.
Box coarse_world(const Table& table) {
  const double rail = cushion_width(table) + 0.35 * wood_width(table);
  const Vec2 reach{rail, rail};
  return {table.bed.low - reach, table.bed.high + reach};
}

std::string digits_of(physics::BallId ball) {
  return std::to_string(number(ball));
}

struct Label {
  Rgb ink;
  Rgb ground;
};

/// Solids are pale digits on their colour, stripes coloured digits on ivory.
Label label_of(physics::BallId ball) {
  const Rgb colour = colour_of(ball);
  if (is_striped(ball)) return {mixed(colour, palette::ink, 0.3), palette::ivory};
  return {readable_on(colour), colour};
}

void put_pixels(Grid& grid, const Region& region, const Image& image) {
  for (int row = 0; row < region.rows; ++row) {
    for (int column = 0; column < region.columns; ++column) {
      grid.at(region.column + column, region.row + row) = {upper_half, image.at(column, 2 * row),
                                                           image.at(column, 2 * row + 1)};
    }
  }
}

/// The number of a ball on the cells nearest to its centre, unless another number is there.
void put_number(Grid& grid, const Region& region, Vec2 pixel, const DrawnBall& ball) {
  const std::string digits = digits_of(ball.id);
  const int width = static_cast<int>(digits.size());
  const int column = region.column + static_cast<int>(std::lround(pixel.x - width / 2.0));
  const int row = region.row + static_cast<int>(std::floor(pixel.y / 2));
  for (int i = 0; i < width; ++i) {
    if (!grid.holds(column + i, row) || grid.at(column + i, row).glyph != upper_half) return;
  }
  const Label label = label_of(ball.id);
  grid.write(column, row, digits, label.ink, label.ground);
}

void put_coloured_table(Grid& grid, const Region& region, const Picture& picture) {
  const PixelSize size{region.columns, 2 * region.rows};
  const Box world = coarse_world(picture.table);
  const View view(world, size.width, size.height);
  Picture visible = picture;
  const double radius_px = picture.table.ball_radius_m * view.px_per_m();
  const double enlarged = std::max(1.0, least_radius_px / radius_px);
  for (DrawnBall& ball : visible.balls) ball.scale *= enlarged;
  put_pixels(grid, region, image_of(visible, world, size, Detail::coarse));
  for (const DrawnBall& ball : picture.balls) {
    const bool has_number = number(ball.id) != 0 && number(ball.id) < 100 && ball.scale == 1;
    if (has_number) put_number(grid, region, view.pixel_of(ball.position), ball);
  }
}

/// One character a ball, for tables without colour.
char32_t letter_of(physics::BallId ball) {
  const std::uint32_t n = number(ball);
  if (n < 10) return U'0' + n;
  return n < 16 ? U'a' + (n - 10) : U'*';
}

/// Cells are about twice as high as they are wide.
class PlainTable {
 public:
  PlainTable(Grid& grid, const Region& region, const Table& table)
      : grid_(grid),
        region_(region),
        view_(table.bed, region.columns - 2, 2.0 * (region.rows - 2)) {}

  void border(const Table& table) {
    const auto put = [&](int column, int row, char32_t glyph) {
      if (!is_pocket(table, column, row)) cell(column, row).glyph = glyph;
    };
    for (int column = 0; column < region_.columns; ++column) {
      put(column, 0, U'-');
      put(column, region_.rows - 1, U'-');
    }
    for (int row = 1; row + 1 < region_.rows; ++row) {
      put(0, row, U'|');
      put(region_.columns - 1, row, U'|');
    }
  }

  void line(Vec2 from, Vec2 to) {
    const Vec2 a = view_.pixel_of(from);
    const Vec2 b = view_.pixel_of(to);
    const int steps = static_cast<int>(std::ceil(physics::length(b - a))) + 1;
    for (int i = 0; i <= steps; ++i) {
      const Vec2 at = a + (b - a) * (double(i) / steps);
      if (Cell* free = inner(at, 0); free != nullptr) free->glyph = U'.';
    }
  }

  /// A ball takes the nearest cell that no other ball has.
  void ball(const DrawnBall& ball) {
    const Vec2 at = view_.pixel_of(ball.position);
    for (const int aside : {0, 1, -1, 2, -2}) {
      Cell* free = inner(at, aside);
      if (free == nullptr || (free->glyph != U' ' && free->glyph != U'.')) continue;
      free->glyph = letter_of(ball.id);
      return;
    }
  }

 private:
  Grid& grid_;
  Region region_;
  View view_;

  Cell& cell(int column, int row) { return grid_.at(region_.column + column, region_.row + row); }

  Cell* inner(Vec2 pixel, int aside) {
    const int column = 1 + static_cast<int>(std::floor(pixel.x)) + aside;
    const int row = 1 + static_cast<int>(std::floor(pixel.y / 2));
    const bool within =
        column > 0 && row > 0 && column + 1 < region_.columns && row + 1 < region_.rows;
    return within ? &cell(column, row) : nullptr;
  }

  /// A gap where the border's cell is near a pocket.
  bool is_pocket(const Table& table, int column, int row) const {
    for (const DrawnPocket& pocket : table.pockets) {
      const Vec2 corner = {std::clamp(pocket.centre.x, table.bed.low.x, table.bed.high.x),
                           std::clamp(pocket.centre.y, table.bed.low.y, table.bed.high.y)};
      const Vec2 pixel = view_.pixel_of(corner);
      const double across = std::abs(column - 0.5 - pixel.x);
      const double down = std::abs(2 * row - 1 - pixel.y);
      const double reach = std::max(2.5, 0.6 * pocket.radius_m * view_.px_per_m());
      if (across < reach && down < reach) return true;
    }
    return false;
  }
};

void put_plain_table(Grid& grid, const Region& region, const Picture& picture) {
  if (region.columns < 5 || region.rows < 3) return;
  PlainTable table(grid, region, picture.table);
  table.border(picture.table);
  for (const DrawnPath& path : picture.paths) {
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      table.line(path.points[i - 1], path.points[i]);
    }
  }
  if (picture.cue) {
    const CueVector& cue = *picture.cue;
    table.line(cue.from, cue.from + cue.direction * (cue.speed_m_s * cue_vector_s));
  }
  for (const DrawnBall& ball : picture.balls) table.ball(ball);
}

/// The pocketed balls and after them the caption.
void put_caption(Grid& grid, int row, const Picture& picture, bool coloured) {
  int column = 1;
  for (const physics::BallId ball : picture.pocketed) {
    const Label label = label_of(ball);
    const std::string digits = digits_of(ball);
    const std::string chip = digits.size() == 1 ? " " + digits : digits;
    column = 1 + (coloured ? grid.write(column, row, chip, label.ink, label.ground)
                           : grid.write(column, row, digits));
  }
  if (column > 1) ++column;
  grid.write(column, row, picture.caption);
}

/// Where the table goes: as large as its shape allows, in the middle of the columns. A plain table
/// has a border of one cell.
Region table_region(const Picture& picture, TerminalSize size, int rows, bool coloured) {
  const Box world = coloured ? coarse_world(picture.table) : picture.table.bed;
  const int border = coloured ? 0 : 2;
  // In cells, which are twice as high as they are wide.
  const double shape = 2 * world.width() / world.height();
  const auto cells = [](double length) { return static_cast<int>(std::lround(length)); };
  const int inner = std::min(size.columns - border, cells((rows - border) * shape));
  const int fitting = std::min(rows - border, cells(std::ceil(inner / shape)));
  const int columns = std::max(inner, 0) + border;
  return {(size.columns - columns) / 2, 0, std::min(columns, size.columns),
          std::max(fitting, 0) + border};
}

}  // namespace

Grid grid_of(const Picture& picture, const std::vector<std::string>& lines, TerminalSize size,
             const Abilities& abilities) {
  const bool coloured = abilities.colours != ColourDepth::none && abilities.unicode;
  Grid grid(size);
  const int footer = 1 + static_cast<int>(lines.size());
  const int rows = size.rows - footer;
  int row = 0;
  if (rows >= least_table_rows) {
    const Region region = table_region(picture, size, rows, coloured);
    if (coloured) {
      put_coloured_table(grid, region, picture);
    } else {
      put_plain_table(grid, region, picture);
    }
    row = region.rows;
  }
  put_caption(grid, row, picture, coloured);
  for (const std::string& line : lines) grid.write(1, ++row, line);
  return grid;
}

std::string plain_text_of(const Picture& picture, int columns) {
  const double shape = picture.table.bed.width() / picture.table.bed.height();
  const int rows = 2 + std::max(1, static_cast<int>(std::lround((columns - 2) / shape / 2)));
  Grid grid({columns, rows});
  put_plain_table(grid, {0, 0, columns, rows}, picture);
  return text_of(grid) + "0 cue ball, 1 to 9 and a to f (10 to 15)\n";
}

}  // namespace breakshot::client
