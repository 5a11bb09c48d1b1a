// The standard fouls of 8-ball (3.9) that a planar table can show, by the paragraphs of the WPA's
// section 6.
#include <gtest/gtest.h>

#include "tests/rules/eight_ball_positions.hpp"

namespace breakshot::rules {
namespace {

// ---- 3.9 Standard fouls

TEST(Rule3_9, AfterAFoulTheOpponentHasTheCueBallInHandAnywhere) {
  const auto result = after(solids, hit_first(9).reaches_rail(1, 9, 1), call_of(1, 4));
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::anywhere);
  EXPECT_TRUE(result.game.status.options.empty());
  EXPECT_EQ(find(result.table, cue_ball)->position, Vec2{}) << "where it lay, until it is placed";
}

TEST(Rule6_1, PocketingTheCueBallIsAFoulAndPutsItBackInHand) {
  const auto result = after(solids, hit_first(1).drops(1, 1, 4).drops(2, 0, 5), call_of(1, 4));
  EXPECT_EQ(result.ruling.fouls, std::vector{Foul::scratch});
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::anywhere);
  ASSERT_NE(find(result.table, cue_ball), nullptr);
}

TEST(Rule6_2, HittingTheOtherGroupFirstIsAFoul) {
  const auto result = after(solids, hit_first(9).hits(0.6, 0, 1).drops(1, 1, 4), call_of(1, 4));
  EXPECT_EQ(result.ruling.fouls, std::vector{Foul::wrong_ball_first});
  EXPECT_EQ(result.game.status.turn, opponent);
}

TEST(Rule6_2, HittingTheEightFirstIsAFoulUntilTheGroupIsCleared) {
  EXPECT_EQ(after(solids, hit_first(8).reaches_rail(1, 8, 0), call_of(1, 4)).ruling.fouls,
            std::vector{Foul::wrong_ball_first});
  EXPECT_TRUE(eight_shot(hit_eight().reaches_rail(1, 8, 0), call_of(8, 4)).ruling.fouls.empty());
}

TEST(Rule6_2, WithTheGroupClearedHittingTheOtherGroupFirstIsAFoul) {
  const ShotBuilder shot = ShotBuilder(at_the_eight()).hits(0.5, 0, 9).reaches_rail(1, 9, 0);
  EXPECT_EQ(eight_shot(shot, call_of(8, 4)).ruling.fouls, std::vector{Foul::wrong_ball_first});
}

TEST(Rule6_2, ASplitHitIsDecidedForTheShooter) {
  const auto result =
      after(solids, hit_first(1).hits(0.5, 0, 9).reaches_rail(1, 9, 0), call_of(1, 4));
  EXPECT_TRUE(result.ruling.fouls.empty());
}

TEST(Rule6_3, HittingNothingIsAFoul) {
  const auto result = after(solids, ShotBuilder(table()).reaches_rail(1, 0, 1), call_of(1, 4));
  EXPECT_EQ(result.ruling.fouls, std::vector{Foul::no_contact});
}

TEST(Rule6_3, NoRailAfterTheContactIsAFoul) {
  const auto result =
      after(solids, ShotBuilder(table()).reaches_rail(0.3, 0, 1).hits(0.5, 0, 1), call_of(1, 4));
  EXPECT_EQ(result.ruling.fouls, std::vector{Foul::no_rail});
}

TEST(Rule6_3, AnyBallAtARailOrInAPocketAfterTheContactWillDo) {
  EXPECT_TRUE(
      after(solids, hit_first(1).reaches_rail(1, 0, 1), call_of(1, 4)).ruling.fouls.empty());
  EXPECT_TRUE(
      after(solids, hit_first(1).reaches_rail(1, 10, 1), call_of(1, 4)).ruling.fouls.empty());
  EXPECT_TRUE(after(solids, hit_first(1).drops(1, 10, 1), call_of(1, 4)).ruling.fouls.empty());
}

TEST(Rule6_3, ABallFrozenToARailThatIsPushedAgainstItDoesNotSave) {
  const auto before = table_of({{0, {0.9, 0}}, {1, {1.139825, 0}}, {9, {-0.5, 0}}});
  const auto result =
      after(solids, before, ShotBuilder(before).hits(0.5, 0, 1).reaches_rail(0.5, 1, 0, 1),
            call_of(1, 4));
  EXPECT_EQ(result.ruling.fouls, std::vector{Foul::no_rail});
}

