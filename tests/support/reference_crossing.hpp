// When a polynomial of degree four or less first falls below zero, slowly and without cleverness:
// its Bernstein coefficients on an interval bound it there; the interval is halved until they show
// that there is no such place, or one sign change is left, which bisection finds. Nothing of it is
// shared with the engine, which brackets by the roots of derivatives.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace breakshot::support {

/// The scalar of the reference.
using Wide = long double;

/// c0 + c1 t + c2 t^2 + c3 t^3 + c4 t^4.
using Quartic = std::array<Wide, 5>;

class FirstBelowZero {
 public:
  /// On [0, end].
  FirstBelowZero(const Quartic& polynomial, Wide end) : end_(end) {
    // b_i = sum over k <= i of C(i, k) / C(4, k) c_k end^k.
    constexpr std::array<std::array<int, 5>, 5> binomial{
        {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}}};
    Wide power = 1;
    for (std::size_t k = 0; k < 5; ++k) {
      const Wide scaled = polynomial[k] * power / Wide(binomial[4][k]);
      for (std::size_t i = k; i < 5; ++i) whole_[i] += Wide(binomial[i][k]) * scaled;
      power *= end;
    }
  }

  /// `value(t)` is the polynomial evaluated in the best way there is: it decides the last bits.
  template <class Value>
  std::optional<Wide> find(const Value& value) const {
    return search(whole_, 0, end_, value, 0);
  }

 private:
  using Coefficients = std::array<Wide, 5>;
  static constexpr int deepest = 70;

  template <class Value>
  static std::optional<Wide> search(const Coefficients& b, Wide low, Wide high, const Value& value,
                                    int depth) {
    int changes = 0;
    bool below = false;
    for (std::size_t i = 0; i < 5; ++i) {
      below = below || b[i] < 0;
      changes += i > 0 && (b[i] < 0) != (b[i - 1] < 0);
    }
    if (!below) return std::nullopt;
    if (b[0] < 0) return low;
    if (changes == 1) return bisect(low, high, value);
    if (depth == deepest) return std::nullopt;
    // De Casteljau's halves.
    Coefficients left{};
    Coefficients right = b;
    for (std::size_t round = 0; round < 5; ++round) {
      left[round] = right[0];
      for (std::size_t i = 0; i + 1 < 5 - round; ++i) right[i] = (right[i] + right[i + 1]) / 2;
    }
    // What is left in `right` are the last entries of all rounds: those of the right half.
    const Wide middle = low + (high - low) / 2;
    if (const auto found = search(left, low, middle, value, depth + 1)) return found;
    return search(right, middle, high, value, depth + 1);
  }

  template <class Value>
  static Wide bisect(Wide low, Wide high, const Value& value) {
    for (;;) {
      const Wide middle = low + (high - low) / 2;
      if (!(middle > low && middle < high)) return high;
      (value(middle) < 0 ? high : low) = middle;
    }
  }

  Wide end_;
  Coefficients whole_{};
};

}  // namespace breakshot::support
