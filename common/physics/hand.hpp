// The balls that one instant needs, as they are then. However many balls there are, only these are
// looked at, one beside the other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/body.hpp"

namespace breakshot::physics {

template <class Real>
class Hand {
 public:
  /// No more than `balls` will be at hand; a Body stays where it is until clear(). Balls that are
  /// taken are counted, from `last_count` on anew: in good time before the count would overflow.
  explicit Hand(std::size_t balls, std::uint32_t last_count = std::uint32_t{1} << 31)
      : last_count_(last_count), taken_(balls) {
    bodies_.reserve(balls);
  }

  void clear() {
    first_ = next_;
    if (next_ < last_count_) return;
    std::fill(taken_.begin(), taken_.end(), 0);
    first_ = next_ = 1;
  }

  bool has(std::uint32_t ball) const { return taken_[ball] >= first_; }
  /// Where among the bodies a ball is that is at hand.
  std::uint32_t place_of(std::uint32_t ball) const { return taken_[ball] - first_; }

  /// Takes one more ball to hand, whose body the caller is to fill.
  Body<Real>& take(std::uint32_t ball) {
    const std::uint32_t place = next_ - first_;
    taken_[ball] = next_++;
    if (bodies_.begin() + place == bodies_.end()) grow();
    return bodies_[place];
  }

  /// In the order in which they were taken; what comes after them is of earlier instants.
  std::vector<Body<Real>>& bodies() { return bodies_; }
  Body<Real>& operator[](std::uint32_t place) { return bodies_[place]; }
  const Body<Real>& of(std::uint32_t ball) const { return bodies_[place_of(ball)]; }

 private:
  [[gnu::noinline]] void grow() { bodies_.emplace_back(); }

  std::uint32_t last_count_;
  std::vector<Body<Real>> bodies_;
  std::vector<std::uint32_t> taken_;  ///< the count of all that were taken, when a ball last was
  std::uint32_t next_ = 1;            ///< that count
  std::uint32_t first_ = 1;           ///< that count at the last clear()
};

}  // namespace breakshot::physics
