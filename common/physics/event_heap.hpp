// Balls by the time of their next appointment, one a ball: a heap with four children a node, in
// which every ball knows its place. Four children lie side by side in memory, and half as many
// levels as with two are gone through.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/cloth.hpp"

namespace breakshot::physics {

template <class Real>
class EventHeap {
 public:
  /// All balls at never.
  explicit EventHeap(std::size_t balls) : entries_(balls), places_(balls) {
    for (std::uint32_t ball = 0; ball < balls; ++ball) {
      entries_[ball].ball = ball;
      places_[ball] = ball;
    }
  }

  /// The time of the earliest appointment, and whose it is; there must be a ball.
  Real earliest() const { return entries_.front().time_s; }
  std::uint32_t first() const { return entries_.front().ball; }

  Real time_of(std::uint32_t ball) const { return entries_[places_[ball]].time_s; }

  void set(std::uint32_t ball, Real time_s) {
    const std::size_t place = places_[ball];
    const Real before = entries_[place].time_s;
    if (time_s < before) {
      rise(place, {time_s, ball});
    } else if (before < time_s) {
      sink(place, {time_s, ball});
    }
  }

  /// Calls `found(ball)` for every ball whose appointment is at earliest(), in no special order.
  template <class Found>
  void each_earliest(const Found& found) const {
    const Real time_s = earliest();
    found(entries_.front().ball);
    each_below(0, time_s, found);
  }

 private:
  static constexpr std::size_t children = 4;
  struct Entry {
    Real time_s = never<Real>;
    std::uint32_t ball = 0;
  };

  void put(std::size_t place, const Entry& entry) {
    entries_[place] = entry;
    places_[entry.ball] = static_cast<std::uint32_t>(place);
  }

  void rise(std::size_t place, const Entry& entry) {
    while (place > 0) {
      const std::size_t parent = (place - 1) / children;
      if (!(entry.time_s < entries_[parent].time_s)) break;
      put(place, entries_[parent]);
      place = parent;
    }
    put(place, entry);
  }

  void sink(std::size_t place, const Entry& entry) {
    for (;;) {
      const std::size_t first = children * place + 1;
      if (first >= entries_.size()) break;
      const std::size_t end = std::min(first + children, entries_.size());
      std::size_t least = first;
      for (std::size_t child = first + 1; child < end; ++child) {
        if (entries_[child].time_s < entries_[least].time_s) least = child;
      }
      if (!(entries_[least].time_s < entry.time_s)) break;
      put(place, entries_[least]);
      place = least;
    }
    put(place, entry);
  }

  template <class Found>
  void each_below(std::size_t place, Real time_s, const Found& found) const {
    const std::size_t first = children * place + 1;
    const std::size_t end = std::min(first + children, entries_.size());
    for (std::size_t child = first; child < end; ++child) {
      if (entries_[child].time_s != time_s) continue;
      found(entries_[child].ball);
      each_below(child, time_s, found);
    }
  }

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> places_;  ///< in entries_, by ball
};

}  // namespace breakshot::physics
