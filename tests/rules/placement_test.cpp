#include "common/rules/placement.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "common/physics/table.hpp"
#include "common/rules/groups.hpp"
#include "tests/support/shot_builder.hpp"

namespace breakshot::rules {
namespace {

using physics::BallId;
using physics::Vec2;
using support::club_scene;
using support::table_of;

constexpr double diameter = 0.05715;

Vec2 position_of(const physics::State& table, std::uint32_t ball) {
  return find(table, BallId{ball})->position;
}
Vec2 spotted(const physics::State& table) {
  return position_of(with_spotted(club_scene(), table, eight_ball_id), 8);
}
std::string fault(const physics::State& table, Vec2 position,
                  BallInHand hand = BallInHand::anywhere) {
  return placement_fault(club_scene(), table, cue_ball, position, hand).value_or("");
}

TEST(Rule1_4, ASpottedBallGoesToTheFootSpot) {
  EXPECT_EQ(spotted(table_of({{0, {0, 0}}, {3, {0.2, 0.3}}})), (Vec2{0.5842, 0}));
}

TEST(Rule1_4, ASpottedBallTouchesTheBallInItsWayOnTheFootSide) {
  EXPECT_NEAR(spotted(table_of({{3, {0.5842, 0}}})).x, 0.5842 + diameter, 1e-15);
  // A ball 30 mm off the long string leaves sqrt(57.15^2 - 30^2) mm along it.
  const Vec2 beside = spotted(table_of({{3, {0.57, 0.03}}}));
  EXPECT_NEAR(beside.x, 0.57 + 0.0486428, 1e-7);
  EXPECT_EQ(beside.y, 0);
}

TEST(Rule1_4, ASpottedBallPassesEveryBallInItsWay) {
  const auto table = table_of({{1, {0.6, 0}}, {2, {0.66, 0.01}}, {3, {0.75, 0}}});
  EXPECT_NEAR(spotted(table).x, 0.75 + diameter, 1e-15);
}

TEST(Rule1_4, ASpottedBallKeepsASmallDistanceFromTheCueBall) {
  const Vec2 place = spotted(table_of({{0, {0.5842, 0}}}));
  EXPECT_GT(place.x, 0.5842 + diameter + 1e-4);
  EXPECT_LT(place.x, 0.5842 + diameter + 1e-3);
}

TEST(Rule1_4, ASpottedBallComesBeforeTheFootSpotIfAllBehindItIsBlocked) {
  physics::State table = table_of({{0, {-0.5842, 0}}});
  for (std::uint32_t i = 0; i < 6; ++i) {
    table = with_ball(table, BallId{i + 1}, {0.5842 + i * 0.1, 0});
  }
  EXPECT_NEAR(spotted(table).x, 0.5842 - diameter, 1e-15);
}

TEST(Rule1_4, ASpottedBallNeverOverlapsAndNeverMovesAnother) {
  std::mt19937 random(20160315);
  for (int round = 0; round < 2'000; ++round) {
    physics::State table;
    for (std::uint32_t ball = 0; ball < 16; ++ball) {
      if (ball == 8) continue;
      const Vec2 place{static_cast<double>(random() % 10'000) * 2e-4 - 1,
                       static_cast<double>(random() % 1'000) * 1e-4 - 0.05};
      if (!placement_fault(club_scene(), table, BallId{ball}, place, BallInHand::anywhere)) {
        table = with_ball(table, BallId{ball}, place);
      }
    }
    const physics::State after = with_spotted(club_scene(), table, eight_ball_id);
    ASSERT_TRUE(physics::faults_of(club_scene(), after).empty()) << "round " << round;
    for (const physics::Ball& ball : table.balls) ASSERT_EQ(*find(after, ball.id), ball);
    for (const physics::Ball& ball : table.balls) {
      ASSERT_GE(length(ball.position - position_of(after, 8)), 2 * club_scene().ball.radius_m);
    }
  }
}

TEST(HeadSpot, TheCueBallIsPutBackThereOrAsNearBehindItAsThereIsRoom) {
  const auto back = [](const physics::State& table) {
    return position_of(with_cue_ball_at_head_spot(club_scene(), table), 0);
  };
  EXPECT_EQ(back(table_of({{1, {0.3, 0}}})), (Vec2{-0.5842, 0}));
  EXPECT_EQ(back(table_of({{0, {0.3, 0}}})), (Vec2{-0.5842, 0})) << "moved, not doubled";
  const Vec2 beside = back(table_of({{1, {-0.5842, 0}}}));
  EXPECT_LT(beside.x, -0.5842 - diameter) << "touches no ball";
  EXPECT_GT(beside.x, -0.5842 - diameter - 1e-3);
}

TEST(Rule1_5, TheCueBallGoesAnywhereOnTheBedThatIsFree) {
  const auto table = table_of({{7, {0.1, 0.1}}});
  EXPECT_EQ(fault(table, {0.5, -0.3}), "");
  EXPECT_EQ(fault(table, {1.139825, 0.555625}), "") << "frozen to two cushions";
  EXPECT_EQ(fault(table, {0.1 + diameter, 0.1}), "") << "touching a ball";
  EXPECT_EQ(fault(table, {0.1 + diameter - 1e-13, 0.1}), "") << "but for what decimals lose";
}

TEST(Rule1_5, APlaceOnAnotherBallIsRefusedWithWhatWouldBeRight) {
  const auto table = table_of({{7, {0.1, 0.1}}});
  EXPECT_EQ(fault(table, {0.1 + diameter - 1e-9, 0.1}),
            "position: overlaps ball 7; place it at least 57.15 mm from every ball's centre");
  EXPECT_EQ(placement_fault(club_scene(), table, BallId{7}, {0.11, 0.1}, BallInHand::anywhere),
            std::nullopt)
      << "a ball is not in its own way";
}

TEST(Rule1_5, APlaceOffTheBedIsRefusedWithTheFieldAndItsRange) {
  const auto table = table_of({{7, {0.1, 0.1}}});
  EXPECT_EQ(fault(table, {1.14, 0}),
            "position.x: is 1.14 m; on the bed a ball's centre is from -1.139825 to 1.139825 m");
  EXPECT_EQ(fault(table, {0, -0.56}),
            "position.y: is -0.56 m; on the bed a ball's centre is from -0.555625 to 0.555625 m");
  EXPECT_NE(fault(table, {std::numeric_limits<double>::quiet_NaN(), 0}), "");
  EXPECT_NE(fault(table, {0, std::numeric_limits<double>::infinity()}), "");
}

TEST(Rule6_10, BehindTheHeadStringExcludesTheStringButForTheHeadSpot) {
  const auto table = table_of({{7, {0.1, 0.1}}});
  const BallInHand behind = BallInHand::behind_head_string;
  EXPECT_EQ(fault(table, {-0.5843, 0.3}, behind), "");
  EXPECT_EQ(fault(table, {-0.5842, 0.3}, behind),
            "position.x: is -0.5842 m; behind the head string it is less than -0.5842 m, or "
            "exactly the head spot");
  EXPECT_NE(fault(table, {0, 0}, behind), "");
  EXPECT_EQ(fault(table, {-0.5842, 0}, behind), "");
}

}  // namespace
}  // namespace breakshot::rules
