#include "common/match/match.hpp"

#include <algorithm>
#include <utility>

#include "common/match/permission.hpp"
#include "common/physics/simulate.hpp"
#include "common/rules/groups.hpp"
#include "common/rules/placement.hpp"

namespace breakshot::match {
namespace {

using Result = std::variant<Accepted, Refusal>;

/// A direction is a unit vector to within this: what shortest decimals keep, and no more.
constexpr double unit_tolerance = 1e-9;

/// What a command has led to before the bookkeeping that all commands share.
struct Step {
  Match next;
  std::optional<physics::Shot> shot;
  std::optional<rules::Ruling> ruling;
};
using Stepped = std::variant<Step, Refusal>;

Refusal bad_value(std::string what) {
  return {RefusalCode::bad_value, std::move(what)};
}

rules::GameStatus& game_status(Match& match) {
  return std::visit([](auto& game) -> rules::GameStatus& { return game.status; }, match.game);
}

// ---- Racks and the end of a match

void set_up_rack(Match& match) {
  match.table = rules::rack_eight_ball(match.settings.scene, match.seed, match.racks++);
  match.status.rerack_agreed.assign(match.settings.seats, false);
}

/// Seat 0 breaks the first rack of a match, then the break alternates.
Seat breaker_of(std::uint32_t rack) {
  return Seat{static_cast<std::uint8_t>((rack - 1) % 2)};
}

void next_rack(Match& match) {
  ++match.status.rack;
  if (match.settings.game == GameKind::eight_ball) {
    match.game = rules::eight_ball_start(breaker_of(match.status.rack));
  }
  set_up_rack(match);
}

void finish(Match& match, MatchEnd end, std::optional<Seat> winner) {
  match.status.stage = Stage::finished;
  match.status.end = end;
  match.status.winner = winner;
  match.status.rerack_agreed.assign(match.settings.seats, false);
  rules::GameStatus& game = game_status(match);
  game.options.clear();
  game.ball_in_hand = rules::BallInHand::none;
}

void score(Match& match, Seat winner) {
  if (++match.status.score[rules::number(winner)] == match.settings.race_to) {
    finish(match, MatchEnd::race_won, winner);
  } else {
    next_rack(match);
  }
}

/// Racks again if everybody who plays has agreed.
void rerack_if_agreed(Match& match) {
  const auto* practice = std::get_if<rules::Practice>(&match.game);
  for (std::size_t seat = 0; seat < match.settings.seats; ++seat) {
    const bool left = practice != nullptr && practice->left[seat];
    if (!left && !match.status.rerack_agreed[seat]) return;
  }
  if (auto* game = std::get_if<rules::EightBall>(&match.game)) {
    *game = rules::eight_ball_start(game->breaker);
  }
  set_up_rack(match);
}

/// A player gives up or is gone: in 8-ball the other one wins, in practice the rest go on.
void leave(Match& match, Seat seat, MatchEnd end) {
  auto* practice = std::get_if<rules::Practice>(&match.game);
  if (practice == nullptr) {
    finish(match, end, rules::other(seat));
    return;
  }
  *practice = without(*practice, seat);
  match.status.rerack_agreed[rules::number(seat)] = false;
  if (std::find(practice->left.begin(), practice->left.end(), false) == practice->left.end()) {
    finish(match, end, std::nullopt);
  } else {
    rerack_if_agreed(match);
  }
}

// ---- Shots

std::optional<std::string> tip_fault(const physics::Scene& scene, const physics::Tip& tip) {
  if (tip == physics::Tip{}) return std::nullopt;
  if (!std::holds_alternative<physics::Spinning>(scene.bed.motion)) {
    return "tip: is off the centre; the balls of this table do not spin, so it must be 0, 0";
  }
  constexpr double limit = physics::miscue_offset;  // NaN is within nothing
  if (tip.side * tip.side + tip.height * tip.height <= limit * limit) return std::nullopt;
  return "tip: is too far off the centre; beyond half a radius the cue slips off the ball";
}

std::optional<Refusal> fault_of(const Match& match, const Shoot& shoot) {
  const double length = physics::length(shoot.direction);
  if (!(length >= 1 - unit_tolerance && length <= 1 + unit_tolerance)) {
    return bad_value("direction: is not a unit vector; its length must be 1 to within 1e-9");
  }
  if (!(shoot.speed_m_s > 0 && shoot.speed_m_s <= max_shot_speed_m_s)) {
    return bad_value("speed: is out of range; it must be above 0 and at most " +
                     std::to_string(static_cast<int>(max_shot_speed_m_s)) + " m/s");
  }
  if (auto fault = tip_fault(match.settings.scene, shoot.tip)) return bad_value(*std::move(fault));
  const auto call_fault = std::visit(
      [&](const auto& game) {
        if constexpr (std::is_same_v<std::decay_t<decltype(game)>, rules::EightBall>) {
          return rules::call_fault(game, match.table, shoot.call);
        } else {
          return rules::call_fault(game, shoot.call);
        }
      },
      match.game);
  if (call_fault) return bad_value(*call_fault);
  const physics::Vec2 from = rules::find(match.table, rules::cue_ball)->position;
  if (!rules::may_play_from(match.settings.scene.bed, match.status.game.ball_in_hand, from)) {
    return Refusal{RefusalCode::not_allowed_now,
                   "the cue ball is in hand; place it behind the head string before shooting"};
  }
  return std::nullopt;
}

Refusal refusal_of(const physics::Stalled& stalled) {
  std::string text = "the shot could not be simulated to its end; it stalled at";
  for (const physics::BallId ball : stalled.balls) {
    text += " ball " + std::to_string(physics::number(ball)) + ",";
  }
  return {RefusalCode::stalled, text + " so try a different one"};
}

void judge_shot(Step& step, const rules::Call& call) {
  Match& next = step.next;
  const physics::Scene& scene = next.settings.scene;
  if (auto* game = std::get_if<rules::EightBall>(&next.game)) {
    rules::EightBallAfter after = judge(*game, scene, next.table, *step.shot, call);
    *game = std::move(after.game);
    next.table = std::move(after.table);
    step.ruling = std::move(after.ruling);
    if (step.ruling->rack_winner) score(next, *step.ruling->rack_winner);
  } else {
    auto& practice = std::get<rules::Practice>(next.game);
    rules::PracticeAfter after = judge(practice, scene, *step.shot);
    practice = std::move(after.game);
    next.table = std::move(after.table);
    step.ruling = std::move(after.ruling);
  }
}

// ---- Commands: each is permitted, but its values have not been looked at

Stepped carry_out(const Match& match, const Author&, const Start&) {
  Step step{match, {}, {}};
  step.next.status.stage = Stage::running;
  next_rack(step.next);
  return step;
}

Stepped carry_out(const Match& match, const Author&, const Place& place) {
  const bool free_choice = match.settings.game == GameKind::practice;
  if (!free_choice && place.ball != rules::cue_ball) {
    return bad_value("ball: only the cue ball, 0, is in hand");
  }
  if (physics::number(place.ball) > 15) {
    return bad_value("ball: there is no ball " + std::to_string(physics::number(place.ball)) +
                     "; balls are 0 to 15");
  }
  if (auto fault = rules::placement_fault(match.settings.scene, match.table, place.ball,
                                          place.position, match.status.game.ball_in_hand)) {
    return bad_value(*fault);
  }
  // Adding zero turns -0 into 0, which have one encoding in a record.
  const physics::Vec2 position{place.position.x + 0.0, place.position.y + 0.0};
  Step step{match, {}, {}};
  step.next.table = rules::with_ball(match.table, place.ball, position);
  return step;
}

Stepped carry_out(const Match& match, const Author&, const Shoot& shoot) {
  if (auto refusal = fault_of(match, shoot)) return *refusal;
  const physics::Vec2 direction{shoot.direction.x + 0.0, shoot.direction.y + 0.0};
  const physics::Tip tip{shoot.tip.side + 0.0, shoot.tip.height + 0.0};
  const physics::Strike strike{rules::cue_ball, direction, shoot.speed_m_s, tip};
  auto result =
      physics::simulate(match.settings.scene, match.table, strike, {match.seed, match.shots},
                        {physics::max_match_events, {}, match.physics});
  if (const auto* stall = std::get_if<physics::Stalled>(&result)) return refusal_of(*stall);
  Step step{match, std::get<physics::Shot>(std::move(result)), {}};
  ++step.next.shots;
  step.next.status.rerack_agreed.assign(match.settings.seats, false);
  judge_shot(step, shoot.call);
  return step;
}

Stepped carry_out(const Match& match, const Author&, const Choose& choice) {
  const auto& options = match.status.game.options;
  if (std::find(options.begin(), options.end(), choice.option) == options.end()) {
    return bad_value("option: is not open; choose one of those that the status lists");
  }
  // Only 8-ball has options.
  const auto& game = std::get<rules::EightBall>(match.game);
  auto after = choose(game, match.settings.scene, match.table, choice.option);
  Step step{match, {}, std::move(after.ruling)};
  step.next.game = std::move(after.game);
  step.next.table = std::move(after.table);
  if (after.rerack) set_up_rack(step.next);
  return step;
}

Stepped carry_out(const Match& match, const Author& author, const Concede&) {
  Step step{match, {}, {}};
  leave(step.next, *author.seat, MatchEnd::conceded);
  return step;
}

Stepped carry_out(const Match& match, const Author& author, const AgreeRerack&) {
  Step step{match, {}, {}};
  step.next.status.rerack_agreed[rules::number(*author.seat)] = true;
  rerack_if_agreed(step.next);
  return step;
}

Stepped carry_out(const Match& match, const Author&, const Abandoned& abandoned) {
  if (!sits(match, abandoned.seat)) {
    return bad_value("seat: nobody sits at " + std::to_string(rules::number(abandoned.seat)));
  }
  Step step{match, {}, {}};
  leave(step.next, abandoned.seat, MatchEnd::abandoned);
  return step;
}

Accepted completed(Step step) {
  Match& next = step.next;
  next.next = Seq{static_cast<std::uint32_t>(next.next) + 1};
  next.status.game = game_status(next);
  Outcome outcome{std::move(step.shot), std::move(step.ruling), next.table, next.status};
  return {std::move(next), std::move(outcome)};
}

}  // namespace

Match created(const Settings& settings, const physics::Seed& seed, std::uint32_t physics) {
  Match match;
  match.settings = settings;
  match.physics = physics;
  match.seed = seed;
  if (settings.game == GameKind::practice) {
    match.game = rules::practice_start(settings.seats);
  } else {
    match.game = rules::eight_ball_start(breaker_of(1));
  }
  match.status.score.assign(settings.seats, 0);
  match.status.rerack_agreed.assign(settings.seats, false);
  match.status.game = game_status(match);
  return match;
}

Result apply(const Match& match, const Ask& ask) {
  if (auto refusal = not_permitted(match, ask)) return *refusal;
  Stepped stepped = std::visit(
      [&](const auto& command) { return carry_out(match, ask.author, command); }, ask.command);
  if (auto* refusal = std::get_if<Refusal>(&stepped)) return std::move(*refusal);
  return completed(std::get<Step>(std::move(stepped)));
}

}  // namespace breakshot::match
