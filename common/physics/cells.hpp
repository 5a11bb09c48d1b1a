// The plane in square cells, and the balls that are in each. The plane has no border: cells far
// apart share one list, as if it were wound round a torus, so that memory goes with the number of
// balls, not with the area that they fly over.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "common/physics/detect.hpp"
#include "common/physics/fetch_memory.hpp"
#include "common/physics/gathered.hpp"

namespace breakshot::physics {

/// Where a ball leaves its cell, and in how long. Ahead is even.
enum class Side : std::uint8_t { right, left, up, down };

template <class Real>
struct Crossing {
  Real after_s = never<Real>;
  Side side = Side::right;
};

/// The cell that a ball is in.
struct Place {
  std::int64_t column = 0;
  std::int64_t row = 0;

  /// The cell beyond a side.
  constexpr Place beyond(Side side) const {
    return {column + (side == Side::right) - (side == Side::left),
            row + (side == Side::up) - (side == Side::down)};
  }
};

/// The places of the balls are kept by the caller, beside what else it needs with them.
template <class Real>
class Cells {
 public:
  using Vec = BasicVec2<Real>;

  Cells(std::size_t balls, Real diameter) : diameter_(diameter), next_(balls, none) {}

  /// Cells that hold a ball or none, most of them, and are no smaller than `least_side`, with all
  /// balls where `position(ball)` is, which sets `place(ball)`; those for which `present(ball)` is
  /// false are in none.
  template <class Present, class Position, class PlaceOf>
  void build(Real least_side, const Present& present, const Position& position,
             const PlaceOf& place) {
    std::size_t count = 0;
    Vec low{never<Real>, never<Real>};
    Vec high{-never<Real>, -never<Real>};
    for (std::uint32_t ball = 0; ball < next_.size(); ++ball) {
      if (!present(ball)) continue;
      const Vec p = position(ball);
      low = {smaller(low.x, p.x), smaller(low.y, p.y)};
      high = {larger(high.x, p.x), larger(high.y, p.y)};
      ++count;
    }
    if (count == 0) low = high = {};
    using std::sqrt;
    const Real coordinate = larger(largest_coordinate(low), largest_coordinate(high));
    const Real least = larger(larger(least_side, diameter_ * Real(least_diameters)),
                              coordinate / Real(reliable_sides));
    origin_ = low;
    const Vec extent{larger(high.x - low.x, least), larger(high.y - low.y, least)};
    const Real even = sqrt(extent.x) * sqrt(extent.y) *
                      sqrt(Real(balls_a_cell) / Real(std::max<std::size_t>(count, 1)));
    for (side_ = larger(least, even);; side_ = larger(least, side_ / 2)) {
      slack_ = side_ / 16;
      lay_out(extent, count);
      for (std::uint32_t ball = 0; ball < next_.size(); ++ball) {
        if (!present(ball)) continue;
        place(ball) = place_at(position(ball));
        link(ball, place(ball));
      }
      if (side_ == least || crowd() <= Real(most_crowded) * Real(count)) return;
    }
  }

  Real side() const { return side_; }
  /// Balls nearer to one another than this are in the same cell or in neighbouring ones.
  Real reach() const { return side_ - 2 * slack_; }

  /// Lists of balls in memory.
  std::size_t lists() const { return cells_.size(); }

  void remove(std::uint32_t ball, const Place& at) {
    Cell& cell = cells_[slot_of(at.column, at.row)];
    const std::uint32_t count = cell.count--;
    if (cell.balls[0] != ball && cell.balls[1] != ball) {
      std::uint32_t* link = &cell.balls[2];
      while (*link != ball) link = &next_[*link];
      *link = next_[ball];
      return;
    }
    std::uint32_t& gap = cell.balls[0] == ball ? cell.balls[0] : cell.balls[1];
    gap = count > 2 ? cell.balls[2] : cell.balls[1];
    if (count > 3) cell.balls[2] = next_[cell.balls[2]];
  }

  /// Sets `found` to all balls in a cell and in those round it, and some that are elsewhere.
  void find_beside(const Place& at, Gathered& found) const {
    std::array<const Cell*, 9> block;
    for (std::int64_t k = 0; k < 9; ++k) {
      block[static_cast<std::size_t>(k)] =
          &cells_[slot_of(at.column - 1 + k % 3, at.row - 1 + k / 3)];
    }
    gather(block, found);
  }

