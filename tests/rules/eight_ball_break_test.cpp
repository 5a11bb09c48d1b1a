// The break of 8-ball, paragraph by paragraph of WPA 3.3, and what 1.4 and 1.5 say of it.
#include <gtest/gtest.h>

#include "common/physics/table.hpp"
#include "common/rules/eight_ball.hpp"
#include "common/rules/groups.hpp"
#include "tests/support/shot_builder.hpp"

namespace breakshot::rules {
namespace {

using physics::BallId;
using physics::Vec2;
using support::club_scene;
using support::ShotBuilder;
using support::table_of;

constexpr Seat breaker{0};
constexpr Seat opponent{1};
constexpr auto behind = Option::ball_in_hand_behind_head_string;

physics::State rack() {
  return rack_eight_ball(club_scene(), {}, 0);
}

/// A break that hits the rack; what else happens is for the test to say.
ShotBuilder hit_rack() {
  ShotBuilder shot(rack());
  shot.moves(0, 0, {-0.5842, 0}, {8, 0}).hits(0.14, 0, 3).stops(5, 0, {0.2, 0.1});
  return shot;
}
ShotBuilder legal_break() {
  ShotBuilder shot = hit_rack();
  for (std::uint32_t ball : {1u, 2u, 10u, 13u}) shot.reaches_rail(0.5, ball, 0);
  return shot;
}
EightBallAfter after(const ShotBuilder& shot) {
  return judge(eight_ball_start(breaker), club_scene(), rack(), shot.shot(), {});
}
EightBallAfter chosen(const EightBallAfter& from, Option option) {
  return choose(from.game, club_scene(), from.table, option);
}
Vec2 position_of(const physics::State& table, std::uint32_t ball) {
  return find(table, BallId{ball})->position;
}

TEST(Rule3_3a, TheCueBallBeginsInHandBehindTheHeadString) {
  const EightBall game = eight_ball_start(opponent);
  EXPECT_EQ(game.breaker, opponent);
  EXPECT_EQ(game.status.turn, opponent);
  EXPECT_TRUE(game.status.breaking);
  EXPECT_EQ(game.status.ball_in_hand, BallInHand::behind_head_string);
  EXPECT_EQ(game.status.groups, (std::vector{Group::none, Group::none}));
}

TEST(Rule3_3b, NoBallIsCalledOnTheBreak) {
  const EightBall game = eight_ball_start(breaker);
  EXPECT_EQ(call_fault(game, rack(), {}), std::nullopt);
  EXPECT_TRUE(call_fault(game, rack(), {BallId{1}, physics::PocketId{0}, false}));
  EXPECT_TRUE(call_fault(game, rack(), {{}, {}, true}));
}

TEST(Rule3_3b, AnyBallEvenTheEightMayBeHitFirst) {
  ShotBuilder shot(rack());
  shot.moves(0, 0, {-0.5842, 0}, {8, 0}).hits(0.14, 0, 8).drops(1, 4, 2).stops(5, 0, {0.2, 0.1});
  EXPECT_TRUE(after(shot).ruling.fouls.empty());
}

TEST(Rule3_3c, ABallPocketedWithoutFoulKeepsTheTurnAndTheTableOpen) {
  const auto result = after(hit_rack().drops(1, 11, 2));
  EXPECT_TRUE(result.ruling.fouls.empty());
  EXPECT_FALSE(result.ruling.illegal_break);
  EXPECT_FALSE(result.ruling.group_won);
  EXPECT_EQ(result.ruling.pocketed, std::vector{BallId{11}});
  EXPECT_EQ(result.game.status.turn, breaker);
  EXPECT_FALSE(result.game.status.breaking);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::none);
  EXPECT_TRUE(result.game.status.options.empty());
  EXPECT_EQ(result.game.status.groups, (std::vector{Group::none, Group::none}));
  EXPECT_EQ(find(result.table, BallId{11}), nullptr);
}

TEST(Rule3_3d, FourBallsAtARailMakeALegalBreakAndTheTurnPasses) {
  const auto result = after(legal_break());
  EXPECT_FALSE(result.ruling.illegal_break);
  EXPECT_TRUE(result.ruling.fouls.empty());
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_TRUE(result.game.status.options.empty());
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::none);
}

TEST(Rule3_3d, ThreeBallsAtARailMakeAnIllegalBreakWithThreeOptions) {
  ShotBuilder shot = hit_rack();
  for (std::uint32_t ball : {1u, 2u, 10u}) shot.reaches_rail(0.5, ball, 0);
  shot.reaches_rail(0.6, 1, 1).reaches_rail(0.6, 0, 1);
  const auto result = after(shot);
  EXPECT_TRUE(result.ruling.illegal_break);
  EXPECT_TRUE(result.ruling.fouls.empty()) << "an illegal break is no foul";
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_EQ(result.game.status.options, (std::vector{Option::accept_table, Option::rerack_and_break,
                                                     Option::rerack_opponent_breaks}));
}

