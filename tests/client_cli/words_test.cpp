#include "client_cli/words.hpp"

#include <gtest/gtest.h>

#include <set>

namespace breakshot::client {
namespace {

using physics::BallId;
using physics::PocketId;
using rules::Seat;

const Names ada_and_bob = {"Ada", "Bob"};

match::Status running(Seat turn) {
  match::Status status;
  status.stage = match::Stage::running;
  status.rack = 1;
  status.score = {0, 0};
  status.game.turn = turn;
  status.game.groups = {rules::Group::none, rules::Group::none};
  return status;
}

TEST(Words, NameEveryValueDifferently) {
  const auto all_differ = [](auto first, int count) {
    using Value = decltype(first);
    std::set<std::string> words;
    for (int i = 0; i < count; ++i) {
      const std::string text = words_of(static_cast<Value>(i));
      EXPECT_EQ(text.find("unknown"), std::string::npos) << text;
      words.insert(text);
    }
    EXPECT_EQ(words.size(), static_cast<std::size_t>(count));
    EXPECT_NE(words_of(static_cast<Value>(count)).find("unknown"), std::string::npos);
  };
  all_differ(PocketId{}, 6);
  all_differ(rules::Foul{}, 5);
  all_differ(rules::Option{}, 6);
  all_differ(rules::Group{}, 3);
  all_differ(match::GameKind{}, 2);
}

TEST(Words, SayCallsAsPlayersDo) {
  EXPECT_EQ(words_of(rules::Call{BallId{3}, PocketId{2}, false}),
            "3 ball in the foot right corner");
  EXPECT_EQ(words_of(rules::Call{std::nullopt, std::nullopt, true}), "safety");
  EXPECT_EQ(words_of(rules::Call{}), "");
}

TEST(Words, SayWhereTheTipMeetsTheBall) {
  EXPECT_EQ(words_of(physics::Tip{}), "");
  EXPECT_EQ(words_of(physics::Tip{0.2, 0}), "0.20 R left of the centre");
  EXPECT_EQ(words_of(physics::Tip{0, -0.125}), "0.12 R below the centre");
  EXPECT_EQ(words_of(physics::Tip{-0.3, 0.25}), "0.30 R right of and 0.25 R above the centre");
  const match::Shoot shoot{{1, 0}, 2, {}, {0.2, 0}};
  const std::string text = command_text({Seat{0}}, shoot, running(Seat{0}), ada_and_bob);
  EXPECT_NE(text.find("0.00 degrees, the tip 0.20 R left of the centre."), std::string::npos)
      << text;
}

TEST(Words, ListBallsWithTheCueBallByName) {
  EXPECT_EQ(balls_in_words({}), "");
  EXPECT_EQ(balls_in_words({BallId{8}}), "8");
  EXPECT_EQ(balls_in_words({BallId{1}, BallId{9}, BallId{0}}), "1, 9 and the cue ball");
}

TEST(Words, DescribeEvents) {
  EXPECT_EQ(words_of(physics::Event(physics::Spins{0, BallId{4}})), "4 ball spins in place");
  EXPECT_EQ(words_of(physics::Event(physics::Struck{0, BallId{0}})), "cue ball is struck");
  EXPECT_EQ(words_of(physics::Event(physics::BallBall{1, 0, BallId{0}, BallId{8}})),
            "cue ball and 8 ball collide");
  EXPECT_EQ(words_of(physics::Event(physics::BallPocket{1, 0, BallId{5}, PocketId{1}})),
            "5 ball drops in the right side");
}

TEST(Words, MatchIdsHaveSixteenDigits) {
  EXPECT_EQ(words_of(match::MatchId{0xab}), "00000000000000ab");
}

TEST(Names, StandInForThoseWhoHaveNone) {
  EXPECT_EQ(name_of(ada_and_bob, Seat{1}), "Bob");
  EXPECT_EQ(name_of({""}, Seat{0}), "player 1");
  EXPECT_EQ(name_of({}, Seat{3}), "player 4");
}

TEST(RulingText, SaysWhatARefereeWouldSay) {
  rules::Ruling ruling;
  EXPECT_EQ(ruling_text(ruling, Seat{0}, ada_and_bob), "");
  ruling.pocketed = {BallId{3}};
  ruling.group_won = rules::Group::solids;
  EXPECT_EQ(ruling_text(ruling, Seat{0}, ada_and_bob), "Pocketed: 3. Ada has solids.");
  ruling = {};
  ruling.fouls = {rules::Foul::scratch};
  ruling.pocketed = {BallId{0}};
  EXPECT_EQ(ruling_text(ruling, Seat{1}, ada_and_bob),
            "Foul: the cue ball was pocketed. Pocketed: the cue ball.");
  ruling = {};
  ruling.pocketed = {BallId{8}};
  ruling.rack_winner = Seat{1};
  ruling.rack_end = rules::RackEnd::eight_too_early;
  EXPECT_EQ(ruling_text(ruling, Seat{0}, ada_and_bob),
            "Pocketed: 8. Bob wins the rack: the 8 ball was pocketed too early.");
}

TEST(StatusText, SaysWhoseTurnItIsAndWithWhat) {
  match::Status status = running(Seat{1});
  EXPECT_EQ(status_text(status, ada_and_bob), "Bob shoots.");
  status.game.groups = {rules::Group::solids, rules::Group::stripes};
  status.game.ball_in_hand = rules::BallInHand::anywhere;
  EXPECT_EQ(status_text(status, ada_and_bob), "Bob shoots on stripes with ball in hand.");
  status.game.options = {rules::Option::accept_table, rules::Option::rerack_and_break};
  EXPECT_EQ(status_text(status, ada_and_bob),
            "Bob must choose: accept the table; or rack again and break.");
  status = running(Seat{0});
  status.game.breaking = true;
  status.game.ball_in_hand = rules::BallInHand::behind_head_string;
  EXPECT_EQ(status_text(status, ada_and_bob),
            "Ada breaks with ball in hand behind the head string.");
}

TEST(StatusText, SaysHowTheMatchEnded) {
  match::Status status = running(Seat{0});
  status.stage = match::Stage::finished;
  EXPECT_EQ(status_text(status, ada_and_bob), "The match is over.");
  status.winner = Seat{0};
  status.end = match::MatchEnd::race_won;
  EXPECT_EQ(status_text(status, ada_and_bob), "Ada wins the match.");
  status.end = match::MatchEnd::conceded;
  EXPECT_EQ(status_text(status, ada_and_bob), "Ada wins the match: the opponent has conceded.");
}

TEST(CommandText, SaysWhatAPlayerDid) {
  const match::Status status = running(Seat{0});
  const auto text = [&](const match::Command& command) {
    return command_text({Seat{0}}, command, status, ada_and_bob);
  };
  EXPECT_EQ(text(match::Shoot{{0, 1}, 2.5, {BallId{3}, PocketId{4}, false}}),
            "Ada shoots at 2.50 m/s and 90.00 degrees, calling the 3 ball in the left side.");
  EXPECT_EQ(text(match::Shoot{{1, -0.0}, 2.5, {std::nullopt, std::nullopt, true}}),
            "Ada shoots at 2.50 m/s and 0.00 degrees, calling a safety.");
  EXPECT_EQ(text(match::Place{BallId{0}, {-0.7, 0.1}}),
            "Ada places the cue ball at (-0.700, 0.100) m.");
  EXPECT_EQ(text(match::Choose{rules::Option::spot_eight}),
            "Ada chooses to have the 8 ball spotted and go on.");
  EXPECT_EQ(command_text({}, match::Abandoned{Seat{1}}, status, ada_and_bob),
            "Bob has left for good.");
  match::Status breaking = status;
  breaking.game.breaking = true;
  EXPECT_EQ(command_text({Seat{1}}, match::Shoot{{1, 0}, 8, {}}, breaking, ada_and_bob),
            "Bob breaks at 8.00 m/s and 0.00 degrees.");
}

TEST(ScoreText, IsForTwo) {
  match::Status status = running(Seat{0});
  status.score = {2, 1};
  EXPECT_EQ(score_text(status, ada_and_bob), "Ada 2 : 1 Bob");
  status.score = {0};
  EXPECT_EQ(score_text(status, ada_and_bob), "");
}

}  // namespace
}  // namespace breakshot::client
