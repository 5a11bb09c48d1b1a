#include "client_cli/bot/evaluate.hpp"

#include <algorithm>

#include "client_cli/bot/prospect.hpp"
#include "common/physics/simulate.hpp"
#include "common/rules/eight_ball.hpp"
#include "common/rules/facts.hpp"
#include "common/rules/groups.hpp"
#include "common/rules/placement.hpp"
#include "common/rules/practice.hpp"

namespace breakshot::bot {
namespace {

/// What a rack that is still to be broken is worth to the one who breaks it.
constexpr double break_value = 0.2;
/// What one ball more or less to pocket than the opponent is worth.
constexpr double ball_value = 0.03;
/// What a ball pocketed in practice is worth, and the cue ball pocketed.
constexpr double practice_ball_value = 0.1;
constexpr double practice_scratch_value = -0.3;

/// Who breaks is not public and makes no difference to the worth of a shot.
rules::EightBall game_of(const Position& position) {
  return {position.status.turn, position.status};
}

double value_for(rules::Seat me, const Position& position, const rules::EightBallAfter& after) {
  if (after.ruling.rack_winner) return *after.ruling.rack_winner == me ? 1 : -1;
  const double sign = after.game.status.turn == me ? 1 : -1;
  if (after.rerack) return sign * break_value;
  const Position next{position.game, position.scene, after.table, after.game.status};
  const double ahead = static_cast<double>(balls_left(next, rules::other(me))) -
                       static_cast<double>(balls_left(next, me));
  return sign * prospect_of(next) + ball_value * ahead;
}

/// The call that makes the most of what is seen to happen.
rules::Call call_for(const Position& position, const rules::Call& intended,
                     const std::vector<rules::Pocketed>& pocketed) {
  if (position.status.breaking || position.game == match::GameKind::practice) return {};
  const auto targets = targets_of(position);
  std::optional<rules::Call> other;
  for (const auto& drop : pocketed) {
    if (drop.ball == intended.ball) return {drop.ball, drop.pocket, false};
    const bool mine = std::find(targets.begin(), targets.end(), drop.ball) != targets.end();
    if (mine && !other) other = rules::Call{drop.ball, drop.pocket, false};
  }
  if (other) return *other;
  return {std::nullopt, std::nullopt, true};
}

/// Practice knows no fouls: what dropped counts, and how the table lies for the next shot.
double practice_value(const Position& position, const physics::Shot& shot) {
  const std::vector<bool> nobody_left(position.status.groups.size());
  const auto after =
      rules::judge(rules::Practice{position.status, nobody_left}, position.scene, shot);
  double value = 0;
  for (const BallId ball : after.ruling.pocketed) {
    value += ball == rules::cue_ball ? practice_scratch_value : practice_ball_value;
  }
  const Position next{position.game, position.scene, after.table, after.game.status};
  return value + prospect_of(next);
}

}  // namespace

std::optional<Trial> try_out(const Position& position, const Candidate& candidate,
                             const std::optional<rules::Call>& call,
                             const physics::ShotSeed& seed) {
  const physics::State before =
      candidate.place ? rules::with_ball(position.table, rules::cue_ball, *candidate.place)
                      : position.table;
  const physics::Strike strike{rules::cue_ball, candidate.direction, candidate.speed_m_s};
  physics::Limits limits;
  limits.max_events = physics::max_match_events;
  const auto result = physics::simulate(position.scene, before, strike, seed, limits);
  const auto* shot = std::get_if<physics::Shot>(&result);
  if (shot == nullptr) return std::nullopt;
  if (position.game == match::GameKind::practice) {
    return Trial{{}, practice_value(position, *shot)};
  }
  const auto facts = rules::facts_of(position.scene, before, *shot);
  const rules::Call made = call ? *call : call_for(position, candidate.intended, facts.pocketed);
  const auto after = rules::judge(game_of(position), position.scene, before, *shot, made);
  return Trial{made, value_for(position.status.turn, position, after)};
}

double value_of(const Position& position, rules::Option option) {
  const auto after = rules::choose(game_of(position), position.scene, position.table, option);
  return value_for(position.status.turn, position, after);
}

bool is_chancy(const physics::Scene& scene) {
  return scene.perturbation && (scene.perturbation->ball > 0 || scene.perturbation->cushion > 0);
}

}  // namespace breakshot::bot