TEST(Rule3_3d, TheOpponentMayAcceptTheTableInPosition) {
  const auto illegal = after(hit_rack().reaches_rail(0.5, 1, 0));
  const auto result = chosen(illegal, Option::accept_table);
  EXPECT_FALSE(result.rerack);
  EXPECT_EQ(result.table, illegal.table);
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::none);
  EXPECT_TRUE(result.game.status.options.empty());
  EXPECT_FALSE(result.game.status.breaking);
}

TEST(Rule3_3d, TheOpponentMayRerackAndBreak) {
  const auto result = chosen(after(hit_rack().reaches_rail(0.5, 1, 0)), Option::rerack_and_break);
  EXPECT_TRUE(result.rerack);
  EXPECT_EQ(result.game, eight_ball_start(opponent));
}

TEST(Rule3_3d, TheOpponentMayHaveTheBreakerBreakAgain) {
  const auto result =
      chosen(after(hit_rack().reaches_rail(0.5, 1, 0)), Option::rerack_opponent_breaks);
  EXPECT_TRUE(result.rerack);
  EXPECT_EQ(result.game, eight_ball_start(breaker));
}

TEST(Rule3_3e, TheEightOnALegalBreakIsNoFoulAndTheBreakerChooses) {
  const auto result = after(hit_rack().drops(1, 8, 2));
  EXPECT_TRUE(result.ruling.fouls.empty());
  EXPECT_FALSE(result.ruling.rack_end);
  EXPECT_EQ(result.game.status.turn, breaker);
  EXPECT_EQ(result.game.status.options,
            (std::vector{Option::rerack_and_break, Option::spot_eight}));
}

TEST(Rule3_3e, TheBreakerMaySpotTheEightAndGoOn) {
  const auto result = chosen(
      after(hit_rack().drops(1, 8, 2).moves(1, 3, {0.5842, 0}, {1, 0}).stops(2, 3, {0.7, 0.3})),
      Option::spot_eight);
  EXPECT_EQ(result.ruling.spotted, std::vector{eight_ball_id});
  EXPECT_EQ(position_of(result.table, 8), physics::foot_spot(club_scene().bed));
  EXPECT_EQ(result.game.status.turn, breaker);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::none);
  EXPECT_TRUE(result.game.status.options.empty());
}

TEST(Rule3_3e, TheBreakerMayBreakAgain) {
  const auto result = chosen(after(hit_rack().drops(1, 8, 2)), Option::rerack_and_break);
  EXPECT_TRUE(result.rerack);
  EXPECT_EQ(result.game, eight_ball_start(breaker));
}

TEST(Rule3_3f, TheEightAndTheCueBallOnTheBreakAreTheOpponentsChoice) {
  const auto scratched = after(hit_rack().drops(1, 8, 2).drops(2, 0, 3));
  EXPECT_EQ(scratched.ruling.fouls, std::vector{Foul::scratch});
  EXPECT_FALSE(scratched.ruling.rack_end) << "not a loss on the break";
  EXPECT_EQ(scratched.game.status.turn, opponent);
  EXPECT_EQ(scratched.game.status.options,
            (std::vector{Option::rerack_and_break, Option::spot_eight}));

  const auto spotted = chosen(scratched, Option::spot_eight);
  EXPECT_NE(find(spotted.table, eight_ball_id), nullptr);
  EXPECT_EQ(position_of(spotted.table, 0), physics::head_spot(club_scene().bed));
  EXPECT_EQ(spotted.game.status.turn, opponent);
  EXPECT_EQ(spotted.game.status.ball_in_hand, BallInHand::behind_head_string);

  EXPECT_EQ(chosen(scratched, Option::rerack_and_break).game, eight_ball_start(opponent));
}

TEST(Rule3_3h, AScratchOnALegalBreakIsBallInHandBehindTheHeadString) {
  const auto result = after(legal_break().drops(2, 0, 3));
  EXPECT_EQ(result.ruling.fouls, std::vector{Foul::scratch});
  EXPECT_EQ(result.game.status.turn, opponent);
  EXPECT_EQ(result.game.status.ball_in_hand, BallInHand::behind_head_string);
  EXPECT_TRUE(result.game.status.options.empty()) << "there is no position to accept";
  EXPECT_EQ(position_of(result.table, 0), physics::head_spot(club_scene().bed));
}

TEST(Rule3_3h, AfterAScratchBallsPocketedOnTheBreakStayDown) {
  const auto result = after(hit_rack().drops(1, 4, 1).drops(2, 0, 3));
  EXPECT_EQ(find(result.table, BallId{4}), nullptr);
  EXPECT_TRUE(result.ruling.spotted.empty());
  EXPECT_EQ(result.game.status.turn, opponent);
}

