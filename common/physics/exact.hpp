// Arithmetic with the rounding error kept: what decides where one unit in the last place decides.
// Sums after Knuth, products after Dekker 1971, "A floating-point technique for extending the
// available precision"; no fused operations, so that the bits are the same everywhere.
#pragma once

#include <cfloat>
#include <limits>

#include "common/physics/vec.hpp"

namespace breakshot::physics {

// What the bits rest on, refused by the compiler where it is not so: doubles of IEEE 754, each
// operation rounded to double at once (the x87 keeps more digits for a while), and no algebra that
// holds for real numbers alone. Contraction cannot be seen from here: docs/determinism.md.
static_assert(std::numeric_limits<double>::is_iec559, "double must be that of IEEE 754");
static_assert(FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1,
              "doubles must be computed as doubles: by SSE2 (-mfpmath=sse), not by the x87");
#ifdef __FAST_MATH__
#error "-ffast-math gives other bits: leave it out"
#endif

/// 2^exponent, exact.
template <class Real>
constexpr Real power_of_two(int exponent) {
  Real power = 1;
  for (int i = 0; i < exponent; ++i) power *= 2;
  for (int i = 0; i > exponent; --i) power /= 2;
  return power;
}

/// The distance from |x| to the next larger number (Rump 2009, "Ultimately fast accurate
/// summation", algorithm 3.5). Zero for zero.
template <class Real>
constexpr Real ulp(Real x) {
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  const Real q = (1 / epsilon + 1) * x;
  const Real leading = q - (1 - epsilon / 2) * q;
  return epsilon * (leading < 0 ? -leading : leading);
}

/// The unevaluated sum of two numbers, the second at most half an ulp of the first.
template <class Real>
struct Twofold {
  Real high{};
  Real low{};
};

template <class Real>
constexpr Twofold<Real> two_sum(Real a, Real b) {
  const Real sum = a + b;
  const Real part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// Splits a number into two halves of its digits.
template <class Real>
inline const Real dekker_splitter = power_of_two<Real>((std::numeric_limits<Real>::digits + 1) /
                                                       2) +
                                    1;

template <class Real>
Twofold<Real> two_product(Real a, Real b) {
  const Real splitter = dekker_splitter<Real>;
  const Real product = a * b;
  const Real a_scaled = splitter * a;
  const Real a_high = a_scaled - (a_scaled - a);
  const Real a_low = a - a_high;
  const Real b_scaled = splitter * b;
  const Real b_high = b_scaled - (b_scaled - b);
  const Real b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

template <class Real>
constexpr Twofold<Real> operator+(Twofold<Real> a, Twofold<Real> b) {
  const Twofold<Real> high = two_sum(a.high, b.high);
  const Twofold<Real> low = two_sum(a.low, b.low);
  const Twofold<Real> first = two_sum(high.high, high.low + low.high);
  return two_sum(first.high, first.low + low.low);
}

template <class Real>
constexpr Twofold<Real> operator-(Twofold<Real> a) {
  return {-a.high, -a.low};
}

template <class Real>
constexpr Twofold<Real> operator-(Twofold<Real> a, Twofold<Real> b) {
  return a + -b;
}

template <class Real>
Twofold<Real> operator*(Twofold<Real> a, Twofold<Real> b) {
  const Twofold<Real> product = two_product(a.high, b.high);
  return two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

}  // namespace breakshot::physics
