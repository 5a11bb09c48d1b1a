// 8-ball after the break: groups, calls and the 8, by the paragraphs 3.4 to 3.8 of the WPA's rules.
#include <gtest/gtest.h>

#include "tests/rules/eight_ball_positions.hpp"

namespace breakshot::rules {
namespace {

// ---- 3.4 Open table

TEST(Rule3_4, PocketingTheCalledBallOnAnOpenTableWinsItsGroup) {
  const auto result = after(open_table, hit_first(9).drops(1, 9, 4), call_of(9, 4));
  EXPECT_EQ(result.ruling.group_won, Group::stripes);
  EXPECT_EQ(result.game.status.groups, (std::vector{Group::stripes, Group::solids}));
  EXPECT_EQ(result.game.status.turn, shooter);
}

TEST(Rule3_4, AnUncalledBallWinsNoGroupAndTheTurnPasses) {
  const auto result =
      after(open_table, hit_first(9).drops(1, 1, 4).reaches_rail(1, 9, 0), call_of(9, 4));
  EXPECT_FALSE(result.ruling.group_won);
  EXPECT_EQ(result.game.status.groups, (std::vector{Group::none, Group::none}));
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::none);
}

TEST(Rule3_4, TheCalledBallInAnotherPocketWinsNoGroup) {
  const auto result = after(open_table, hit_first(9).drops(1, 9, 3), call_of(9, 4));
  EXPECT_FALSE(result.ruling.group_won);
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_EQ(find(result.table, BallId{9}), nullptr) << "it stays down";
}

TEST(Rule3_4, AFoulWinsNoGroup) {
  const auto result = after(open_table, hit_first(9).drops(1, 9, 4).drops(2, 0, 1), call_of(9, 4));
  EXPECT_FALSE(result.ruling.group_won);
  EXPECT_EQ(result.game.status.groups, (std::vector{Group::none, Group::none}));
  EXPECT_EQ(result.game.status.turn, opponent);
}

TEST(Rule3_4, OnAnOpenTableASolidMayBeHitFirstToPocketAStripe) {
  const auto result = after(open_table, hit_first(1).drops(1, 10, 0), call_of(10, 0));
  EXPECT_TRUE(result.ruling.fouls.empty());
  EXPECT_EQ(result.ruling.group_won, Group::stripes);
}

TEST(Rule3_4, OnAnOpenTableTheEightMayNotBeHitFirst) {
  const auto result = after(open_table, hit_first(8).drops(1, 9, 4), call_of(9, 4));
  EXPECT_EQ(result.ruling.fouls, std::vector{Foul::wrong_ball_first});
}

TEST(Rule3_4, WithNothingButTheEightLeftOnAnOpenTableItIsTheTarget) {
  const auto left = table_of({{0, {0, 0}}, {8, {0.3, 0.3}}});
  EXPECT_EQ(call_fault(open_table, left, call_of(8, 1)), std::nullopt);
  const auto result =
      after(open_table, left, ShotBuilder(left).hits(0.5, 0, 8).drops(1, 8, 1), call_of(8, 1));
  EXPECT_EQ(result.ruling.rack_winner, shooter);
}

// ---- 3.5 and 3.6 Continuing, calling

TEST(Rule3_5, TheShooterGoesOnAsLongAsHePocketsCalledBallsLegally) {
  const auto made = after(solids, hit_first(1).drops(1, 1, 4), call_of(1, 4));
  EXPECT_EQ(made.game.status.turn, shooter);
  EXPECT_FALSE(made.ruling.group_won) << "it was his already";
  const auto missed = after(solids, hit_first(1).reaches_rail(1, 1, 0), call_of(1, 4));
  EXPECT_TRUE(missed.ruling.fouls.empty());
  EXPECT_EQ(missed.game.status.turn, opponent);
  EXPECT_EQ(missed.game.status.ball_in_hand, BallInHand::none);
}

TEST(Rule1_6, HowTheCalledBallCameToItsPocketIsIrrelevant) {
  const auto result = after(
      solids,
      hit_first(1).reaches_rail(0.6, 1, 0).hits(0.7, 1, 9).drops(0.9, 9, 5).hits(0.8, 1, 2).drops(
          1, 2, 4),
      call_of(2, 4));
  EXPECT_TRUE(result.ruling.fouls.empty());
  EXPECT_EQ(result.game.status.turn, shooter);
  EXPECT_EQ(result.ruling.pocketed, (std::vector{BallId{9}, BallId{2}}));
}

TEST(Rule3_6, EveryShotAfterTheBreakIsCalledOrASafety) {
  EXPECT_TRUE(call_fault(solids, table(), {}));
  EXPECT_TRUE(call_fault(solids, table(), {BallId{1}, {}, false}));
  EXPECT_TRUE(call_fault(solids, table(), {{}, PocketId{1}, false}));
  EXPECT_TRUE(call_fault(solids, table(), {BallId{1}, PocketId{1}, true}));
  EXPECT_EQ(call_fault(solids, table(), call_of(1, 5)), std::nullopt);
  EXPECT_EQ(call_fault(solids, table(), safety), std::nullopt);
}

TEST(Rule3_6, OnlyBallsOfTheShootersGroupThatAreOnTheTableCanBeCalled) {
  EXPECT_EQ(call_fault(solids, table(), call_of(9, 0)),
            "call.ball: 9 cannot be called; one of 1 2 can");
  EXPECT_TRUE(call_fault(solids, table(), call_of(3, 0)));
  EXPECT_TRUE(call_fault(solids, table(), call_of(0, 0)));
  EXPECT_TRUE(call_fault(solids, table(), call_of(99, 0)));
  EXPECT_EQ(call_fault(open_table, table(), call_of(9, 0)), std::nullopt);
  EXPECT_EQ(call_fault(solids, table(), call_of(1, 6)), "call.pocket: is 6; pockets are 0 to 5");
}

TEST(Rule3_6, TheEightCanBeCalledOnlyOnceTheGroupIsCleared) {
  EXPECT_TRUE(call_fault(solids, table(), call_of(8, 0)));
  EXPECT_TRUE(call_fault(open_table, table(), call_of(8, 0)));
  EXPECT_EQ(call_fault(solids, at_the_eight(), call_of(8, 0)), std::nullopt);
  EXPECT_TRUE(call_fault(solids, at_the_eight(), call_of(9, 0)));
}

TEST(Rule3_6, AfterASafetyTheTurnPassesAndPocketedBallsStayDown) {
  const auto result = after(solids, hit_first(1).drops(1, 1, 4), safety);
  EXPECT_TRUE(result.ruling.fouls.empty());
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::none);
  EXPECT_EQ(find(result.table, BallId{1}), nullptr);
}

