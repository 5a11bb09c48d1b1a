// The balls of one instant, one beside the other.
#include "common/physics/hand.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace breakshot::physics {
namespace {

TEST(Hand, HasWhatWasTakenUntilItIsCleared) {
  Hand<double> hand(5);
  for (int instant = 0; instant < 3; ++instant) {
    EXPECT_FALSE(hand.has(4));
    hand.take(4).ball = 4;
    hand.take(1).ball = 1;
    EXPECT_TRUE(hand.has(4));
    EXPECT_TRUE(hand.has(1));
    EXPECT_FALSE(hand.has(0));
    EXPECT_EQ(hand.place_of(4), 0u);
    EXPECT_EQ(hand.place_of(1), 1u);
    EXPECT_EQ(hand.of(1).ball, 1u);
    EXPECT_EQ(hand[0].ball, 4u);
    hand.clear();
    EXPECT_FALSE(hand.has(4));
    EXPECT_FALSE(hand.has(1));
  }
}

TEST(Hand, CountsAnewBeforeTheCountOverflows) {
  Hand<double> hand(3, 5);
  for (int instant = 0; instant < 20; ++instant) {
    for (const std::uint32_t ball : {2u, 0u}) {
      EXPECT_FALSE(hand.has(ball)) << instant;
      hand.take(ball).ball = ball;
    }
    EXPECT_EQ(hand.place_of(2), 0u) << instant;
    EXPECT_EQ(hand.of(0).ball, 0u) << instant;
    EXPECT_FALSE(hand.has(1)) << instant;
    hand.clear();
  }
}

TEST(Hand, KeepsBodiesWhereTheyAre) {
  constexpr std::uint32_t balls = 1'000;
  Hand<double> hand(balls);
  std::vector<const Body<double>*> bodies;
  for (std::uint32_t ball = balls; ball-- > 0;) bodies.push_back(&hand.take(ball));
  for (std::uint32_t ball = 0; ball < balls; ++ball) {
    EXPECT_EQ(&hand.of(ball), bodies[balls - 1 - ball]);
  }
}

}  // namespace
}  // namespace breakshot::physics
