// Which balls may be near one another: their extents along x, kept in order from step to step
// (Baraff 1992, "Dynamic Simulation of Non-Penetrating Rigid Bodies", sweep and prune). Balls move
// little in a step, so that the order is nearly right before it is made right.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "common/physics/cloth.hpp"

namespace breakshot::study {

template <class Real>
class Sweep {
 public:
  explicit Sweep(std::size_t balls) : spans_(balls), order_(balls) {
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
  }

  /// sort() must follow before anything is asked.
  void set(std::uint32_t ball, Real low, Real high) { spans_[ball] = {low, high}; }
  /// Takes a ball out for good.
  void remove(std::uint32_t ball) { spans_[ball] = {physics::never<Real>, physics::never<Real>}; }

  void sort() {
    for (std::size_t i = 1; i < order_.size(); ++i) {
      const std::uint32_t ball = order_[i];
      std::size_t k = i;
      for (; k > 0 && spans_[order_[k - 1]].low > spans_[ball].low; --k) order_[k] = order_[k - 1];
      order_[k] = ball;
    }
  }

  /// Calls `found(a, b)`, a < b, once for every two whose extents overlap.
  template <class Found>
  void each_pair(const Found& found) const {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const Real high = spans_[order_[i]].high;
      if (high == physics::never<Real>) return;
      for (std::size_t k = i + 1; k < order_.size() && spans_[order_[k]].low <= high; ++k) {
        found(std::min(order_[i], order_[k]), std::max(order_[i], order_[k]));
      }
    }
  }

  /// Calls `found(ball)` for every ball whose extent begins between the two.
  template <class Found>
  void each_between(Real low, Real high, const Found& found) const {
    auto at = std::lower_bound(
        order_.begin(), order_.end(), low,
        [this](std::uint32_t ball, Real least) { return spans_[ball].low < least; });
    for (; at != order_.end() && spans_[*at].low <= high; ++at) found(*at);
  }

 private:
  struct Span {
    Real low{};
    Real high{};
  };

  std::vector<Span> spans_;
  std::vector<std::uint32_t> order_;
};

}  // namespace breakshot::study
