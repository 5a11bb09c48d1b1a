// A few numbers that are worked on at once, where the processor can: one instruction then serves
// several balls. Every number is rounded as it would be alone. Other scalars than float and double
// go one by one.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "common/physics/vec.hpp"

namespace breakshot::physics {

/// The vectors that every x86-64 and most other processors have: 16 bytes.
template <class Real>
struct NativePack {
  using Type = Real;
  static constexpr std::size_t size = 1;
};
template <>
struct NativePack<double> {
  using Type [[gnu::vector_size(16)]] = double;
  static constexpr std::size_t size = 2;
};
template <>
struct NativePack<float> {
  using Type [[gnu::vector_size(16)]] = float;
  static constexpr std::size_t size = 4;
};

template <class Real>
class Pack {
  using Native = typename NativePack<Real>::Type;
  using Integers [[gnu::vector_size(16)]] = std::uint64_t;
  using Lanes [[gnu::vector_size(16)]] = std::int32_t;

 public:
  static constexpr std::size_t size = NativePack<Real>::size;

  Pack() = default;
  /// All numbers the same.
  explicit Pack(Real number) : numbers_(number - Native{}) {}

  Real operator[](std::size_t i) const {
    if constexpr (size == 1)
      return numbers_;
    else
      return numbers_[i];
  }
  void set(std::size_t i, Real number) {
    if constexpr (size == 1)
      numbers_ = number;
    else
      numbers_[i] = number;
  }
  /// The same by one write of the whole, which can be read again at once: a processor waits before
  /// it reads together what was written in parts.
  void replace(std::size_t i, Real number) {
    if constexpr (size == 1) {
      numbers_ = number;
    } else {
      const auto place = std::bit_cast<Integers>(lanes == static_cast<std::int32_t>(i));
      numbers_ = std::bit_cast<Native>((std::bit_cast<Integers>(Pack(number).numbers_) & place) |
                                       (std::bit_cast<Integers>(numbers_) & ~place));
    }
  }

  /// The same but for that at `i`, if there is one, which is not a number.
  Pack but(std::size_t i) const {
    if constexpr (size == 1) {
      return i == 0 ? of(not_a_number) : *this;
    } else {
      const auto place = std::bit_cast<Integers>(lanes == static_cast<std::int32_t>(i));
      return of(std::bit_cast<Native>(std::bit_cast<Integers>(numbers_) | place));
    }
  }

  friend Pack operator+(Pack a, Pack b) { return of(a.numbers_ + b.numbers_); }
  friend Pack operator-(Pack a, Pack b) { return of(a.numbers_ - b.numbers_); }
  friend Pack operator*(Pack a, Pack b) { return of(a.numbers_ * b.numbers_); }
  friend Pack operator/(Pack a, Pack b) { return of(a.numbers_ / b.numbers_); }

  friend Pack root(Pack a) {
    using std::sqrt;
    if constexpr (size == 1) {
      return of(sqrt(a.numbers_));
#ifdef __SSE2__
    } else if constexpr (std::is_same_v<Real, double>) {
      return of(__builtin_ia32_sqrtpd(a.numbers_));
#endif
    } else {
      for (std::size_t i = 0; i < size; ++i) a.numbers_[i] = sqrt(a.numbers_[i]);
      return a;
    }
  }

  friend Pack smaller(Pack a, Pack b) {
    return of(b.numbers_ < a.numbers_ ? b.numbers_ : a.numbers_);
  }
  friend Pack larger(Pack a, Pack b) {
    return of(a.numbers_ < b.numbers_ ? b.numbers_ : a.numbers_);
  }

  /// `a` where `b` is above `c`; elsewhere not a number.
  friend Pack where_above(Pack a, Pack b, Pack c) {
    if constexpr (size == 1) {
      return b.numbers_ > c.numbers_ ? a : of(not_a_number);
    } else {
      return of(std::bit_cast<Native>(std::bit_cast<Integers>(a.numbers_) |
                                      ~std::bit_cast<Integers>(b.numbers_ > c.numbers_)));
    }
  }
  /// `a` where `b` is not above `c`; elsewhere not a number.
  friend Pack where_not_above(Pack a, Pack b, Pack c) {
    if constexpr (size == 1) {
      return b.numbers_ > c.numbers_ ? of(not_a_number) : a;
    } else {
      return of(std::bit_cast<Native>(std::bit_cast<Integers>(a.numbers_) |
                                      std::bit_cast<Integers>(b.numbers_ > c.numbers_)));
    }
  }
  /// `c` where `a` is below `b`, else `d`.
  friend Pack chosen(Pack a, Pack b, Pack c, Pack d) {
    return of(a.numbers_ < b.numbers_ ? c.numbers_ : d.numbers_);
  }

  friend Pack magnitude(Pack a) {
    if constexpr (size == 1) {
      return of(a.numbers_ < 0 ? -a.numbers_ : a.numbers_);
    } else {
      const Native sign = -Native{};
      return of(std::bit_cast<Native>(std::bit_cast<Integers>(a.numbers_) &
                                      ~std::bit_cast<Integers>(sign)));
    }
  }

  /// One bit for every number that is not above that of `b`.
  friend std::uint64_t not_above(Pack a, Pack b) {
    if constexpr (size == 1) {
      return !(a.numbers_ > b.numbers_);
#ifdef __SSE2__
    } else if constexpr (std::is_same_v<Real, double>) {
      const Native places = __builtin_ia32_cmpnltpd(b.numbers_, a.numbers_);
      return static_cast<std::uint64_t>(__builtin_ia32_movmskpd(places));
#endif
    } else {
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < size; ++i) bits |= std::uint64_t{!(a[i] > b[i])} << i;
      return bits;
    }
  }

 private:
  /// The number that each quarter of a pack belongs to.
  static constexpr Lanes lanes = {0, size / 4, size / 2, size / 2 + size / 4};

  static inline const Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

  static Pack of(Native numbers) {
    Pack pack;
    pack.numbers_ = numbers;
    return pack;
  }

  Native numbers_{};
};

/// Sets one of several vectors.
template <class Real>
void set(BasicVec2<Pack<Real>>& packs, std::size_t i, BasicVec2<Real> vector) {
  packs.x.set(i, vector.x);
  packs.y.set(i, vector.y);
}

/// The same vector everywhere.
template <class Real>
BasicVec2<Pack<Real>> pack_of(BasicVec2<Real> vector) {
  return {Pack<Real>(vector.x), Pack<Real>(vector.y)};
}
/// One of several vectors everywhere.
template <class Real>
BasicVec2<Pack<Real>> pack_of(const BasicVec2<Pack<Real>>& packs, std::size_t i) {
  return {Pack<Real>(packs.x[i]), Pack<Real>(packs.y[i])};
}

}  // namespace breakshot::physics
