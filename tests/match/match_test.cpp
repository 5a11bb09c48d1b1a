// A match of 8-ball as a fold over commands.
#include "common/match/match.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "common/rules/groups.hpp"
#include "tests/support/match_fold.hpp"

namespace breakshot::match {
namespace {

using physics::BallId;
using physics::PocketId;
using physics::Vec2;
using rules::BallInHand;
using rules::Group;
using support::after;
using support::ask;
using support::eight_ball_settings;
using support::refusal;
using support::seat;
using support::started;
using support::table_of;
using support::the_server;

constexpr Shoot hard_break{{1, 0}, 9, {}};
constexpr rules::Call safety{{}, {}, true};

Vec2 cue_position(const Match& match) {
  return rules::find(match.table, rules::cue_ball)->position;
}

/// A running match at some later moment: seat 0 is to shoot, with these groups and balls.
Match in_play(const physics::State& table, Group group_of_0, std::uint32_t race_to = 1) {
  Match match = started(eight_ball_settings(race_to));
  auto& game = std::get<rules::EightBall>(match.game);
  game.status.breaking = false;
  game.status.ball_in_hand = BallInHand::none;
  game.status.groups = {group_of_0, rules::opposite(group_of_0)};
  match.status.game = game.status;
  match.table = table;
  return match;
}

/// The 8 lies before the foot-left pocket with the cue ball behind it: a stop shot wins.
Match at_the_winning_shot(std::uint32_t race_to = 1) {
  return in_play(table_of({{0, {0.7, 0.1442}}, {8, {0.9, 0.3442}}, {9, {-0.5, 0}}}), Group::solids,
                 race_to);
}
const double diagonal = 0.70710678118654752;
const Shoot winning_shot{{diagonal, diagonal}, 2, {BallId{8}, PocketId{3}, false}};

TEST(Match, StartsWithARackForSeat0ToBreak) {
  const Match before = created(eight_ball_settings(3), {});
  EXPECT_EQ(before.status.stage, Stage::gathering);
  EXPECT_EQ(before.status.rack, 0u);
  const Match match = after(before, the_server, Start{});
  EXPECT_EQ(match.status.stage, Stage::running);
  EXPECT_EQ(match.status.rack, 1u);
  EXPECT_EQ(match.status.score, (std::vector<std::uint32_t>{0, 0}));
  EXPECT_EQ(match.status.game.turn, Seat{0});
  EXPECT_TRUE(match.status.game.breaking);
  EXPECT_EQ(match.table.balls.size(), 16u);
  EXPECT_EQ(match.next, Seq{1});
}

TEST(Match, AnOutcomeShowsWhatTheNextMatchIs) {
  const Match match = started(eight_ball_settings());
  const auto result = ask(match, seat(0), hard_break);
  const auto& accepted = std::get<Accepted>(result);
  EXPECT_TRUE(accepted.outcome.shot);
  EXPECT_TRUE(accepted.outcome.ruling);
  EXPECT_EQ(accepted.outcome.table, accepted.next.table);
  EXPECT_EQ(accepted.outcome.status, accepted.next.status);
  EXPECT_EQ(accepted.next.shots, 1u);
  EXPECT_EQ(accepted.next.next, Seq{2});
}

TEST(Match, BeforeItsStartNothingElseIsAllowed) {
  const Match match = created(eight_ball_settings(), {});
  for (const Command& command :
       std::vector<Command>{Place{}, hard_break, Choose{}, Concede{}, AgreeRerack{}}) {
    EXPECT_EQ(refusal(match, seat(0), command).code, RefusalCode::not_allowed_now);
  }
  EXPECT_EQ(refusal(match, the_server, Abandoned{Seat{0}}).code, RefusalCode::not_allowed_now);
}

TEST(Match, StartsOnce) {
  EXPECT_EQ(refusal(started(eight_ball_settings()), the_server, Start{}).code,
            RefusalCode::not_allowed_now);
}

TEST(Match, AnotherSequenceNumberThanTheNextIsRefused) {
  const Match match = started(eight_ball_settings());
  for (const std::uint32_t wrong : {0u, 2u, 0xffffffffu}) {
    const auto result = apply(match, {seat(0), Seq{wrong}, hard_break});
    EXPECT_EQ(std::get<Refusal>(result).code, RefusalCode::wrong_sequence);
  }
}

TEST(Match, OnlyTheServerStartsAndAbandons) {
  EXPECT_EQ(refusal(created(eight_ball_settings(), {}), seat(0), Start{}).code,
            RefusalCode::not_allowed_now);
  EXPECT_EQ(refusal(started(eight_ball_settings()), seat(0), Abandoned{Seat{1}}).code,
            RefusalCode::not_allowed_now);
}

TEST(Match, TheServerNeverPlays) {
  const Match match = started(eight_ball_settings());
  for (const Command& command :
       std::vector<Command>{Place{}, hard_break, Choose{}, Concede{}, AgreeRerack{}}) {
    EXPECT_EQ(refusal(match, the_server, command).code, RefusalCode::not_your_turn);
  }
}

TEST(Match, OnlyThePlayerAtTheTablePlacesAndShoots) {
  const Match match = started(eight_ball_settings());
  EXPECT_EQ(refusal(match, seat(1), hard_break),
            (Refusal{RefusalCode::not_your_turn, "it is the turn of seat 0"}));
  EXPECT_EQ(refusal(match, seat(1), Place{}).code, RefusalCode::not_your_turn);
  EXPECT_EQ(refusal(match, seat(2), hard_break).code, RefusalCode::not_your_turn);
  EXPECT_EQ(refusal(match, seat(255), Concede{}).code, RefusalCode::not_your_turn);
}

// ---- Placing

TEST(Place, TheCueBallMovesAsOftenAsThePlayerLikesBeforeHeShoots) {
  Match match = started(eight_ball_settings());
  for (const double y : {0.2, -0.3, 0.1}) {
    match = after(match, seat(0), Place{rules::cue_ball, {-0.7, y}});
    EXPECT_EQ(cue_position(match), (Vec2{-0.7, y}));
    EXPECT_EQ(match.status.game.ball_in_hand, BallInHand::behind_head_string);
  }
  match =
      after(match, seat(0), Place{rules::cue_ball, physics::head_spot(match.settings.scene.bed)});
  after(match, seat(0), hard_break);
}

TEST(Place, BeforeTheBreakTheCueBallStaysBehindTheHeadString) {
  const Match match = started(eight_ball_settings());
  const Refusal refused = refusal(match, seat(0), Place{rules::cue_ball, {0, 0}});
  EXPECT_EQ(refused.code, RefusalCode::bad_value);
  EXPECT_EQ(refused.what.substr(0, 11), "position.x:");
}

TEST(Place, NoOtherBallIsInHand) {
  EXPECT_EQ(refusal(started(eight_ball_settings()), seat(0), Place{BallId{8}, {-0.7, 0}}).code,
            RefusalCode::bad_value);
}

TEST(Place, ACueBallThatIsNotInHandStaysWhereItLies) {
  const Match match = in_play(table_of({{0, {}}, {1, {0.5, 0}}, {8, {0.8, 0}}}), Group::solids);
  EXPECT_EQ(refusal(match, seat(0), Place{rules::cue_ball, {-0.7, 0}}).code,
            RefusalCode::not_allowed_now);
}

TEST(Place, MinusZeroIsZero) {
  const Match match =
      after(started(eight_ball_settings()), seat(0), Place{rules::cue_ball, {-0.7, -0.0}});
  EXPECT_FALSE(std::signbit(cue_position(match).y));
}

// ---- Shooting

TEST(Shoot, TheDirectionIsAUnitVector) {
  const Match match = started(eight_ball_settings());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Vec2 direction : {Vec2{0, 0}, Vec2{1 + 2e-9, 0}, Vec2{1 - 2e-9, 0}, Vec2{1, 1},
                               Vec2{nan, 0}, Vec2{infinity, 0}, Vec2{1, nan}}) {
    EXPECT_EQ(refusal(match, seat(0), Shoot{direction, 5, {}}).code, RefusalCode::bad_value);
  }
  after(match, seat(0), Shoot{{1 + 0.9e-9, 0}, 5, {}});
}

TEST(Shoot, TheSpeedIsAboveZeroAndAtMostTheGreatest) {
  const Match match = started(eight_ball_settings());
  for (const double speed : {0.0, -1.0, 13.0000001, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(refusal(match, seat(0), Shoot{{1, 0}, speed, {}}).code, RefusalCode::bad_value);
  }
  after(match, seat(0), Shoot{{1, 0}, max_shot_speed_m_s, {}});
  after(match, seat(0), Shoot{{1, 0}, std::numeric_limits<double>::denorm_min(), {}});
}

TEST(Shoot, TheCallMustSuitTheMoment) {
  EXPECT_EQ(refusal(started(eight_ball_settings()), seat(0), Shoot{{1, 0}, 5, safety}).code,
            RefusalCode::bad_value);
  Shoot uncalled = winning_shot;
  uncalled.call = {};
  EXPECT_EQ(refusal(at_the_winning_shot(), seat(0), uncalled).code, RefusalCode::bad_value);
}

TEST(Shoot, ACueBallInHandBehindTheHeadStringMustBeThereFirst) {
  Match match = in_play(table_of({{0, {0.5, 0}}, {1, {0.8, 0}}, {8, {0.8, 0.3}}}), Group::none);
  std::get<rules::EightBall>(match.game).status.ball_in_hand = BallInHand::behind_head_string;
  match.status.game.ball_in_hand = BallInHand::behind_head_string;
  EXPECT_EQ(refusal(match, seat(0), Shoot{{1, 0}, 5, safety}).code, RefusalCode::not_allowed_now);
  match = after(match, seat(0), Place{rules::cue_ball, {-0.7, 0}});
  after(match, seat(0), Shoot{{1, 0}, 5, safety});
}

TEST(Shoot, TheSameShotAskedAgainHasTheSameOutcome) {
  const Match match = started(eight_ball_settings());
  const auto once = ask(match, seat(0), hard_break);
  const auto again = ask(match, seat(0), hard_break);
  EXPECT_EQ(std::get<Accepted>(once).outcome, std::get<Accepted>(again).outcome);
}

TEST(Shoot, TheNextShotDrawsAnewEvenFromTheSamePosition) {
  Match match = started(eight_ball_settings());
  const auto first = ask(match, seat(0), hard_break);
  ++match.shots;
  const auto second = ask(match, seat(0), hard_break);
  EXPECT_NE(std::get<Accepted>(first).outcome.shot, std::get<Accepted>(second).outcome.shot);
}

TEST(Shoot, OneThatCannotBeSimulatedIsRefused) {
  // A cushion without restitution and a ball pressed into its corner would be a natural case, but
  // every shot of a good scene ends; so the event limit is reached by a scene that hardly brakes.
  Settings settings = eight_ball_settings();
  settings.scene.bed.motion = physics::Straight{1e-9, 1e-9, 1};
  settings.scene.cushions = physics::RectangleCushions{physics::Mirror{}};
  settings.scene.ball_ball = physics::Elastic{};
  settings.scene.pockets = physics::StandardPockets{0.001, 0.001};
  const Match match = started(settings);
  const Match copy = match;
  const Refusal refused = refusal(match, seat(0), hard_break);
  EXPECT_EQ(refused.code, RefusalCode::stalled);
  EXPECT_EQ(match, copy);
}

// ---- Choices

/// An illegal break: the cue ball rolls into the rack too softly.
Match after_soft_break() {
  const Match match = after(started(eight_ball_settings()), seat(0), Shoot{{1, 0}, 0.6, {}});
  EXPECT_FALSE(match.status.game.options.empty());
  return match;
}

TEST(Choose, WhileAChoiceIsOpenNothingIsPlacedOrShot) {
  const Match match = after_soft_break();
  EXPECT_EQ(match.status.game.turn, Seat{1});
  EXPECT_EQ(refusal(match, seat(1), Place{rules::cue_ball, {-0.7, 0}}).code,
            RefusalCode::not_allowed_now);
  EXPECT_EQ(refusal(match, seat(1), Shoot{{1, 0}, 5, safety}).code, RefusalCode::not_allowed_now);
}

TEST(Choose, OnlyAnOpenOptionCanBeChosen) {
  const Match match = after_soft_break();
  EXPECT_EQ(refusal(match, seat(1), Choose{rules::Option::spot_eight}).code,
            RefusalCode::bad_value);
  EXPECT_EQ(refusal(match, seat(1), Choose{rules::Option{99}}).code, RefusalCode::bad_value);
  EXPECT_EQ(refusal(match, seat(0), Choose{rules::Option::accept_table}).code,
            RefusalCode::not_your_turn);
  EXPECT_EQ(refusal(started(eight_ball_settings()), seat(0), Choose{}).code,
            RefusalCode::not_allowed_now);
}

TEST(Choose, ARerackDrawsANewOrderInTheSameRackOfTheMatch) {
  const Match match = after_soft_break();
  const Match reracked = after(match, seat(1), Choose{rules::Option::rerack_and_break});
  EXPECT_EQ(reracked.status.rack, 1u);
  EXPECT_EQ(reracked.status.game.turn, Seat{1});
  EXPECT_TRUE(reracked.status.game.breaking);
  EXPECT_EQ(reracked.table, rules::rack_eight_ball(match.settings.scene, match.seed, 1));
  const Match theirs = after(match, seat(1), Choose{rules::Option::rerack_opponent_breaks});
  EXPECT_EQ(theirs.status.game.turn, Seat{0});
}

TEST(Choose, AcceptingTheTableLeavesItAsItIs) {
  const Match match = after_soft_break();
  const Match accepted = after(match, seat(1), Choose{rules::Option::accept_table});
  EXPECT_EQ(accepted.table, match.table);
  EXPECT_EQ(accepted.status.game.turn, Seat{1});
  EXPECT_TRUE(accepted.status.game.options.empty());
}

// ---- Racks and races

TEST(Race, TheLastRackWinsTheMatch) {
  const Match won = after(at_the_winning_shot(), seat(0), winning_shot);
  EXPECT_EQ(won.status.stage, Stage::finished);
  EXPECT_EQ(won.status.end, MatchEnd::race_won);
  EXPECT_EQ(won.status.winner, Seat{0});
  EXPECT_EQ(won.status.score, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(won.status.rack, 1u);
}

TEST(Race, TheBreakAlternatesFromRackToRack) {
  Match match = at_the_winning_shot(3);
  match = after(match, seat(0), winning_shot);
  EXPECT_EQ(match.status.stage, Stage::running);
  EXPECT_EQ(match.status.score, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(match.status.rack, 2u);
  EXPECT_EQ(match.status.game.turn, Seat{1});
  EXPECT_TRUE(match.status.game.breaking);
  EXPECT_EQ(match.status.game.groups, (std::vector{Group::none, Group::none}));
  EXPECT_EQ(match.table, rules::rack_eight_ball(match.settings.scene, match.seed, 1));
  EXPECT_EQ(match.racks, 2u);
}

TEST(Race, TheEightInTheWrongPocketGivesTheRackToTheOpponent) {
  Shoot wrong = winning_shot;
  wrong.call.pocket = PocketId{2};
  const Match lost = after(at_the_winning_shot(), seat(0), wrong);
  EXPECT_EQ(lost.status.winner, Seat{1});
  EXPECT_EQ(lost.status.score, (std::vector<std::uint32_t>{0, 1}));
}

TEST(Race, AFinishedMatchTakesNoMoreCommands) {
  const Match won = after(at_the_winning_shot(), seat(0), winning_shot);
  for (const Command& command :
       std::vector<Command>{Place{}, hard_break, Choose{}, Concede{}, AgreeRerack{}}) {
    EXPECT_EQ(refusal(won, seat(0), command).code, RefusalCode::finished);
  }
  EXPECT_EQ(refusal(won, the_server, Abandoned{Seat{0}}).code, RefusalCode::finished);
}

// ---- Ends by other means

TEST(Concede, LosesTheMatchInAnybodysTurn) {
  for (const std::uint8_t loser : {std::uint8_t{0}, std::uint8_t{1}}) {
    const Match match = after(started(eight_ball_settings(5)), seat(loser), Concede{});
    EXPECT_EQ(match.status.stage, Stage::finished);
    EXPECT_EQ(match.status.end, MatchEnd::conceded);
    EXPECT_EQ(match.status.winner, rules::other(Seat{loser}));
  }
}

TEST(Abandoned, LosesTheMatchEvenWhileAChoiceIsOpen) {
  const Match match = after(after_soft_break(), the_server, Abandoned{Seat{1}});
  EXPECT_EQ(match.status.end, MatchEnd::abandoned);
  EXPECT_EQ(match.status.winner, Seat{0});
  EXPECT_TRUE(match.status.game.options.empty());
  EXPECT_EQ(refusal(after_soft_break(), the_server, Abandoned{Seat{2}}).code,
            RefusalCode::bad_value);
}

TEST(Rule1_12, AStalemateNeedsBothAndTheSamePlayerBreaksAgain) {
  Match match = in_play(table_of({{0, {}}, {1, {0.5, 0}}, {8, {0.8, 0}}}), Group::solids, 3);
  match.status.score = {1, 2};
  match = after(match, seat(1), AgreeRerack{});
  EXPECT_EQ(match.status.rerack_agreed, (std::vector<bool>{false, true}));
  EXPECT_EQ(refusal(match, seat(1), AgreeRerack{}).code, RefusalCode::not_allowed_now);
  match = after(match, seat(0), AgreeRerack{});
  EXPECT_EQ(match.status.rerack_agreed, (std::vector<bool>{false, false}));
  EXPECT_EQ(match.status.score, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(match.status.rack, 1u);
  EXPECT_EQ(match.status.game.turn, Seat{0});
  EXPECT_TRUE(match.status.game.breaking);
  EXPECT_EQ(match.table, rules::rack_eight_ball(match.settings.scene, match.seed, 1));
}

TEST(Rule1_12, AnAgreementLastsUntilTheNextShot) {
  Match match = in_play(table_of({{0, {}}, {1, {0.5, 0}}, {8, {0.8, 0.2}}}), Group::solids);
  match = after(match, seat(1), AgreeRerack{});
  match = after(match, seat(0), Shoot{{1, 0}, 1, safety});
  EXPECT_EQ(match.status.rerack_agreed, (std::vector<bool>{false, false}));
  match = after(match, seat(0), AgreeRerack{});
  EXPECT_FALSE(match.status.game.breaking);
}

TEST(Rule1_12, BeforeABreakThereIsNothingToRackAgain) {
  EXPECT_EQ(refusal(started(eight_ball_settings()), seat(0), AgreeRerack{}).code,
            RefusalCode::not_allowed_now);
}

}  // namespace
}  // namespace breakshot::match
