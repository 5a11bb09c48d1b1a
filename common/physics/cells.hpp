// The plane in square cells, and the balls that are in each. The plane has no border: cells far
// apart share one list, as if it were wound round a torus, so that memory goes with the number of
// balls, not with the area that they fly over.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "common/physics/detect.hpp"

namespace breakshot::physics {

/// Where a ball leaves its cell, and in how long.
enum class Side : std::uint8_t { right, left, up, down };

template <class Real>
struct Crossing {
  Real after_s = never<Real>;
  Side side = Side::right;
};

template <class Real>
class Cells {
 public:
  using Vec = BasicVec2<Real>;

  Cells(std::size_t balls, Real diameter) : diameter_(diameter), at_(balls) {}

  /// Cells that hold one or two balls each and are no smaller than `least_side`, with all balls
  /// where `position(ball)` is; those for which `present(ball)` is false are in none.
  template <class Present, class Position>
  void build(Real least_side, const Present& present, const Position& position) {
    std::size_t count = 0;
    Vec low{never<Real>, never<Real>};
    Vec high{-never<Real>, -never<Real>};
    for (std::uint32_t ball = 0; ball < at_.size(); ++ball) {
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
                              coordinate / reliable_sides<Real>);
    origin_ = low;
    const Vec extent{larger(high.x - low.x, least), larger(high.y - low.y, least)};
    const Real even = sqrt(extent.x) * sqrt(extent.y) *
                      sqrt(Real(balls_a_cell) / Real(std::max<std::size_t>(count, 1)));
    for (side_ = larger(least, even);; side_ = larger(least, side_ / 2)) {
      slack_ = side_ / 16;
      lay_out(extent, count);
      for (std::uint32_t ball = 0; ball < at_.size(); ++ball) {
        if (present(ball)) put(ball, position(ball));
      }
      if (side_ == least || crowd() <= Real(most_crowded) * Real(count)) return;
    }
  }

  Real side() const { return side_; }
  /// Balls nearer to one another than this are in the same cell or in neighbouring ones.
  Real reach() const { return side_ - 2 * slack_; }

  void remove(std::uint32_t ball) {
    std::uint32_t* link = &heads_[at_[ball].slot];
    while (*link != ball) link = &at_[*link].next;
    *link = at_[ball].next;
  }

  /// Calls `found(other)` for every ball in the cell of `ball` and those round it, itself among
  /// them, and for some that are elsewhere.
  template <class Found>
  void each_beside(std::uint32_t ball, const Found& found) const {
    const Place& at = at_[ball];
    for (std::int64_t row = at.row - 1; row <= at.row + 1; ++row) {
      for (std::int64_t column = at.column - 1; column <= at.column + 1; ++column) {
        each_in(slot_of(column, row), found);
      }
    }
  }

  /// The same for the three cells that became neighbours when `ball` crossed over `side`.
  template <class Found>
  void each_ahead(std::uint32_t ball, Side side, const Found& found) const {
    const Place& at = at_[ball];
    for (std::int64_t k = -1; k <= 1; ++k) {
      switch (side) {
        case Side::right:
          each_in(slot_of(at.column + 1, at.row + k), found);
          break;
        case Side::left:
          each_in(slot_of(at.column - 1, at.row + k), found);
          break;
        case Side::up:
          each_in(slot_of(at.column + k, at.row + 1), found);
          break;
        case Side::down:
          each_in(slot_of(at.column + k, at.row - 1), found);
          break;
      }
    }
  }

  /// Moves a ball to the next cell.
  void cross(std::uint32_t ball, Side side) {
    remove(ball);
    Place& at = at_[ball];
    at.column += (side == Side::right) - (side == Side::left);
    at.row += (side == Side::up) - (side == Side::down);
    link(ball);
  }

  /// When a ball that is at `p` now, moves at `v` and accelerates by `a` leaves its cell. Cells
  /// overlap a little: a ball that has just crossed is well inside the next one, so that rounding
  /// cannot send it to and fro.
  Crossing<Real> crossing(std::uint32_t ball, Vec p, Vec v, Vec a) const {
    const Place& at = at_[ball];
    const Real x = p.x - (origin_.x + Real(at.column) * side_);
    const Real y = p.y - (origin_.y + Real(at.row) * side_);
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
    return largest_coordinate(position) <= side_ * reliable_sides<Real> && doubt <= slack_ / 8;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  /// A side of 5/4 diameters, less what cells overlap, is more than a diameter.
  static constexpr double least_diameters = 1.25;
  static constexpr double balls_a_cell = 1.5;
  /// Balls that share a cell with a ball, itself among them: evenly spread ones would be 2.5.
  static constexpr double most_crowded = 6;
  /// Coordinates up to so many sides are known to a small part of a side.
  template <class Number>
  static constexpr Number reliable_sides =
      Number(std::uint64_t{1} << std::min(std::numeric_limits<Number>::digits - 13, 48));

  struct Place {
    std::int64_t column = 0;
    std::int64_t row = 0;
    std::uint32_t slot = 0;
    std::uint32_t next = none;  ///< in the list of the slot
  };

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
    heads_.assign(columns * rows, none);
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

  void put(std::uint32_t ball, Vec position) {
    using std::floor;
    at_[ball].column = static_cast<std::int64_t>(floor((position.x - origin_.x) / side_));
    at_[ball].row = static_cast<std::int64_t>(floor((position.y - origin_.y) / side_));
    link(ball);
  }

  void link(std::uint32_t ball) {
    Place& at = at_[ball];
    at.slot = slot_of(at.column, at.row);
    at.next = heads_[at.slot];
    heads_[at.slot] = ball;
  }

  template <class Found>
  void each_in(std::uint32_t slot, const Found& found) const {
    for (std::uint32_t ball = heads_[slot]; ball != none; ball = at_[ball].next) found(ball);
  }

  /// For every ball the number of balls in its list, added up.
  Real crowd() const {
    Real sum = 0;
    for (std::uint32_t slot = 0; slot < heads_.size(); ++slot) {
      Real balls = 0;
      each_in(slot, [&balls](std::uint32_t) { balls += 1; });
      sum += balls * balls;
    }
    return sum;
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
  std::vector<std::uint32_t> heads_;  ///< the first ball of each list
  std::vector<Place> at_;
};

}  // namespace breakshot::physics
