#include <gtest/gtest.h>

#include "common/match/match.hpp"

namespace breakshot::match {
namespace {

// The expected values were computed by Python's hashlib and hmac.

TEST(Seed, TheCommitmentIsTheHashOfTheSecret) {
  EXPECT_EQ(hash::hex_of(commitment_of(Secret{})),
            "66687aadf862bd776c8fc18b8e9f8e20089714856ee233b3902a591d0d5f2925");
}

TEST(Seed, DependsOnTheSecretAndOnEveryContributionInOrderOfSeat) {
  Secret secret{};
  for (std::size_t i = 0; i < secret.size(); ++i) secret[i] = static_cast<std::uint8_t>(i);
  Contribution a{};
  a.fill(0xaa);
  Contribution b{};
  b.fill(0xbb);
  EXPECT_EQ(hash::hex_of(seed_of(secret, {a, b})), "670b8b0c9ad82dfd3eae4cf56ccb1556");
  EXPECT_EQ(hash::hex_of(seed_of(secret, {b, a})), "9255440b0cfc7a3c4fe6cd8cae5db355");
}

}  // namespace
}  // namespace breakshot::match
