#include <gtest/gtest.h>

#include <map>

#include "common/physics/table.hpp"
#include "common/rules/eight_ball.hpp"
#include "common/rules/groups.hpp"
#include "tests/support/shot_builder.hpp"

namespace breakshot::rules {
namespace {

using physics::BallId;
using support::club_scene;

physics::Seed seed_number(std::uint8_t n) {
  physics::Seed seed{};
  seed[0] = n;
  return seed;
}

/// The ball at each place of the triangle, row by row from the apex.
std::vector<std::uint32_t> arrangement(const physics::Seed& seed, std::uint32_t rack) {
  const auto& scene = club_scene();
  const physics::State table = rack_eight_ball(scene, seed, rack);
  std::vector<std::uint32_t> balls;
  for (const physics::Vec2 place : triangle_rack(scene.bed, scene.ball, physics::rack_gap_m)) {
    for (const physics::Ball& ball : table.balls) {
      if (ball.position == place) balls.push_back(number(ball.id));
    }
  }
  return balls;
}

TEST(Rule3_2, TheEightIsInTheMiddleAndEachGroupHasOneBackCorner) {
  for (std::uint32_t rack = 0; rack < 500; ++rack) {
    const auto balls = arrangement(seed_number(3), rack);
    ASSERT_EQ(balls.size(), 15u);
    EXPECT_EQ(balls[4], 8u);
    EXPECT_EQ(opposite(group_of(BallId{balls[10]})), group_of(BallId{balls[14]}));
  }
}

TEST(Rule3_2, ARackHasAllSixteenBallsInOrderAndNoFault) {
  const physics::State table = rack_eight_ball(club_scene(), seed_number(9), 4);
  ASSERT_EQ(table.balls.size(), 16u);
  for (std::uint32_t i = 0; i < 16; ++i) EXPECT_EQ(number(table.balls[i].id), i);
  EXPECT_TRUE(physics::faults_of(club_scene(), table).empty());
  EXPECT_EQ(table.balls[0].position, physics::head_spot(club_scene().bed));
}

TEST(Rule3_2, TheOtherBallsStandAnywhereEquallyOften) {
  constexpr int racks = 12'000;
  std::map<std::pair<std::size_t, std::uint32_t>, int> counts;
  for (std::uint32_t rack = 0; rack < racks; ++rack) {
    const auto balls = arrangement(seed_number(7), rack);
    for (std::size_t place = 0; place < balls.size(); ++place) ++counts[{place, balls[place]}];
  }
  // A corner holds each of 14 balls in 1 of 14 racks; elsewhere 12 places share the other 6/7 of a
  // ball's racks, which is 1 in 14 again. 5 standard deviations of that are 141.
  for (std::size_t place = 0; place < 15; ++place) {
    if (place == 4) continue;
    for (std::uint32_t ball = 1; ball <= 15; ++ball) {
      if (ball == 8) continue;
      const int count = counts[{place, ball}];
      EXPECT_NEAR(count, racks / 14.0, 141) << "ball " << ball << " at place " << place;
    }
  }
}

TEST(Rack, DependsOnSeedAndRackNumberAlone) {
  EXPECT_EQ(arrangement(seed_number(1), 5), arrangement(seed_number(1), 5));
  EXPECT_NE(arrangement(seed_number(1), 5), arrangement(seed_number(1), 6));
  EXPECT_NE(arrangement(seed_number(1), 5), arrangement(seed_number(2), 5));
}

TEST(Rack, IsTheSameOnEveryMachine) {
  // Computed by a second implementation of Philox and of the draw, in Python.
  EXPECT_EQ(arrangement(seed_number(0), 0),
            (std::vector<std::uint32_t>{3, 12, 10, 9, 8, 7, 11, 2, 14, 5, 1, 4, 6, 15, 13}));
}

}  // namespace
}  // namespace breakshot::rules
