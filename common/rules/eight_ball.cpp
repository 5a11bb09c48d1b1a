#include "common/rules/eight_ball.hpp"

#include <algorithm>

#include "common/physics/timeline.hpp"
#include "common/rules/eight_ball_break.hpp"
#include "common/rules/groups.hpp"
#include "common/rules/placement.hpp"

namespace breakshot::rules {
namespace {

using physics::BallId;

constexpr std::uint32_t pockets = 6;

template <class T>
bool contains(const std::vector<T>& values, const T& value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

/// In the order in which a referee would name them (WPA 3.9: 6.1, 6.2, 6.3, 6.11).
std::vector<Foul> fouls_of(const GameStatus& status, const physics::State& before,
                           const Facts& facts) {
  std::vector<Foul> fouls;
  const bool scratched = std::any_of(facts.pocketed.begin(), facts.pocketed.end(),
                                     [](const Pocketed& p) { return p.ball == cue_ball; });
  if (scratched) fouls.push_back(Foul::scratch);
  if (!facts.first_hit) fouls.push_back(Foul::no_contact);

  // Of balls hit at the same instant none was first: the shooter has the benefit (Regulations,
  // "split hits").
  const std::vector<BallId> legal = targets(status, before);
  const bool right_ball = std::any_of(facts.first_hits.begin(), facts.first_hits.end(),
                                      [&](BallId ball) { return contains(legal, ball); });
  if (facts.first_hit && !right_ball) fouls.push_back(Foul::wrong_ball_first);
  if (facts.first_hit && facts.pocketed.empty() && !facts.cushion_after_contact) {
    fouls.push_back(Foul::no_rail);
  }
  if (status.ball_in_hand == BallInHand::behind_head_string &&
      !facts.crossed_head_string_before_contact && !facts.first_hit_beyond_head_string) {
    fouls.push_back(Foul::behind_head_string);
  }
  return fouls;
}

/// Whether the called ball dropped into the called pocket. A safety calls neither, so none does.
bool called_shot_made(const Facts& facts, const Call& call) {
  return std::any_of(facts.pocketed.begin(), facts.pocketed.end(), [&](const Pocketed& p) {
    return call.ball == p.ball && call.pocket == p.pocket;
  });
}

/// The 8 was pocketed, not on the break: the rack is over (WPA 3.8 and the object of the game).
void judge_eight(EightBallAfter& after, const physics::State& before, const Facts& facts,
                 const Call& call) {
  const GameStatus& status = after.game.status;
  if (!after.ruling.fouls.empty()) {
    after.ruling.rack_end = RackEnd::foul_on_eight;
  } else if (!contains(targets(status, before), eight_ball_id)) {
    after.ruling.rack_end = RackEnd::eight_too_early;
  } else if (!called_shot_made(facts, call)) {
    after.ruling.rack_end = RackEnd::eight_wrong_pocket;
  } else {
    after.ruling.rack_end = RackEnd::eight_pocketed;
  }
  const bool won = after.ruling.rack_end == RackEnd::eight_pocketed;
  after.ruling.rack_winner = won ? status.turn : other(status.turn);
}

/// Any other shot: who goes on (WPA 3.5), whose the groups are (3.4), ball in hand (3.9).
void judge_play(EightBallAfter& after, const Facts& facts, const Call& call) {
  GameStatus& status = after.game.status;
  const bool foul = !after.ruling.fouls.empty();
  if (foul || !called_shot_made(facts, call)) {
    status.turn = other(status.turn);
    if (foul) status.ball_in_hand = BallInHand::anywhere;
    return;
  }
  Group& group = status.groups[number(status.turn)];
  if (group != Group::none) return;
  group = group_of(call.ball.value());
  status.groups[number(other(status.turn))] = opposite(group);
  after.ruling.group_won = group;
}

std::optional<std::string> ball_fault(const EightBall& game, const physics::State& table,
                                      BallId ball) {
  const std::vector<BallId> callable = targets(game.status, table);
  if (contains(callable, ball)) return std::nullopt;
  std::string text = "call.ball: " + std::to_string(number(ball)) + " cannot be called; one of";
  for (const BallId each : callable) text += " " + std::to_string(number(each));
  return text + " can";
}

}  // namespace

EightBall eight_ball_start(Seat breaker) {
  EightBall game;
  game.breaker = breaker;
  game.status.turn = breaker;
  game.status.breaking = true;
  game.status.ball_in_hand = BallInHand::behind_head_string;
  game.status.groups = {Group::none, Group::none};
  return game;
}

std::optional<std::string> call_fault(const EightBall& game, const physics::State& table,
                                      const Call& call) {
  if (game.status.breaking) {
    if (call == Call{}) return std::nullopt;
    return "call: nothing is called on the break; leave out ball, pocket and safety";
  }
  if (call.safety) {
    if (!call.ball && !call.pocket) return std::nullopt;
    return "call: a safety is called instead of a ball and a pocket, not with them";
  }
  if (!call.ball || !call.pocket) return "call: needs a ball and a pocket, or safety";
  if (number(*call.pocket) >= pockets) {
    return "call.pocket: is " + std::to_string(number(*call.pocket)) + "; pockets are 0 to 5";
  }
  return ball_fault(game, table, *call.ball);
}

EightBallAfter judge(const EightBall& game, const physics::Scene& scene,
                     const physics::State& before, const physics::Shot& shot, const Call& call) {
  const Facts facts = facts_of(scene, before, shot);
  EightBallAfter after{game, {}, state_after(shot), false};
  after.ruling.fouls = fouls_of(game.status, before, facts);
  for (const Pocketed& drop : facts.pocketed) after.ruling.pocketed.push_back(drop.ball);
  if (contains(after.ruling.pocketed, cue_ball)) {
    after.table = with_cue_ball_at_head_spot(scene, after.table);
  }

  after.game.status.ball_in_hand = BallInHand::none;
  if (game.status.breaking) {
    judge_break(after, scene, facts);
  } else if (contains(after.ruling.pocketed, eight_ball_id)) {
    judge_eight(after, before, facts, call);
  } else {
    judge_play(after, facts, call);
  }
  return after;
}

}  // namespace breakshot::rules