  /// The same for the three cells beyond one side of those.
  void find_ahead(const Place& at, Side side, Gathered& found) const {
    gather(cells_ahead(at, side), found);
  }

  /// Have memory fetched that find_beside(), or cross() and find_ahead(), read.
  void fetch_beside(const Place& at) const {
    for (std::int64_t row = at.row - 1; row <= at.row + 1; ++row) {
      fetch_memory(&cells_[slot_of(at.column - 1, row)]);
      fetch_memory(&cells_[slot_of(at.column + 1, row)]);
    }
  }
  void fetch_ahead(const Place& at, Side side) const {
    const Place next = at.beyond(side);
    fetch_memory(&cells_[slot_of(at.column, at.row)]);
    fetch_memory(&cells_[slot_of(next.column, next.row)]);
    for (const Cell* const cell : cells_ahead(at, side)) fetch_memory(cell);
  }

  /// Moves a ball to the next cell.
  void cross(std::uint32_t ball, Place& at, Side side) {
    remove(ball, at);
    at = at.beyond(side);
    link(ball, at);
  }

  /// When a ball leaves its cell, which is `at`; it is at `p` now, moves at `v` and accelerates by
  /// `a`. Cells overlap a little: a ball that has just crossed is well inside the next one, so that
  /// rounding cannot send it to and fro.
  Crossing<Real> crossing(const Place& at, Vec p, Vec v, Vec a) const {
    const Real x = p.x - (origin_.x + Real(at.column) * side_);
    const Real y = p.y - (origin_.y + Real(at.row) * side_);
    if (a == Vec{}) {
      // Where a ball goes cannot be guessed: no branches.
      const Real in_x = leaves(x, v.x);
      const Real in_y = leaves(y, v.y);
      const int over_y = !(in_x < in_y);
      const int left = v.x < 0;
      const int down = v.y < 0;
      const int back = (left & (1 - over_y)) | (down & over_y);
      return {smaller(in_x, in_y), static_cast<Side>(2 * over_y + back)};
    }
    Crossing<Real> first;
    leave(first, side_ + slack_ - x, v.x, a.x, Side::right);
    leave(first, slack_ + x, -v.x, -a.x, Side::left);
    leave(first, side_ + slack_ - y, v.y, a.y, Side::up);
    leave(first, slack_ + y, -v.y, -a.y, Side::down);
    return first;
  }

  /// Whether positions of this size, with a doubt of `doubt` on each, are known well enough for
  /// these cells.
  bool resolves(Vec position, Real doubt) const {
    return largest_coordinate(position) <= side_ * Real(reliable_sides) && doubt <= slack_ / 8;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  /// A side of 5/4 diameters, less what cells overlap, is more than a diameter.
  static constexpr double least_diameters = 1.25;
  static constexpr double balls_a_cell = 0.5;
  /// Balls that share a cell with a ball, itself among them: evenly spread ones would be 1.5.
  static constexpr double most_crowded = 6;
  /// Coordinates up to so many sides are known to a small part of a side.
  static constexpr std::uint64_t reliable_sides =
      std::uint64_t{1} << std::min(std::numeric_limits<Real>::digits - 13, 48);

  /// The balls of a cell: two, and the first of a chain of the others. Hardly any cell has more
  /// than three, so that they can be gathered without a branch; `count` comes last.
  struct Cell {
    std::array<std::uint32_t, 3> balls{none, none, none};
    std::uint32_t count = 0;
  };

  static constexpr std::size_t inlined = 3;

  /// Sets `found` to the balls of some cells. Of each a whole cell is copied, and what is too much
  /// written over by the next.
  template <std::size_t count>
  void gather(const std::array<const Cell*, count>& cells, Gathered& found) const {
    std::uint32_t* end = found.begin_anew(count * inlined + 1);
    std::size_t most = 0;
    for (const Cell* const cell : cells) {
      std::memcpy(end, cell, sizeof(Cell));
      end += std::min<std::size_t>(cell->count, inlined);
      most = std::max<std::size_t>(most, cell->count);
    }
    found.end_at(end);
    if (most > inlined) gather_chains(cells, found);
  }

  /// The same where a cell holds more balls than can be gathered so.
  template <std::size_t count>
  void gather_chains(const std::array<const Cell*, count>& cells, Gathered& found) const {
    std::size_t all = 0;
    for (const Cell* const cell : cells) all += cell->count;
    std::uint32_t* end = found.begin_anew(all);
    for (const Cell* const cell : cells) {
      std::uint32_t next = none;
      for (std::size_t i = 0; i < cell->count; ++i) {
        next = i < inlined ? cell->balls[i] : next_[next];
        *end++ = next;
      }
    }
    found.end_at(end);
  }

  /// As many lists as cover the extent, in powers of two, but no more than eight a ball. Fewer than
  /// four a side would let a ball see itself twice.
  void lay_out(Vec extent, std::size_t count) {
    std::uint64_t columns = power_above(extent.x / side_ + 1, count);
    std::uint64_t rows = power_above(extent.y / side_ + 1, count);
    while (columns * rows > std::max<std::size_t>(8 * count, 16)) {
      (columns > rows ? columns : rows) /= 2;
    }
    column_mask_ = columns - 1;
    row_mask_ = rows - 1;
    columns_ = columns;
    cells_.assign(columns * rows, Cell{});
  }

  static std::uint64_t power_above(Real least, std::size_t count) {
    std::uint64_t power = 4;
    while (Real(power) < least && power < 8 * count) power *= 2;
    return power;
  }

  std::uint32_t slot_of(std::int64_t column, std::int64_t row) const {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(row) & row_mask_) * columns_ +
                                      (static_cast<std::uint64_t>(column) & column_mask_));
  }

