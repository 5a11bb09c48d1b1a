#include "common/physics/portable.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/chance.hpp"

namespace breakshot::physics {
namespace {

TEST(PortableExp, AgreesWithTheLibraryWithinTwoUlp) {
  constexpr std::uint64_t seed = 11;
  SCOPED_TRACE(seed);
  support::Chance chance(seed);
  double worst = 0;
  for (int i = 0; i < 300'000; ++i) {
    const double scales[] = {1e-3, 1.0, 20.0, 700.0};
    const double scale = scales[i % 4];
    const double x = chance.between(-scale, scale);
    const auto exact = std::exp(static_cast<long double>(x));
    const auto off = static_cast<long double>(portable_exp(x)) - exact;
    const auto rounded = static_cast<double>(exact);
    const double ulps =
        static_cast<double>(std::fabs(off)) / (std::nextafter(rounded, INFINITY) - rounded);
    worst = ulps > worst ? ulps : worst;
    ASSERT_LE(ulps, 2) << x;
  }
  EXPECT_GT(worst, 0.4);
}

TEST(PortableExp, HoldsForEveryScalar) {
  for (float x = -80; x < 80; x += 0.37F) {
    const double exact = std::exp(static_cast<double>(x));
    ASSERT_NEAR(static_cast<double>(portable_exp(x)), exact, 2 * 0x1p-24 * exact) << x;
  }
  for (long double x = -700; x < 700; x += 1.37L) {
    const long double epsilon = std::numeric_limits<long double>::epsilon();
    ASSERT_LE(std::fabs(portable_exp(x) - std::exp(x)), 3 * epsilon * std::exp(x)) << x;
  }
}

TEST(PortableExp, KnowsTheEndsOfItsRange) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(portable_exp(0.0), 1.0);
  EXPECT_EQ(portable_exp(-0.0), 1.0);
  EXPECT_EQ(portable_exp(-infinity), 0.0);
  EXPECT_EQ(portable_exp(infinity), infinity);
  EXPECT_EQ(portable_exp(-1e7), 0.0);
  EXPECT_EQ(portable_exp(710.0), infinity);
  EXPECT_NEAR(portable_exp(709.5) / std::exp(709.5), 1, 1e-15);
  EXPECT_EQ(portable_exp(-750.0), 0.0);
  EXPECT_NEAR(portable_exp(-740.0), std::exp(-740.0), 0x1p-1074);
  EXPECT_TRUE(std::isnan(portable_exp(std::nan(""))));
}

TEST(PortableExp, HasTheseBitsOnEveryMachine) {
  EXPECT_EQ(portable_exp(1.0), 0x1.5bf0a8b14576ap+1);
  EXPECT_EQ(portable_exp(-0.5), 0x1.368b2fc6f960ap-1);
  EXPECT_EQ(portable_exp(-1.088), 0x1.58f9965228e6p-2);
}

TEST(PortableSineCosine, AgreesWithTheLibraryWithinTwoUlpOfOne) {
  constexpr std::uint64_t seed = 12;
  SCOPED_TRACE(seed);
  support::Chance chance(seed);
  for (int i = 0; i < 300'000; ++i) {
    const double scale = i % 2 == 0 ? 2 : max_portable_angle_rad;
    const double angle = chance.between(-scale, scale);
    const auto [sine, cosine] = portable_sine_cosine(angle);
    const auto exact = static_cast<long double>(angle);
    ASSERT_NEAR(sine, static_cast<double>(std::sin(exact)), 2 * 0x1p-53) << angle;
    ASSERT_NEAR(cosine, static_cast<double>(std::cos(exact)), 2 * 0x1p-53) << angle;
  }
}

TEST(PortableSineCosine, HoldsForEveryScalar) {
  for (int i = -1000; i <= 1000; ++i) {
    const float narrow = static_cast<float>(i) / 10;
    ASSERT_NEAR(portable_sine_cosine(narrow).sine, std::sin(static_cast<double>(narrow)), 0x1p-22);
    const long double wide = static_cast<long double>(i) / 10;
    ASSERT_LE(std::fabs(portable_sine_cosine(wide).cosine - std::cos(wide)), 0x1p-62L) << i;
  }
  EXPECT_EQ(portable_sine_cosine(0.0).sine, 0.0);
  EXPECT_EQ(portable_sine_cosine(0.0).cosine, 1.0);
}

}  // namespace
}  // namespace breakshot::physics