TEST(Rule3_3h, ABreakThatMissesTheRackIsFoulAndIllegalAndTheOpponentHasBothRemedies) {
  ShotBuilder shot(rack());
  shot.moves(0, 0, {-0.5842, 0}, {0, 1}).stops(2, 0, {-0.5842, 0.3});
  const auto result = after(shot);
  EXPECT_EQ(result.ruling.fouls, (std::vector{Foul::no_contact, Foul::behind_head_string}));
  EXPECT_TRUE(result.ruling.illegal_break);
  EXPECT_EQ(result.game.status.options,
            (std::vector{Option::accept_table, behind, Option::rerack_and_break,
                         Option::rerack_opponent_breaks}));
  const auto hand = chosen(result, behind);
  EXPECT_EQ(hand.game.status.ball_in_hand, BallInHand::behind_head_string);
  EXPECT_EQ(position_of(hand.table, 0), physics::head_spot(club_scene().bed))
      << "on the head string it cannot be played from";
}

TEST(Rule3_3h, AScratchOnAnIllegalBreakLeavesNoTableToAccept) {
  const auto result = after(hit_rack().drops(2, 0, 3));
  EXPECT_EQ(result.game.status.options,
            (std::vector{behind, Option::rerack_and_break, Option::rerack_opponent_breaks}));
}

TEST(Rule3_3h, ABreakThatPocketsNothingAndReachesNoRailIsAFoul) {
  const auto result = after(hit_rack());
  EXPECT_EQ(result.ruling.fouls, std::vector{Foul::no_rail});
  EXPECT_EQ(result.game.status.options.size(), 4u);
}

TEST(Rule3_3h, BallInHandAfterAFoulOnTheBreakKeepsACueBallThatLiesBehindTheString) {
  ShotBuilder shot(rack());
  shot.moves(0, 0, {-0.5842, 0}, {-1, 0}).stops(2, 0, {-0.9, 0.3});
  const auto hand = chosen(after(shot), behind);
  EXPECT_EQ(position_of(hand.table, 0), (Vec2{-0.9, 0.3}));
}

// ---- WPA 1.5: all legal object balls behind the head string

/// The table after a scratch on the break that left just these balls.
EightBallAfter scratched_with(const physics::State& left) {
  ShotBuilder shot(rack());
  shot.hits(0.14, 0, 3).drops(2, 0, 3);
  for (const physics::Ball& ball : rack().balls) {
    if (ball.id == cue_ball) continue;
    if (const physics::Ball* stays = find(left, ball.id)) {
      shot.stops(3, number(ball.id), stays->position);
    } else {
      shot.drops(1, number(ball.id), 0);
    }
  }
  return after(shot);
}

TEST(Rule1_5, WithAllLegalBallsBehindTheHeadStringTheNearestMayBeSpotted) {
  const auto offered =
      scratched_with(table_of({{2, {-0.9, 0.3}}, {5, {-0.7, -0.4}}, {8, {0.3, 0}}}));
  EXPECT_EQ(offered.game.status.ball_in_hand, BallInHand::behind_head_string);
  EXPECT_EQ(offered.game.status.options, (std::vector{behind, Option::spot_nearest_ball}));

  const auto spotted = chosen(offered, Option::spot_nearest_ball);
  EXPECT_EQ(spotted.ruling.spotted, std::vector{BallId{5}});
  EXPECT_EQ(position_of(spotted.table, 5), physics::foot_spot(club_scene().bed));
  EXPECT_EQ(position_of(spotted.table, 2), (Vec2{-0.9, 0.3}));
  EXPECT_EQ(spotted.game.status.ball_in_hand, BallInHand::behind_head_string);
  EXPECT_TRUE(spotted.game.status.options.empty());

  const auto as_it_is = chosen(offered, behind);
  EXPECT_EQ(as_it_is.table, offered.table);
  EXPECT_EQ(as_it_is.game.status.ball_in_hand, BallInHand::behind_head_string);
  EXPECT_TRUE(as_it_is.game.status.options.empty());
}

TEST(Rule1_5, ABallOnTheHeadStringIsPlayableSoNothingIsSpotted) {
  const double string_x = physics::head_string_x(club_scene().bed);
  const auto result = scratched_with(table_of({{2, {-0.9, 0.3}}, {5, {string_x, -0.4}}, {8, {}}}));
  EXPECT_TRUE(result.game.status.options.empty());
}

TEST(Rule1_5, OfEquallyNearBallsTheLowestIsSpotted) {
  const auto offered =
      scratched_with(table_of({{6, {-0.7, 0.3}}, {12, {-0.7, -0.4}}, {8, {0.3, 0}}}));
  EXPECT_EQ(chosen(offered, Option::spot_nearest_ball).ruling.spotted, std::vector{BallId{6}});
}

}  // namespace
}  // namespace breakshot::rules
