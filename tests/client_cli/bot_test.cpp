// The bot offline: what it decides is legal wherever it is put, and its racks come to an end.
#include "client_cli/bot/decide.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "client_cli/bot/candidates.hpp"
#include "common/physics/table.hpp"
#include "common/rules/eight_ball.hpp"
#include "common/rules/groups.hpp"
#include "common/rules/placement.hpp"

namespace breakshot::bot {
namespace {

using match::GameKind;
using rules::Group;
using rules::Seat;

constexpr unsigned seed = 20240611;

/// Thinks just enough to be fast where a thousand decisions are made.
Effort quick(std::uint32_t turn) {
  Effort effort;
  effort.seed = {7, 7};
  effort.turn = turn;
  effort.candidates = 24;
  effort.finalists = 2;
  effort.samples = 2;
  return effort;
}

std::string text_of(const Position& position) {
  std::string text =
      "ball in hand " + std::to_string(static_cast<int>(position.status.ball_in_hand)) + ", balls";
  for (const auto& ball : position.table.balls) {
    text += ' ' + std::to_string(physics::number(ball.id)) + " (" +
            std::to_string(ball.position.x) + ", " + std::to_string(ball.position.y) + ")";
  }
  return text;
}

/// Up to 16 balls anywhere, in any group's turn, now and then with the ball in hand.
Position random_position(std::mt19937& random) {
  const auto one_of = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  Position position;
  const auto& presets = physics::presets();
  position.scene = presets[random() % presets.size()].scene;
  position.game = one_of(8) == 0 ? GameKind::practice : GameKind::eight_ball;
  const double x = *position.scene.bed.length_m / 2 - position.scene.ball.radius_m;
  const double y = *position.scene.bed.width_m / 2 - position.scene.ball.radius_m;
  std::uniform_real_distribution<double> unit(-1, 1);
  const int share = 1 + one_of(8);
  for (std::uint32_t id = 0; id <= 15; ++id) {
    if (id != 0 && id != 8 && one_of(8) >= share) continue;
    Vec2 place;
    do {
      place = {x * unit(random), y * unit(random)};
    } while (rules::placement_fault(position.scene, position.table, BallId{id}, place,
                                    rules::BallInHand::anywhere));
    position.table = rules::with_ball(position.table, BallId{id}, place);
  }
  auto& status = position.status;
  status.turn = Seat{static_cast<std::uint8_t>(one_of(2))};
  status.groups = {Group::none, Group::none};
  if (position.game == GameKind::practice) {
    status.ball_in_hand = rules::BallInHand::anywhere;
    return position;
  }
  if (one_of(3) != 0) {
    status.groups[0] = one_of(2) == 0 ? Group::solids : Group::stripes;
    status.groups[1] = rules::opposite(status.groups[0]);
  }
  if (one_of(3) == 0) status.ball_in_hand = rules::BallInHand{static_cast<std::uint8_t>(one_of(3))};
  return position;
}

/// What a referee would object to before the shot, or nothing.
std::string objection_to(const Position& position, const match::Shoot& shoot,
                         const physics::State& table) {
  const double length = physics::length(shoot.direction);
  if (!(std::abs(length - 1) <= 1e-9)) return "the direction has length " + std::to_string(length);
  if (!(shoot.speed_m_s > 0 && shoot.speed_m_s <= match::max_shot_speed_m_s)) {
    return "the speed is " + std::to_string(shoot.speed_m_s);
  }
  const Vec2 cue = rules::find(table, rules::cue_ball)->position;
  if (!rules::may_play_from(position.scene.bed, position.status.ball_in_hand, cue)) {
    return "the cue ball may not be played from where it is";
  }
  const auto fault =
      position.game == GameKind::practice
          ? rules::call_fault(rules::Practice{}, shoot.call)
          : rules::call_fault(rules::EightBall{Seat{0}, position.status}, table, shoot.call);
  return fault.value_or("");
}

TEST(Bot, IsLegalInAThousandPositions) {
  std::mt19937 random(seed);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Position position = random_position(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", position " + std::to_string(i) + ", " +
                 text_of(position));
    const Decision decision = decide(position, quick(i));
    if (std::holds_alternative<match::Concede>(decision.act)) {
      EXPECT_EQ(position.game, GameKind::practice);
      EXPECT_EQ(position.table.balls.size(), 1u);
      continue;
    }
    physics::State table = position.table;
    if (decision.place) {
      ASSERT_NE(position.status.ball_in_hand, rules::BallInHand::none);
      ASSERT_EQ(rules::placement_fault(position.scene, table, rules::cue_ball,
                                       decision.place->position, position.status.ball_in_hand),
                std::nullopt);
      table = rules::with_ball(table, rules::cue_ball, decision.place->position);
    }
    ASSERT_EQ(objection_to(position, std::get<match::Shoot>(decision.act), table), "");
  }
}

TEST(Bot, DecidesTheSameFromTheSameSeed) {
  std::mt19937 random(seed);
  for (std::uint32_t i = 0; i < 20; ++i) {
    const Position position = random_position(random);
    const Decision one = decide(position, quick(i));
    const Decision two = decide(position, quick(i));
    EXPECT_EQ(one.place, two.place);
    EXPECT_EQ(one.act, two.act);
  }
}

Position lone_eight() {
  Position position;
  position.scene = physics::presets().front().scene;
  position.table = {{{BallId{0}, {0, 0}, {}, {}}, {BallId{8}, {0.8, 0.35}, {}, {}}}};
  position.status.groups = {Group::solids, Group::stripes};
  return position;
}

TEST(Bot, StrikesNoFurtherOffThanItsHandIs) {
  for (std::uint32_t turn = 0; turn < 50; ++turn) {
    Effort steady = quick(turn);
    steady.finalists = 1;
    Effort unsteady = steady;
    unsteady.hand = {0.01, 0.1};
    // One finalist, so that both mean the same shot.
    const auto meant = std::get<match::Shoot>(decide(lone_eight(), steady).act);
    const auto struck = std::get<match::Shoot>(decide(lone_eight(), unsteady).act);
    EXPECT_LE(std::abs(physics::cross(meant.direction, struck.direction)), 0.01);
    EXPECT_LE(std::abs(struck.speed_m_s / meant.speed_m_s - 1), 0.1 + 1e-12);
    EXPECT_NE(meant.direction, struck.direction) << turn;
  }
}

TEST(Bot, TakesTheNextBestShotWhereTheBestCannotBePlayed) {
  Effort effort;
  const auto best = std::get<match::Shoot>(decide(lone_eight(), effort).act);
  effort.skip = 1;
  const auto next = std::get<match::Shoot>(decide(lone_eight(), effort).act);
  EXPECT_FALSE(best == next);
}

TEST(Bot, HasNeverMoreCandidatesThanItMay) {
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < 100; ++i) {
    const Position position = random_position(random);
    const auto candidates = candidates_of(position, 1 + i);
    EXPECT_LE(candidates.size(), 1 + i);
    EXPECT_GE(candidates.size(), std::min<std::size_t>(1 + i, 16));
  }
}