  /// The three cells that become neighbours when a ball crosses over `side`.
  std::array<const Cell*, 3> cells_ahead(const Place& at, Side side) const {
    const bool beside = side == Side::right || side == Side::left;
    const Place middle = at.beyond(side).beyond(side);
    std::array<const Cell*, 3> line;
    for (std::int64_t k = -1; k <= 1; ++k) {
      line[static_cast<std::size_t>(k + 1)] =
          &cells_[slot_of(middle.column + (beside ? 0 : k), middle.row + (beside ? k : 0))];
    }
    return line;
  }

  Place place_at(Vec position) const {
    using std::floor;
    return {static_cast<std::int64_t>(floor((position.x - origin_.x) / side_)),
            static_cast<std::int64_t>(floor((position.y - origin_.y) / side_))};
  }

  void link(std::uint32_t ball, const Place& at) {
    Cell& cell = cells_[slot_of(at.column, at.row)];
    if (cell.count < 2) {
      cell.balls[cell.count] = ball;
    } else {
      next_[ball] = cell.balls[2];
      cell.balls[2] = ball;
    }
    ++cell.count;
  }

  /// For every ball the number of balls in its list, added up.
  Real crowd() const {
    Real sum = 0;
    for (const Cell& cell : cells_) sum += Real(cell.count) * Real(cell.count);
    return sum;
  }

  /// In how long a ball at `x` of its cell leaves it along one axis.
  Real leaves(Real x, Real v) const {
    const Real least = slack_ * std::numeric_limits<Real>::epsilon();
    const Real ahead = larger(side_ + slack_ - x, least);
    const Real behind = smaller(-slack_ - x, -least);
    const Real pace = 1 / v;
    return larger(ahead * pace, behind * pace);
  }

  static void leave(Crossing<Real>& first, Real gap, Real towards, Real pull, Side side) {
    using std::sqrt;
    if (towards <= 0 && pull <= 0) return;
    gap = larger(gap, Real(0));
    const Real square = towards * towards + 2 * pull * gap;
    Real t = never<Real>;
    if (pull == 0) {
      t = gap / towards;
    } else if (towards <= 0) {
      t = (sqrt(square) - towards) / pull;
    } else if (square >= 0) {
      t = 2 * gap / (towards + sqrt(square));
    }
    if (t < first.after_s) first = {t, side};
  }

  Real diameter_;
  Real side_{};
  Real slack_{};  ///< by which cells overlap on every side
  Vec origin_;    ///< a corner of cell 0, 0
  std::uint64_t columns_ = 0;
  std::uint64_t column_mask_ = 0;
  std::uint64_t row_mask_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> next_;  ///< in the chain of a cell
};

}  // namespace breakshot::physics
