// Balls by the time of their next appointment, one a ball: a heap in which a ball's place is its
// number, so that it is found without being looked for. A node has eight times that lie side by
// side in one cache line, and knows whose the least of them is; a change goes up only as far as it
// makes a difference.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/detect.hpp"
#include "common/physics/pack.hpp"

namespace breakshot::physics {

template <class Real>
class EventHeap {
 public:
  /// Of a node.
  static constexpr std::size_t branches = 8;

  /// All balls at never.
  explicit EventHeap(std::size_t balls) {
    std::size_t balls_below = 1;
    for (std::size_t nodes = balls; levels_.empty() || nodes > 1;) {
      nodes = (nodes + branches - 1) / branches;
      balls_below *= branches;
      Level& level = levels_.emplace_back();
      level.times.resize(nodes);
      for (std::size_t k = 0; k < nodes; ++k) {
        level.first.push_back(static_cast<std::uint32_t>(k * balls_below));
      }
    }
  }

  /// The time of the earliest appointment, or never.
  Real earliest() const { return earliest_s_; }

  /// The lowest ball whose appointment is at earliest().
  std::uint32_t first() const { return levels_.back().first.front(); }

  Real time_of(std::uint32_t ball) const {
    return levels_.front().times[ball / branches].at(ball % branches);
  }

  /// Gives a ball another time. Calls `rises(others, next)` for every ball that becomes the first
  /// of a node: it is one of `others` at that height, and its turn comes after no more than about
  /// so many.
  template <class Rises>
  void set(std::uint32_t ball, Real time_s, const Rises& rises) {
    std::size_t place = ball;
    const std::uint32_t* first_below = nullptr;
    for (Level& level : levels_) {
      const std::size_t node = place / branches;
      Times& times = level.times[node];
      times.set(place % branches, time_s);
      time_s = times.least();
      const std::size_t least = node * branches + times.first_at(time_s);
      const std::uint32_t first =
          first_below == nullptr ? static_cast<std::uint32_t>(least) : first_below[least];
      const std::uint32_t before = level.first[node];
      if (first != before) {
        level.first[node] = first;
        rises(level.first.size(), first);
      }
      if (first != ball && before != ball) return;
      first_below = level.first.data();
      place = node;
    }
    earliest_s_ = time_s;
  }

  /// Has memory fetched that set() reads first.
  void fetch(std::uint32_t ball) const {
    __builtin_prefetch(&levels_.front().times[ball / branches]);
  }

  /// Calls `found(ball)` for every ball whose appointment is at earliest(), ascending.
  template <class Found>
  void each_earliest(const Found& found) const {
    descend(levels_.size() - 1, 0, found);
  }

 private:
  /// Those of eight neighbours.
  class alignas(branches * sizeof(Real)) Times {
   public:
    Times() {
      for (Many& pack : packs_) pack = Many(never<Real>);
    }

    Real at(std::size_t i) const { return packs_[i / Many::size][i % Many::size]; }
    void set(std::size_t i, Real time_s) { packs_[i / Many::size].replace(i % Many::size, time_s); }

    Real least() const {
      Many least = packs_[0];
      for (std::size_t k = 1; k < packs; ++k) least = smaller(least, packs_[k]);
      Real time_s = least[0];
      for (std::size_t k = 1; k < Many::size; ++k) time_s = smaller(time_s, least[k]);
      return time_s;
    }

    /// A bit for each that is at `time_s`, the least or before it.
    std::uint64_t places_at(Real time_s) const {
      const Many now(time_s);
      std::uint64_t places = 0;
      for (std::size_t k = 0; k < packs; ++k) {
        places |= not_above(packs_[k], now) << k * Many::size;
      }
      return places;
    }

    std::size_t first_at(Real time_s) const {
      return static_cast<std::size_t>(std::countr_zero(places_at(time_s)));
    }

   private:
    using Many = Pack<Real>;
    static constexpr std::size_t packs = branches / Many::size;
    Many packs_[packs];
  };

  struct Level {
    std::vector<Times> times;          ///< of a node's places
    std::vector<std::uint32_t> first;  ///< the ball below a node that comes first
  };

  template <class Found>
  void descend(std::size_t level, std::size_t node, const Found& found) const {
    for (std::uint64_t rest = levels_[level].times[node].places_at(earliest_s_); rest != 0;
         rest &= rest - 1) {
      const std::size_t place = node * branches + static_cast<std::size_t>(std::countr_zero(rest));
      if (level == 0) {
        found(static_cast<std::uint32_t>(place));
      } else {
        descend(level - 1, place, found);
      }
    }
  }

  std::vector<Level> levels_;  ///< from the balls up to a single node
  Real earliest_s_ = never<Real>;
};

}  // namespace breakshot::physics