TEST(Rule6_7, PlayingAwayFromABallFrozenToTheCueBallIsNoHit) {
  // The balls touch, but no collision happens: the first hit is the one farther away.
  const auto before = table_of({{0, {0, 0}}, {9, {-0.05715, 0}}, {1, {0.5, 0}}});
  const auto result = after(
      solids, before, ShotBuilder(before).hits(0.5, 0, 1).reaches_rail(1, 1, 0), call_of(1, 4));
  EXPECT_TRUE(result.ruling.fouls.empty());
}

TEST(Rule6_7, PlayingIntoABallFrozenToTheCueBallIsAHitAtOnce) {
  const auto before = table_of({{0, {0, 0}}, {1, {0.05715, 0}}, {9, {0.5, 0}}});
  const auto legal =
      after(solids, before, ShotBuilder(before).hits(0, 0, 1).reaches_rail(1, 1, 0), call_of(1, 4));
  EXPECT_TRUE(legal.ruling.fouls.empty());
}

/// In hand behind the head string, as after a scratch on the break.
EightBall in_hand_behind_string() {
  EightBall game = open_table;
  game.status.ball_in_hand = BallInHand::behind_head_string;
  return game;
}

TEST(Rule6_11, HittingABallBehindTheHeadStringFirstIsAFoulUnlessTheCueBallCrossedIt) {
  const auto before = table_of({{0, {-0.9, 0}}, {1, {-0.7, 0}}, {9, {0.5, 0}}});
  const ShotBuilder direct =
      ShotBuilder(before).moves(0, 0, {-0.9, 0}, {1, 0}).hits(0.14, 0, 1).reaches_rail(1, 1, 0);
  EXPECT_EQ(after(in_hand_behind_string(), before, direct, call_of(1, 4)).ruling.fouls,
            std::vector{Foul::behind_head_string});
  const ShotBuilder round = ShotBuilder(before)
                                .moves(0, 0, {-0.9, 0}, {1, 0.5})
                                .moves(1, 0, {0.1, 0.5}, {-1, -0.5})
                                .hits(1.8, 0, 1)
                                .reaches_rail(2, 1, 0);
  EXPECT_TRUE(after(in_hand_behind_string(), before, round, call_of(1, 4)).ruling.fouls.empty());
}

TEST(Rule6_11, ABallOnTheHeadStringMayBeHitDirectly) {
  const double string_x = physics::head_string_x(club_scene().bed);
  const auto before = table_of({{0, {-0.9, 0}}, {1, {string_x, 0}}});
  const ShotBuilder shot = ShotBuilder(before)
                               .moves(0, 0, {-0.9, 0}, {1, 0})
                               .hits(0.25, 0, 1)
                               .stops(0.25, 0, {string_x - 0.05715, 0})
                               .reaches_rail(1, 1, 0);
  EXPECT_TRUE(after(in_hand_behind_string(), before, shot, call_of(1, 4)).ruling.fouls.empty());
}

TEST(Rule6_11, OnceInPlayTheCueBallIsFreeOfTheHeadString) {
  const auto before = table_of({{0, {-0.9, 0}}, {1, {-0.7, 0}}});
  const ShotBuilder shot =
      ShotBuilder(before).moves(0, 0, {-0.9, 0}, {1, 0}).hits(0.14, 0, 1).reaches_rail(1, 1, 0);
  EXPECT_TRUE(after(open_table, before, shot, call_of(1, 4)).ruling.fouls.empty());
}

TEST(Rule3_9, EveryFoulOfAShotIsNamed) {
  const auto result = after(solids, hit_first(9).drops(1, 0, 3), call_of(1, 4));
  EXPECT_EQ(result.ruling.fouls, (std::vector{Foul::scratch, Foul::wrong_ball_first}));
}

TEST(Rule3_9, BallInHandLastsForOneShot) {
  EightBall game = solids;
  game.status.ball_in_hand = BallInHand::anywhere;
  const auto result = after(game, hit_first(1).drops(1, 1, 4), call_of(1, 4));
  EXPECT_EQ(result.game.status.turn, shooter);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::none);
}

}  // namespace
}  // namespace breakshot::rules
