// A match of 8-ball as a fold over commands: who may ask what when, placing and shooting.
#include "common/match/match.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/match/moments.hpp"

namespace breakshot::match {
namespace {

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

TEST(Rule6_13, OnlyThePlayerAtTheTablePlacesAndShoots) {
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

TEST(Shoot, TheTipMustNotSlipOffTheBall) {
  match::Settings settings = eight_ball_settings();
  settings.scene.bed.motion = physics::Spinning{};
  const Match match = started(settings);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const physics::Tip tip :
       {physics::Tip{0.51, 0}, physics::Tip{0, -0.51}, physics::Tip{0.4, 0.4}, physics::Tip{nan, 0},
        physics::Tip{0, nan}, physics::Tip{infinity, 0}}) {
    const Refusal refused = refusal(match, seat(0), Shoot{{1, 0}, 5, {}, tip});
    EXPECT_EQ(refused.code, RefusalCode::bad_value);
    EXPECT_EQ(refused.what.rfind("tip: is too far off the centre", 0), 0u) << refused.what;
  }
  after(match, seat(0), Shoot{{1, 0}, 2, {}, {0.3, -0.4}});
  EXPECT_NE(after(match, seat(0), Shoot{{1, 0}, 2, {}, {0.3, 0.4}}),
            after(match, seat(0), Shoot{{1, 0}, 2, {}}));
}

TEST(Shoot, WhereBallsDoNotSpinTheCentreIsStruck) {
  match::Settings settings = eight_ball_settings();
  settings.scene.bed.motion = physics::Straight{};
  settings.scene.cushions = physics::RectangleCushions{physics::Mirror{}};
  settings.scene.pockets = physics::StandardPockets{};
  settings.scene.ball_ball = physics::Elastic{};
  const Match match = started(settings);
  const Refusal refused = refusal(match, seat(0), Shoot{{1, 0}, 5, {}, {0.1, 0}});
  EXPECT_EQ(refused.code, RefusalCode::bad_value);
  EXPECT_EQ(refused.what.rfind("tip: is off the centre; ", 0), 0u) << refused.what;
  after(match, seat(0), Shoot{{1, 0}, 5, {}, {-0.0, 0}});
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
  // Every shot on an ordinary table ends; the event limit is reached on one that hardly brakes.
  Settings settings = eight_ball_settings();
  settings.scene.bed.motion = physics::Straight{1e-9, 1e-9, 1};
  settings.scene.cushions = physics::RectangleCushions{physics::Mirror{}};
  settings.scene.ball_ball = physics::Elastic{};
  settings.scene.pockets = physics::StandardPockets{0.001, 0.001};
  const Match match = started(settings);
  const Refusal refused = refusal(match, seat(0), hard_break);
  EXPECT_EQ(refused.code, RefusalCode::stalled);
  EXPECT_NE(refused.what.find("it stalled at ball"), std::string::npos) << refused.what;
}

}  // namespace
}  // namespace breakshot::match