TEST(Bot, CallsAndTakesTheEightThatWins) {
  const Decision decision = decide(lone_eight(), Effort{});
  const auto& shoot = std::get<match::Shoot>(decision.act);
  EXPECT_EQ(shoot.call.ball, BallId{8});
  EXPECT_EQ(shoot.call.pocket, PocketId{3});
}

TEST(Bot, PutsTheBallInHandWhereTheShotIsEasy) {
  Position position = lone_eight();
  position.table = rules::with_ball(position.table, rules::cue_ball, {1.1, 0.5});
  position.status.ball_in_hand = rules::BallInHand::anywhere;
  const Decision decision = decide(position, Effort{});
  EXPECT_TRUE(decision.place);
  EXPECT_EQ(std::get<match::Shoot>(decision.act).call.ball, BallId{8});
}

TEST(Bot, TakesThePositionRatherThanGivingTheBreakAway) {
  Position position = lone_eight();
  position.status.options = {rules::Option::accept_table, rules::Option::rerack_opponent_breaks};
  const Decision decision = decide(position, Effort{});
  EXPECT_EQ(decision.act, (std::variant<match::Shoot, match::Choose, match::Concede>(
                              match::Choose{rules::Option::accept_table})));
}

TEST(Bot, EndsAPracticeWithNoBallLeft) {
  Position position;
  position.scene = physics::presets().front().scene;
  position.game = GameKind::practice;
  position.table = {{{BallId{0}, {0, 0}, {}, {}}}};
  EXPECT_TRUE(std::holds_alternative<match::Concede>(decide(position, Effort{}).act));
}

// ---- Whole matches, by the bot against itself

struct Course {
  std::size_t shots = 0;
  std::size_t fouls = 0;
  std::optional<Seat> winner;
  std::string refused;
};

Course play(const match::Settings& settings, const physics::Seed& match_seed, Effort effort,
            std::size_t most_shots) {
  Course course;
  auto match = match::created(settings, match_seed);
  const auto carry_out = [&](const std::optional<Seat>& seat, const match::Command& command) {
    auto result = match::apply(match, {{seat}, match.next, command});
    if (const auto* refusal = std::get_if<match::Refusal>(&result)) {
      course.refused = refusal->what;
      return;
    }
    auto accepted = std::get<match::Accepted>(std::move(result));
    course.shots += accepted.outcome.shot ? 1u : 0u;
    course.fouls += accepted.outcome.ruling ? accepted.outcome.ruling->fouls.size() : 0u;
    match = std::move(accepted.next);
  };
  carry_out(std::nullopt, match::Start{});
  while (match.status.stage != match::Stage::finished && course.refused.empty() &&
         course.shots < most_shots) {
    effort.turn = static_cast<std::uint32_t>(match.next);
    const Seat turn = match.status.game.turn;
    const Decision decision =
        decide({settings.game, settings.scene, match.table, match.status.game}, effort);
    if (decision.place) carry_out(turn, *decision.place);
    if (!course.refused.empty()) break;
    std::visit([&](const auto& act) { carry_out(turn, act); }, decision.act);
  }
  course.winner = match.status.winner;
  return course;
}

TEST(Bot, FinishesRacksAgainstItselfWithAnUnsteadyHand) {
  std::size_t shots = 0;
  constexpr int matches = 6;
  for (int i = 0; i < matches; ++i) {
    const auto& preset =
        physics::presets()[static_cast<std::size_t>(i) % physics::presets().size()];
    Effort effort = quick(0);
    effort.candidates = 120;
    effort.hand = {0.015, 0.05};
    const Course course = play({std::string(preset.name), preset.scene, GameKind::eight_ball, 2, 1},
                               {static_cast<std::uint8_t>(i), 1}, effort, 200);
    EXPECT_EQ(course.refused, "") << "match " << i;
    EXPECT_TRUE(course.winner) << "match " << i;
    RecordProperty("match " + std::to_string(i), std::to_string(course.shots));
    shots += course.shots;
  }
  EXPECT_LT(shots, 60u * matches);
}

TEST(Bot, ClearsThePracticeTable) {
  const auto& preset = physics::presets().front();
  const Course course =
      play({std::string(preset.name), preset.scene, GameKind::practice, 1, 1}, {3}, quick(0), 200);
  EXPECT_EQ(course.refused, "");
  EXPECT_LT(course.shots, 100u);
}

}  // namespace
}  // namespace breakshot::bot