TEST(Rule3_6, ASafetyOnAnOpenTableWinsNoGroup) {
  const auto result = after(open_table, hit_first(1).drops(1, 1, 4), safety);
  EXPECT_FALSE(result.ruling.group_won);
  EXPECT_EQ(result.game.status.groups, (std::vector{Group::none, Group::none}));
}

TEST(Rule3_7, NoObjectBallButTheEightOfABreakIsEverSpotted) {
  const auto result =
      after(solids, hit_first(9).drops(1, 9, 4).drops(1, 1, 2).drops(2, 0, 1), call_of(1, 2));
  EXPECT_FALSE(result.ruling.fouls.empty());
  EXPECT_TRUE(result.ruling.spotted.empty());
  EXPECT_EQ(find(result.table, BallId{9}), nullptr);
  EXPECT_EQ(find(result.table, BallId{1}), nullptr);
}

// ---- 3.8 The 8 decides the rack

TEST(Rule3, TheEightInItsCalledPocketWinsTheRack) {
  const auto result = eight_shot(hit_eight().drops(1, 8, 2), call_of(8, 2));
  EXPECT_EQ(result.ruling.rack_end, RackEnd::eight_pocketed);
  EXPECT_EQ(result.ruling.rack_winner, shooter);
}

TEST(Rule3_8a, TheEightPocketedWithAFoulLosesTheRack) {
  const auto result = eight_shot(hit_eight().drops(1, 8, 2).drops(2, 0, 1), call_of(8, 2));
  EXPECT_EQ(result.ruling.fouls, std::vector{Foul::scratch});
  EXPECT_EQ(result.ruling.rack_end, RackEnd::foul_on_eight);
  EXPECT_EQ(result.ruling.rack_winner, opponent);
}

TEST(Rule3_8a, AFoulOnTheEightThatStaysUpLosesOnlyTheTurn) {
  const auto result = eight_shot(hit_eight().drops(2, 0, 1), call_of(8, 2));
  EXPECT_FALSE(result.ruling.rack_end);
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::anywhere);
}

TEST(Rule3_8b, TheEightBeforeTheGroupIsClearedLosesTheRack) {
  for (const EightBall& game : {solids, open_table}) {
    const auto result = after(game, hit_first(1).drops(1, 8, 2), call_of(1, 2));
    EXPECT_EQ(result.ruling.rack_end, RackEnd::eight_too_early);
    EXPECT_EQ(result.ruling.rack_winner, opponent);
  }
}

TEST(Rule3_8b, TheEightOnTheSameShotAsTheLastBallOfTheGroupLosesTheRack) {
  const auto before = table_of({{0, {0, 0}}, {1, {0.5, 0}}, {8, {0.3, 0.3}}, {9, {-0.5, 0.2}}});
  const auto result =
      after(solids, before, ShotBuilder(before).hits(0.5, 0, 1).drops(1, 1, 2).drops(1.5, 8, 3),
            call_of(1, 2));
  EXPECT_EQ(result.ruling.rack_end, RackEnd::eight_too_early);
  EXPECT_EQ(result.ruling.rack_winner, opponent);
}

TEST(Rule3_8c, TheEightInAnUncalledPocketLosesTheRack) {
  const auto result = eight_shot(hit_eight().drops(1, 8, 3), call_of(8, 2));
  EXPECT_EQ(result.ruling.rack_end, RackEnd::eight_wrong_pocket);
  EXPECT_EQ(result.ruling.rack_winner, opponent);
}

TEST(Rule3_8c, TheEightOnASafetyIsInAnUncalledPocket) {
  const auto result = eight_shot(hit_eight().drops(1, 8, 3), safety);
  EXPECT_EQ(result.ruling.rack_end, RackEnd::eight_wrong_pocket);
}

}  // namespace
}  // namespace breakshot::rules
