#include "common/physics/angle.hpp"

#include <cstdint>

namespace breakshot::physics {
namespace {

// pi / 2 in three parts; products of the first two with a quadrant count below 2^20 are exact
// (Cody and Waite, "Software Manual for the Elementary Functions", 1980).
constexpr double half_pi_high = 0x1.921fb54400000p+0;
constexpr double half_pi_middle = 0x1.0b4611a600000p-34;
constexpr double half_pi_low = 0x1.3198a2e037073p-69;
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;

/// Taylor's series on [-pi/4, pi/4]; the first term left out is below 2^-60.
double sine(double r) {
  const double z = r * r;
  double tail = 0x1.952c77030ad4ap-49;
  tail = tail * z - 0x1.ae7f3e733b81fp-41;
  tail = tail * z + 0x1.6124613a86d09p-33;
  tail = tail * z - 0x1.ae64567f544e4p-26;
  tail = tail * z + 0x1.71de3a556c734p-19;
  tail = tail * z - 0x1.a01a01a01a01ap-13;
  tail = tail * z + 0x1.1111111111111p-7;
  tail = tail * z - 0x1.5555555555555p-3;
  return r + r * z * tail;
}

double cosine(double r) {
  const double z = r * r;
  double tail = 0x1.ae7f3e733b81fp-45;
  tail = tail * z - 0x1.93974a8c07c9dp-37;
  tail = tail * z + 0x1.1eed8eff8d898p-29;
  tail = tail * z - 0x1.27e4fb7789f5cp-22;
  tail = tail * z + 0x1.a01a01a01a01ap-16;
  tail = tail * z - 0x1.6c16c16c16c17p-10;
  tail = tail * z + 0x1.5555555555555p-5;
  return 1 - (z / 2 - z * z * tail);
}

}  // namespace

Vec2 direction_of(double angle_rad) {
  const double turns = angle_rad * two_over_pi;
  const auto quadrant = static_cast<std::int64_t>(turns < 0 ? turns - 0.5 : turns + 0.5);
  const auto n = static_cast<double>(quadrant);
  const double r = ((angle_rad - n * half_pi_high) - n * half_pi_middle) - n * half_pi_low;
  const double s = sine(r);
  const double c = cosine(r);
  switch (quadrant & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

}  // namespace breakshot::physics
