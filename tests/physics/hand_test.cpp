// The balls of one instant, one beside the other.
#include "common/physics/hand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace breakshot::physics {
namespace {

TEST(Hand, HasWhatWasTakenUntilItIsCleared) {
  Hand<double> hand(5);
  for (int instant = 0; instant < 3; ++instant) {
    EXPECT_EQ(hand.find(4), hand.nowhere);
    hand.take(4);
    hand.take(1);
    EXPECT_EQ(hand.find(4), 0u);
    EXPECT_EQ(hand.find(1), 1u);
    EXPECT_EQ(hand.find(0), hand.nowhere);
    EXPECT_EQ(hand.of(1).ball, 1u);
    EXPECT_EQ(hand[0].ball, 4u);
    hand.clear();
    EXPECT_EQ(hand.find(4), hand.nowhere);
    EXPECT_EQ(hand.find(1), hand.nowhere);
  }
}

TEST(Hand, CountsAnewBeforeTheCountOverflows) {
  Hand<double> hand(3, 5);
  for (int instant = 0; instant < 20; ++instant) {
    for (const std::uint32_t ball : {2u, 0u}) {
      EXPECT_EQ(hand.find(ball), hand.nowhere) << instant;
      hand.take(ball);
    }
    EXPECT_EQ(hand.find(2), 0u) << instant;
    EXPECT_EQ(hand.of(0).ball, 0u) << instant;
    EXPECT_EQ(hand.find(1), hand.nowhere) << instant;
    hand.clear();
  }
}

TEST(Hand, TellsBallsApartThatShareASlot) {
  // However many slots there are, some of these distances put all balls in one. They become more
  // while balls are at hand.
  constexpr std::uint32_t balls = 4'096;
  Hand<double> hand(balls);
  for (const std::uint32_t apart : {64u, 128u, 256u, 512u, 1u}) {
    for (std::uint32_t count : {1u, 3u, 40u, 70u, 300u}) {
      count = std::min(count, balls / apart);
      for (std::uint32_t k = 0; k < count; ++k) {
        EXPECT_EQ(hand.find(k * apart), hand.nowhere);
        hand.take(k * apart);
        for (std::uint32_t known = 0; known <= k; ++known) {
          ASSERT_EQ(hand.find(known * apart), known) << apart << ' ' << k;
        }
        ASSERT_EQ(hand.find(k * apart + 1), hand.nowhere) << apart << ' ' << k;
      }
      hand.clear();
    }
  }
}

TEST(Hand, KeepsBodiesWhereTheyAre) {
  constexpr std::uint32_t balls = 1'000;
  Hand<double> hand(balls);
  std::vector<const Body<double>*> bodies;
  for (std::uint32_t ball = balls; ball-- > 0;) bodies.push_back(&hand[hand.take(ball)]);
  for (std::uint32_t ball = 0; ball < balls; ++ball) {
    EXPECT_EQ(&hand.of(ball), bodies[balls - 1 - ball]);
  }
}

}  // namespace
}  // namespace breakshot::physics
