// Balls by the time of their next appointment, one a ball: a heap in which a ball's place is its
// number, so that it is found without being looked for. A node has eight times that lie side by
// side in one cache line, and knows whose the least of them is; a change goes up only as far as it
// makes a difference.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/physics/detect.hpp"
#include "common/physics/fetch_memory.hpp"
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
      // Some more than there are: a node without a ball is never the first.
      for (std::size_t k = 0; k < nodes + branches; ++k) {
        level.first.push_back(static_cast<std::uint32_t>(k * balls_below));
      }
    }
  }

  /// The time of the earliest appointment, or never.
  Real earliest() const { return earliest_s_; }

  /// The lowest ball whose appointment is at earliest().
  std::uint32_t first() const { return levels_.back().first.front(); }

  /// Whether no other ball's appointment is at earliest().
  bool first_is_alone() const {
    std::size_t place = first();
    std::uint64_t others = 0;
    for (const Level& level : levels_) {
      const std::uint64_t places = level.times[place / branches].places_at(earliest_s_);
      others |= places & (places - 1);
      place /= branches;
    }
    return others == 0;
  }

  Real time_of(std::uint32_t ball) const { return levels_.front().at(ball); }

  /// Gives a ball another time. Calls `rises(others, next)` for every ball that becomes the first
  /// of a node: it is one of `others` at that height, and its turn comes after no more than about
  /// so many. Who comes first among the others of a node is known before the new time is, so that
  /// of all that is done from the ball to the top little has to wait.
  template <class Rises>
  void set(std::uint32_t ball, Real time_s, Rises&& rises) {
    std::size_t place = ball;
    std::uint32_t first = ball;
    const std::uint32_t* first_below = nullptr;
    for (std::size_t height = 0; height < levels_.size(); ++height) {
      Level& level = levels_[height];
      const std::size_t node = place / branches;
      Times& times = level.times[node];
      const auto [other_s, other] = times.least_but(place % branches);
      times.set(place % branches, time_s);
      const std::size_t other_place = node * branches + other;
      const std::uint32_t other_first = first_below == nullptr
                                            ? static_cast<std::uint32_t>(other_place)
                                            : first_below[other_place];
      const int sooner = time_s < other_s;
      const int at_once = time_s == other_s;
      const int lower = place < other_place;
      const bool stays = (sooner | (at_once & lower)) != 0;
      first = stays ? first : other_first;
      time_s = smaller(time_s, other_s);
      if (std::exchange(level.first[node], first) != first) {
        rises(level.times.size(), first);
      } else if (height + 1 < levels_.size() && levels_[height + 1].at(node) == time_s) {
        return;  // nothing above changes
      }
      first_below = level.first.data();
      place = node;
    }
    earliest_s_ = time_s;
  }

  /// Has memory fetched that set() reads first.
  void fetch(std::uint32_t ball) const { fetch_memory(&levels_.front().times[ball / branches]); }

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

    struct Least {
      Real time_s;
      std::size_t place;
    };
    /// The least of all but that at `i`, and the lowest place that has it.
    Least least_but(std::size_t i) const {
      Many rest[packs];
      Many least(never<Real>);
      for (std::size_t k = 0; k < packs; ++k) {
        rest[k] = packs_[k].but(i - k * Many::size);
        least = smaller(least, rest[k]);
      }
      Real time_s = least[0];
      for (std::size_t k = 1; k < Many::size; ++k) time_s = smaller(time_s, least[k]);
      const Many now(time_s);
      std::uint64_t places = 0;
      for (std::size_t k = 0; k < packs; ++k) {
        places |= not_above(rest[k], now) << k * Many::size;
      }
      return {time_s,
              static_cast<std::size_t>(std::countr_zero(places & ~(std::uint64_t{1} << i)))};
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

   private:
    using Many = Pack<Real>;
    static constexpr std::size_t packs = branches / Many::size;
    Many packs_[packs];
  };

  struct Level {
    Real at(std::size_t place) const { return times[place / branches].at(place % branches); }

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
