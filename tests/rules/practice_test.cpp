#include "common/rules/practice.hpp"

#include <gtest/gtest.h>

#include "common/rules/groups.hpp"
#include "tests/support/shot_builder.hpp"

namespace breakshot::rules {
namespace {

using physics::BallId;
using support::club_scene;
using support::ShotBuilder;
using support::table_of;

const physics::State table = table_of({{0, {0, 0}}, {1, {0.5, 0}}, {8, {0.3, 0.3}}});

TEST(Practice, TheTurnGoesRoundWhateverHappened) {
  Practice game = practice_start(3);
  for (const Seat turn : {Seat{1}, Seat{2}, Seat{0}}) {
    const auto after =
        judge(game, club_scene(), ShotBuilder(table).hits(1, 0, 8).drops(2, 8, 1).shot());
    EXPECT_EQ(after.game.status.turn, turn);
    EXPECT_TRUE(after.ruling.fouls.empty());
    EXPECT_FALSE(after.ruling.rack_winner);
    EXPECT_EQ(after.ruling.pocketed, std::vector{eight_ball_id});
    game = after.game;
  }
}

TEST(Practice, TheOnlySeatShootsAgainAndAgain) {
  const auto after =
      judge(practice_start(1), club_scene(), ShotBuilder(table).hits(1, 0, 8).shot());
  EXPECT_EQ(after.game.status.turn, Seat{0});
}

TEST(Practice, BallsAreAlwaysInHand) {
  const Practice game = practice_start(1);
  EXPECT_EQ(game.status.ball_in_hand, BallInHand::anywhere);
  const auto after = judge(game, club_scene(), ShotBuilder(table).hits(1, 0, 8).shot());
  EXPECT_EQ(after.game.status.ball_in_hand, BallInHand::anywhere);
}

TEST(Practice, OnlyTheCueBallComesBackByItself) {
  const auto after = judge(practice_start(1), club_scene(),
                           ShotBuilder(table).drops(1, 1, 2).drops(2, 0, 3).shot());
  EXPECT_EQ(find(after.table, BallId{1}), nullptr);
  EXPECT_EQ(find(after.table, cue_ball)->position, physics::head_spot(club_scene().bed));
}

TEST(Practice, NothingIsCalled) {
  EXPECT_EQ(call_fault(practice_start(1), {}), std::nullopt);
  EXPECT_TRUE(call_fault(practice_start(1), {{}, {}, true}));
}

TEST(Practice, TheTurnPassesOverThoseWhoHaveLeft) {
  Practice game = without(practice_start(4), Seat{1});
  EXPECT_EQ(game.status.turn, Seat{0});
  game = judge(game, club_scene(), ShotBuilder(table).hits(1, 0, 8).shot()).game;
  EXPECT_EQ(game.status.turn, Seat{2});
  game = without(game, Seat{2});
  EXPECT_EQ(game.status.turn, Seat{3}) << "whose turn it is may leave";
  game = without(without(game, Seat{0}), Seat{3});
  EXPECT_EQ(game.left, std::vector<bool>(4, true));
}

}  // namespace
}  // namespace breakshot::rules
