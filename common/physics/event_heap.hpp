// Balls by the time of their next appointment, one a ball: a heap in which a ball's place is its
// number, so that it is found without being looked for. Every node holds the least of eight times
// that lie side by side in one cache line; a change goes up only as far as it makes a difference.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/detect.hpp"

namespace breakshot::physics {

template <class Real>
class EventHeap {
 public:
  /// All balls at never.
  explicit EventHeap(std::size_t balls) {
    std::size_t groups = balls;
    do {
      groups = (groups + branches - 1) / branches;
      levels_.emplace_back(groups);
    } while (groups > 1);
  }

  /// The time of the earliest appointment, or never.
  Real earliest() const { return least(levels_.back().front()); }

  /// A ball whose appointment is at earliest().
  std::uint32_t first() const {
    const Real time_s = earliest();
    std::size_t place = 0;
    for (std::size_t level = levels_.size(); level-- > 0;) {
      const Real* t = levels_[level][place].times_s;
      std::size_t k = 4 * (smaller(smaller(t[0], t[1]), smaller(t[2], t[3])) != time_s);
      k += 2 * (smaller(t[k], t[k + 1]) != time_s);
      k += t[k] != time_s;
      place = place * branches + k;
    }
    return static_cast<std::uint32_t>(place);
  }

  Real time_of(std::uint32_t ball) const {
    return levels_.front()[ball / branches].times_s[ball % branches];
  }

  void set(std::uint32_t ball, Real time_s) {
    std::size_t place = ball;
    for (std::vector<Group>& level : levels_) {
      Group& group = level[place / branches];
      const Real before = least(group);
      group.times_s[place % branches] = time_s;
      time_s = least(group);
      if (time_s == before) return;
      place /= branches;
    }
  }

  /// Calls `found(ball)` for every ball whose appointment is at earliest(), ascending.
  template <class Found>
  void each_earliest(const Found& found) const {
    descend(levels_.size() - 1, 0, earliest(), found);
  }

 private:
  static constexpr std::size_t branches = 8;
  struct alignas(branches * sizeof(Real)) Group {
    Group() {
      for (Real& time_s : times_s) time_s = never<Real>;
    }
    Real times_s[branches];
  };

  static Real least(const Group& group) {
    const Real* t = group.times_s;
    return smaller(smaller(smaller(t[0], t[1]), smaller(t[2], t[3])),
                   smaller(smaller(t[4], t[5]), smaller(t[6], t[7])));
  }

  /// A bit for each place in a group at which something is at `time_s`.
  static unsigned places_at(const Group& group, Real time_s) {
    unsigned places = 0;
    for (unsigned k = 0; k < branches; ++k) places |= unsigned{group.times_s[k] == time_s} << k;
    return places;
  }

  template <class Found>
  void descend(std::size_t level, std::size_t group, Real time_s, const Found& found) const {
    for (unsigned rest = places_at(levels_[level][group], time_s); rest != 0; rest &= rest - 1) {
      const std::size_t place = group * branches + static_cast<std::size_t>(std::countr_zero(rest));
      if (level == 0) {
        found(static_cast<std::uint32_t>(place));
      } else {
        descend(level - 1, place, time_s, found);
      }
    }
  }

  std::vector<std::vector<Group>> levels_;  ///< from the balls up to a single group
};

}  // namespace breakshot::physics
