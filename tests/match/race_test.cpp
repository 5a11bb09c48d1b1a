// How racks and matches of 8-ball go on and end: choices, the race, giving up, stalemate.
#include <gtest/gtest.h>

#include "tests/match/moments.hpp"

namespace breakshot::match {
namespace {

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

TEST(Rule3_1, TheBreakAlternatesFromRackToRack) {
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

TEST(Rule1_11, ConcedingLosesTheMatchInAnybodysTurn) {
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
