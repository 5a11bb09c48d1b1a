// Lists of balls that are made anew again and again, and filled without a branch for each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace breakshot::physics {

class Gathered {
 public:
  /// Empties the list and gives room for `most` balls.
  std::uint32_t* begin_anew(std::size_t most) {
    if (balls_.size() < most) balls_.resize(2 * most);
    return balls_.data();
  }
  void end_at(const std::uint32_t* end) { end_ = end; }
  /// Sets the list to all of `count` balls.
  void gather_all(std::size_t count) {
    std::uint32_t* const all = begin_anew(count);
    std::iota(all, all + count, 0u);
    end_at(all + count);
  }

  const std::uint32_t* begin() const { return balls_.data(); }
  const std::uint32_t* end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end() - begin()); }

 private:
  std::vector<std::uint32_t> balls_;
  const std::uint32_t* end_ = nullptr;
};

}  // namespace breakshot::physics
