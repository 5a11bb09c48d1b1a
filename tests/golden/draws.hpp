// The numbers of which the golden shots are made: a stream of integers (SplitMix64; Steele, Lea and
// Flood 2014) and the four operations, nothing of the physics. What a shot starts from cannot
// change with what is tested by it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "common/physics/vec.hpp"

namespace breakshot::golden {

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::size_t below(std::size_t n) { return static_cast<std::size_t>((next() >> 32) % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }

  template <class Value, std::size_t N>
  Value one_of(const Value (&values)[N]) {
    return values[below(N)];
  }

  /// A unit vector in any direction, by the rational points of the circle.
  physics::Vec2 direction() {
    const double t = between(0, 1);
    const physics::Vec2 first{(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
    switch (below(4)) {
      case 0:
        return first;
      case 1:
        return {-first.y, first.x};
      case 2:
        return {-first.x, -first.y};
      default:
        return {first.y, -first.x};
    }
  }

  /// A vector of any direction whose length is within these bounds.
  physics::Vec2 vector(double least, double most) {
    const physics::Vec2 towards = direction();
    return towards * between(least, most);
  }

 private:
  std::uint64_t state_;
};

}  // namespace breakshot::golden
