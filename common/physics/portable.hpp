// The exponential, sine and cosine of any scalar, by + - * / and powers of two alone: those of the
// platform's library differ between machines, and know no scalar of our own.
//
// exp(x) = 2^n exp(r), x = n ln 2 + r, |r| <= ln 2 / 2; sine and cosine of x = n pi/2 + r,
// |r| <= pi/4; then Taylor's series to the digits of the scalar. ln 2 = 2 artanh(1/3) and
// pi/4 = 4 arctan(1/5) - arctan(1/239) (Machin) are summed in twofold arithmetic and kept in two
// parts, of which the first times n is exact (Cody and Waite 1980).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "common/physics/exact.hpp"

namespace breakshot::physics {

/// Beyond this the reduction to a quadrant would lose digits, rad.
inline constexpr int max_portable_angle_rad = 100;

template <class Real>
struct SineCosine {
  Real sine{};
  Real cosine{};
};

namespace portable {

/// A constant in two parts, and its reciprocal. The first part has 16 trailing zero digits.
template <class Real>
struct Period {
  Real high{};
  Real low{};
  Real inverse{};
};

template <class Real>
Twofold<Real> quotient(Twofold<Real> a, Real by) {
  const Real first = a.high / by;
  const Twofold<Real> back = two_product(first, by);
  return two_sum(first, (((a.high - back.high) - back.low) + a.low) / by);
}

/// artanh(1/q) for sign = 1, arctan(1/q) for sign = -1, to twice the digits of the scalar.
template <class Real>
Twofold<Real> inverse_series(int q, int sign) {
  const Real smallest = std::numeric_limits<Real>::epsilon() * std::numeric_limits<Real>::epsilon();
  Twofold<Real> power = quotient(Twofold<Real>{1, 0}, Real(q));
  Twofold<Real> sum = power;
  for (int k = 3; power.high > smallest || -power.high > smallest; k += 2) {
    power = quotient(power, Real(sign * q * q));
    sum = sum + quotient(power, Real(k));
  }
  return sum;
}

template <class Real>
Period<Real> period_of(Twofold<Real> constant) {
  const Real scaled = constant.high * (power_of_two<Real>(16) + 1);
  const Real high = scaled - (scaled - constant.high);
  return {high, (constant.high - high) + constant.low, 1 / constant.high};
}

template <class Real>
const Period<Real>& ln_two() {
  static const Period<Real> period = period_of(Twofold<Real>{2, 0} * inverse_series<Real>(3, 1));
  return period;
}

template <class Real>
const Period<Real>& half_pi() {
  static const Period<Real> period = period_of(Twofold<Real>{8, 0} * inverse_series<Real>(5, -1) -
                                               Twofold<Real>{2, 0} * inverse_series<Real>(239, -1));
  return period;
}

/// The first power of r <= 0.8 whose term of the exponential series no digit can show.
template <class Real>
constexpr std::size_t terms() {
  double rest = 1;
  for (int digit = 0; digit < std::numeric_limits<Real>::digits + 6; ++digit) rest /= 2;
  double term = 1;
  std::size_t k = 0;
  while (term > rest) term *= 0.8 / static_cast<double>(++k);
  return k;
}

/// 1 / k! for every term.
template <class Real>
const std::array<Real, terms<Real>()>& inverse_factorials() {
  static const std::array<Real, terms<Real>()> table = [] {
    std::array<Real, terms<Real>()> inverse{};
    Twofold<Real> last{1, 0};
    for (std::size_t k = 0; k < inverse.size(); ++k) {
      if (k > 0) last = quotient(last, Real(static_cast<int>(k)));
      inverse[k] = last.high;
    }
    return inverse;
  }();
  return table;
}

/// The sum of sign^i z^i / (first + step i)!, from the smallest term.
template <class Real>
Real tail(Real z, std::size_t first, std::size_t step) {
  const auto& inverse = inverse_factorials<Real>();
  std::size_t k = first + (inverse.size() - 1 - first) / step * step;
  Real sum = inverse[k];
  while (k > first) {
    k -= step;
    sum = sum * z + inverse[k];
  }
  return sum;
}

/// 2^n for any n, by squaring; beyond the range of the scalar infinity or zero.
template <class Real>
Real power_of_two_by_squaring(int n) {
  Real base = n < 0 ? Real(1) / 2 : Real(2);
  Real power = 1;
  for (int rest = n < 0 ? -n : n; rest > 0; rest /= 2) {
    if (rest % 2 == 1) power *= base;
    if (rest > 1) base *= base;
  }
  return power;
}

template <class Real>
int nearest(Real x) {
  return static_cast<int>(x < 0 ? x - Real(1) / 2 : x + Real(1) / 2);
}

}  // namespace portable

/// e^x to 2 ulp; infinity and zero beyond the range of the scalar, and what is below the smallest
/// normal number rounded twice.
template <class Real>
Real portable_exp(Real x) {
  using Numbers = std::numeric_limits<Real>;
  const portable::Period<Real>& ln_two = portable::ln_two<Real>();
  using std::isnan;
  if (isnan(x)) return x;
  if (x > ln_two.high * (Numbers::max_exponent + 1)) return Numbers::infinity();
  if (x < ln_two.high * (Numbers::min_exponent - Numbers::digits - 2)) return Real(0);
  const int n = portable::nearest<Real>(x * ln_two.inverse);
  const Real r = (x - Real(n) * ln_two.high) - Real(n) * ln_two.low;
  const Real value = 1 + (r + r * r * portable::tail(r, 2, 1));
  // In two halves, for 2^n alone may lie outside the range.
  const int half = n / 2;
  return value * portable::power_of_two_by_squaring<Real>(half) *
         portable::power_of_two_by_squaring<Real>(n - half);
}

/// Sine and cosine of |angle| <= max_portable_angle_rad, to 2 ulp of 1.
template <class Real>
SineCosine<Real> portable_sine_cosine(Real angle) {
  const portable::Period<Real>& half_pi = portable::half_pi<Real>();
  const int n = portable::nearest<Real>(angle * half_pi.inverse);
  const Real r = (angle - Real(n) * half_pi.high) - Real(n) * half_pi.low;
  const Real z = r * r;
  const Real s = r - r * z * portable::tail<Real>(-z, 3, 2);
  const Real c = 1 - (z / 2 - z * z * portable::tail<Real>(-z, 4, 2));
  switch (n & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace breakshot::physics
