// Practice as a fold over commands.
#include <gtest/gtest.h>

#include "common/rules/groups.hpp"
#include "tests/support/match_fold.hpp"

namespace breakshot::match {
namespace {

using physics::BallId;
using physics::Vec2;
using support::after;
using support::practice_settings;
using support::refusal;
using support::seat;
using support::started;
using support::the_server;

constexpr Shoot soft{{-1, 0}, 0.3, {}};

TEST(PracticeMatch, StartsWithAFullRackAndBallsInHand) {
  const Match match = started(practice_settings(1));
  EXPECT_EQ(match.table.balls.size(), 16u);
  EXPECT_EQ(match.status.game.ball_in_hand, rules::BallInHand::anywhere);
  EXPECT_FALSE(match.status.game.breaking);
}

TEST(PracticeMatch, AnyBallGoesAnywhereThatIsFree) {
  Match match = started(practice_settings(1));
  match = after(match, seat(0), Place{BallId{8}, {-0.2, 0.3}});
  match = after(match, seat(0), Place{rules::cue_ball, {0.2, 0.3}});
  EXPECT_EQ(rules::find(match.table, BallId{8})->position, (Vec2{-0.2, 0.3}));
  EXPECT_EQ(match.table.balls.size(), 16u);
  EXPECT_EQ(refusal(match, seat(0), Place{BallId{3}, {-0.21, 0.3}}).code, RefusalCode::bad_value);
  EXPECT_EQ(refusal(match, seat(0), Place{BallId{16}, {-0.9, 0.3}}).code, RefusalCode::bad_value);
}

TEST(PracticeMatch, APocketedBallCanBePutBack) {
  Match match = started(practice_settings(1));
  std::erase_if(match.table.balls, [](const physics::Ball& b) { return b.id == BallId{5}; });
  match = after(match, seat(0), Place{BallId{5}, {-0.2, 0.3}});
  ASSERT_EQ(match.table.balls.size(), 16u);
  EXPECT_EQ(match.table.balls[5].id, BallId{5}) << "in ascending order";
}

TEST(PracticeMatch, TheTurnGoesRoundAfterEachShotAndOnlyThen) {
  Match match = started(practice_settings(3));
  match = after(match, seat(0), Place{rules::cue_ball, {0, 0}});
  EXPECT_EQ(match.status.game.turn, Seat{0});
  for (const std::uint8_t turn : {std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{2}}) {
    match = after(match, seat(turn), soft);
  }
  EXPECT_EQ(match.status.game.turn, Seat{0});
  EXPECT_EQ(match.shots, 3u);
}

TEST(PracticeMatch, EndsWithoutAWinnerWhenTheLastHasLeft) {
  Match match = started(practice_settings(3));
  match = after(match, seat(1), Concede{});
  EXPECT_EQ(match.status.stage, Stage::running);
  EXPECT_EQ(refusal(match, seat(1), AgreeRerack{}).code, RefusalCode::not_your_turn);
  EXPECT_EQ(refusal(match, the_server, Abandoned{Seat{1}}).code, RefusalCode::bad_value);
  match = after(match, seat(0), soft);
  EXPECT_EQ(match.status.game.turn, Seat{2});
  match = after(match, the_server, Abandoned{Seat{2}});
  EXPECT_EQ(match.status.game.turn, Seat{0});
  match = after(match, seat(0), Concede{});
  EXPECT_EQ(match.status.stage, Stage::finished);
  EXPECT_EQ(match.status.end, MatchEnd::conceded);
  EXPECT_FALSE(match.status.winner);
}

TEST(PracticeMatch, RacksAgainOnceAllWhoPlayHaveAsked) {
  Match match = started(practice_settings(3));
  match = after(match, seat(0), soft);
  match = after(match, seat(0), AgreeRerack{});
  match = after(match, seat(2), AgreeRerack{});
  EXPECT_EQ(match.racks, 1u);
  match = after(match, seat(1), Concede{});
  EXPECT_EQ(match.racks, 2u) << "who has left need not agree";
  EXPECT_EQ(match.table, rules::rack_eight_ball(match.settings.scene, match.seed, 1));
  EXPECT_EQ(match.status.game.turn, Seat{2});
  EXPECT_EQ(match.status.rerack_agreed, std::vector<bool>(3, false));
}

TEST(PracticeMatch, OneAloneRacksAgainAtOnce) {
  const Match match = after(started(practice_settings(1)), seat(0), AgreeRerack{});
  EXPECT_EQ(match.racks, 2u);
}

}  // namespace
}  // namespace breakshot::match
