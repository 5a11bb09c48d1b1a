// The balls that one instant needs, as they are then. However many balls there are, only these are
// looked at, one beside the other.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/physics/body.hpp"

namespace breakshot::physics {

template <class Real>
class Hand {
 public:
  static constexpr std::uint32_t nowhere = ~std::uint32_t{0};

  /// Balls are numbered below `balls`; a Body stays where it is until clear(). Balls that are taken
  /// are counted, from `last_count` on anew: in good time before the count would overflow.
  explicit Hand(std::size_t balls, std::uint32_t last_count = std::uint32_t{1} << 31)
      : last_count_(last_count),
        balls_(balls),
        slots_(std::bit_ceil(std::min(balls, few))),
        mask_(slots_.size() - 1) {
    bodies_.reserve(balls);
    slots_.reserve(std::bit_ceil(balls));
  }

  void clear() {
    first_ = next_;
    if (next_ < last_count_) return;
    std::fill(slots_.begin(), slots_.end(), Slot{});
    first_ = next_ = 1;
  }

  /// Where among the bodies a ball is, or nowhere.
  std::uint32_t find(std::uint32_t ball) const {
    const std::uint32_t count = slots_[slot_of(ball)].count;
    return count >= first_ ? count - first_ : nowhere;
  }

  /// Takes one more ball to hand. The caller is to fill its body, but for the number, at the place
  /// that is given.
  std::uint32_t take(std::uint32_t ball) {
    const std::uint32_t place = next_ - first_;
    if (bodies_.begin() + place == bodies_.end()) grow();
    slots_[slot_of(ball)] = {next_++, ball};
    bodies_[place].ball = ball;
    return place;
  }

  /// In the order in which they were taken; what comes after them is of earlier instants.
  std::vector<Body<Real>>& bodies() { return bodies_; }
  Body<Real>& operator[](std::uint32_t place) { return bodies_[place]; }
  const Body<Real>& of(std::uint32_t ball) const { return bodies_[find(ball)]; }

 private:
  /// With so many slots each ball of a table has its own; of more balls few are at hand at once.
  static constexpr std::size_t few = 64;

  struct Slot {
    std::uint32_t count = 0;  ///< of its ball among all that were taken
    std::uint32_t ball = 0;
  };

  /// The slot of a ball, or that which it would have: from its own on, the first that is free.
  std::size_t slot_of(std::uint32_t ball) const {
    std::size_t slot = ball & mask_;
    while (slots_[slot].count >= first_ && slots_[slot].ball != ball) slot = (slot + 1) & mask_;
    return slot;
  }

  /// One more body than were ever at hand at once, and, unless each ball has its own, two slots for
  /// each of them. The memory is there already.
  [[gnu::noinline]] void grow() {
    if (slots_.size() < std::min(balls_, 2 * bodies_.size() + 2)) {
      slots_.assign(2 * slots_.size(), Slot{});
      mask_ = slots_.size() - 1;
      for (std::uint32_t place = 0; place < bodies_.size(); ++place) {
        const std::uint32_t ball = bodies_[place].ball;
        slots_[slot_of(ball)] = {first_ + place, ball};
      }
    }
    bodies_.emplace_back();
  }

  std::uint32_t last_count_;
  std::size_t balls_;
  std::vector<Body<Real>> bodies_;
  std::vector<Slot> slots_;
  std::size_t mask_;
  std::uint32_t next_ = 1;   ///< the count of the ball that is taken next
  std::uint32_t first_ = 1;  ///< that of the first since the last clear()
};

}  // namespace breakshot::physics
