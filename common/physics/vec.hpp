// Vector values of the plane and of space. The unit is that of the thing a vector describes: metres
// for positions, metres a second for velocities, radians a second for spins.
#pragma once

#include <cmath>
#include <limits>

namespace breakshot::physics {

template <class Real>
struct BasicVec2 {
  Real x{};
  Real y{};

  friend constexpr BasicVec2 operator+(BasicVec2 a, BasicVec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr BasicVec2 operator-(BasicVec2 a, BasicVec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr BasicVec2 operator-(BasicVec2 a) { return {-a.x, -a.y}; }
  friend constexpr BasicVec2 operator*(BasicVec2 a, Real s) { return {a.x * s, a.y * s}; }
  friend constexpr BasicVec2 operator*(Real s, BasicVec2 a) { return {a.x * s, a.y * s}; }
  friend constexpr BasicVec2 operator/(BasicVec2 a, Real s) { return {a.x / s, a.y / s}; }
  friend constexpr bool operator==(const BasicVec2&, const BasicVec2&) = default;
};

template <class Real>
struct BasicVec3 {
  Real x{};
  Real y{};
  Real z{};

  friend constexpr BasicVec3 operator+(BasicVec3 a, BasicVec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr BasicVec3 operator-(BasicVec3 a, BasicVec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr BasicVec3 operator*(BasicVec3 a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr bool operator==(const BasicVec3&, const BasicVec3&) = default;
};

template <class Real>
constexpr Real larger(Real a, Real b) {
  return a < b ? b : a;
}

template <class Real>
constexpr Real smaller(Real a, Real b) {
  return b < a ? b : a;
}

template <class Real>
Real magnitude(Real x) {
  using std::abs;
  return abs(x);
}

using Vec2 = BasicVec2<double>;
using Vec3 = BasicVec3<double>;

template <class Real>
constexpr Real dot(BasicVec2<Real> a, BasicVec2<Real> b) {
  return a.x * b.x + a.y * b.y;
}

template <class Real>
constexpr Real dot(BasicVec3<Real> a, BasicVec3<Real> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
constexpr BasicVec3<Real> cross(BasicVec3<Real> a, BasicVec3<Real> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The z component of the cross product: positive where b lies to the left of a.
template <class Real>
constexpr Real cross(BasicVec2<Real> a, BasicVec2<Real> b) {
  return a.x * b.y - a.y * b.x;
}

/// a turned a quarter to the left.
template <class Real>
constexpr BasicVec2<Real> perp(BasicVec2<Real> a) {
  return {-a.y, a.x};
}

/// The length where squares underflow or overflow.
template <class Real>
[[gnu::cold]] Real scaled_length(BasicVec2<Real> a) {
  using std::sqrt;
  const Real ax = a.x < 0 ? -a.x : a.x;
  const Real ay = a.y < 0 ? -a.y : a.y;
  const Real largest = ax < ay ? ay : ax;
  if (!(largest > 0)) return ax + ay;  // zero, or not a number
  const BasicVec2<Real> scaled = a / largest;
  return largest * sqrt(dot(scaled, scaled));
}

/// The length; the only function used is sqrt.
template <class Real>
[[gnu::always_inline]] inline Real length(BasicVec2<Real> a) {
  using std::sqrt;
  using Limits = std::numeric_limits<Real>;
  const Real square = dot(a, a);
  if (square > Limits::min() / Limits::epsilon() && square < Limits::max()) return sqrt(square);
  return scaled_length(a);
}

}  // namespace breakshot::physics
