#include "common/physics/exact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/physics/angle.hpp"
#include "tests/support/chance.hpp"

namespace breakshot::physics {
namespace {

TEST(Ulp, IsTheDistanceToTheNextNumber) {
  support::Chance chance(1);
  for (int i = 0; i < 100'000; ++i) {
    const double x =
        chance.between(0, 1) * std::ldexp(1.0, static_cast<int>(chance.below(80)) - 40);
    if (x == 0) continue;
    ASSERT_EQ(ulp(x), std::nextafter(x, INFINITY) - x) << x;
    ASSERT_EQ(ulp(-x), ulp(x));
  }
  EXPECT_EQ(ulp(0.0), 0.0);
  EXPECT_EQ(ulp(1.0), 0x1p-52);
}

TEST(TwoProduct, KeepsTheRoundingError) {
  const double two_52 = 0x1p52;
  const Twofold<double> product = two_product(two_52 + 1, two_52 + 3);
  EXPECT_EQ(product.high, 0x1p104 + 0x1p54);
  EXPECT_EQ(product.low, 3.0);
}

TEST(TwoSum, KeepsTheRoundingError) {
  const Twofold<double> sum = two_sum(1.0, 0x1p-80);
  EXPECT_EQ(sum.high, 1.0);
  EXPECT_EQ(sum.low, 0x1p-80);
}

TEST(Twofold, ProductsCancelWhereOneNumberCannot) {
  // (1 + e)^2 - (1 + 2 e) = e^2, far below one ulp of 1.
  const Twofold<double> x{1.0, 0x1p-60};
  const Twofold<double> square = x * x - Twofold<double>{1.0, 0x1p-59};
  EXPECT_NEAR(square.high + square.low, 0.0, 0x1p-100);
}

TEST(Angle, AgreesWithTheLibraryWithinTwoUlp) {
  support::Chance chance(7);
  for (int i = 0; i < 200'000; ++i) {
    const double scale = i % 2 == 0 ? 10 : max_angle_rad;
    const double angle = chance.between(-scale, scale);
    const Vec2 direction = direction_of(angle);
    const auto exact = static_cast<long double>(angle);
    ASSERT_NEAR(direction.x, static_cast<double>(std::cos(exact)), 2 * ulp(1.0) / 2) << angle;
    ASSERT_NEAR(direction.y, static_cast<double>(std::sin(exact)), 2 * ulp(1.0) / 2) << angle;
  }
}

TEST(Angle, HasExactAxes) {
  EXPECT_EQ(direction_of(0), (Vec2{1, 0}));
  EXPECT_NEAR(direction_of(pi / 2).y, 1, 0);
  EXPECT_NEAR(direction_of(pi).x, -1, 0);
}

}  // namespace
}  // namespace breakshot::physics
