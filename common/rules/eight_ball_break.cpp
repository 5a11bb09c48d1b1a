#include "common/rules/eight_ball_break.hpp"

#include <algorithm>

#include "common/physics/table.hpp"
#include "common/rules/groups.hpp"
#include "common/rules/placement.hpp"

namespace breakshot::rules {
namespace {

using physics::Ball;
using physics::BallId;

/// A break that pockets nothing must drive this many object balls to a rail.
constexpr std::size_t least_balls_to_rail = 4;

bool contains(const std::vector<BallId>& balls, BallId ball) {
  return std::find(balls.begin(), balls.end(), ball) != balls.end();
}

/// The balls that may be hit first, if every one of them lies behind the head string; else none.
std::vector<BallId> targets_behind_head_string(const EightBallAfter& after,
                                               const physics::Scene& scene) {
  const double string_x = head_string_x(scene.bed);
  std::vector<BallId> balls = targets(after.game.status, after.table);
  const bool all = std::all_of(balls.begin(), balls.end(), [&](BallId ball) {
    return find(after.table, ball)->position.x < string_x;
  });
  if (!all) balls.clear();
  return balls;
}

/// Gives the player at the table the cue ball behind the head string, and, where WPA 1.5 lets him
/// ask for it, the choice of having a ball spotted.
void give_ball_behind_head_string(EightBallAfter& after, const physics::Scene& scene) {
  GameStatus& status = after.game.status;
  status.ball_in_hand = BallInHand::behind_head_string;
  status.options.clear();
  const Ball* ball = find(after.table, cue_ball);
  if (ball == nullptr || !may_play_from(scene.bed, status.ball_in_hand, ball->position)) {
    after.table = with_cue_ball_at_head_spot(scene, after.table);
  }
  if (!targets_behind_head_string(after, scene).empty()) {
    status.options = {Option::ball_in_hand_behind_head_string, Option::spot_nearest_ball};
  }
}

/// The choices of the opponent after a foul, an illegal break, or both.
std::vector<Option> opponents_options(const Ruling& ruling) {
  std::vector<Option> options;
  if (!contains(ruling.pocketed, cue_ball)) options.push_back(Option::accept_table);
  if (!ruling.fouls.empty()) options.push_back(Option::ball_in_hand_behind_head_string);
  if (ruling.illegal_break) {
    options.push_back(Option::rerack_and_break);
    options.push_back(Option::rerack_opponent_breaks);
  }
  return options;
}

EightBallAfter reracked(Seat breaker, const physics::State& table) {
  return {eight_ball_start(breaker), {}, table, true};
}

void spot(EightBallAfter& after, const physics::Scene& scene, BallId ball) {
  after.table = with_spotted(scene, after.table, ball);
  after.ruling.spotted.push_back(ball);
}

/// Of the balls behind the head string the one nearest to it; of equally near ones the lowest.
void spot_nearest(EightBallAfter& after, const physics::Scene& scene) {
  const std::vector<BallId> balls = targets_behind_head_string(after, scene);
  const auto nearest = std::max_element(balls.begin(), balls.end(), [&](BallId a, BallId b) {
    return find(after.table, a)->position.x < find(after.table, b)->position.x;
  });
  spot(after, scene, *nearest);
}

}  // namespace

void judge_break(EightBallAfter& after, const physics::Scene& scene, const Facts& facts) {
  Ruling& ruling = after.ruling;
  GameStatus& status = after.game.status;
  const Seat opponent = other(status.turn);
  const bool foul = !ruling.fouls.empty();
  const bool object_ball_pocketed = std::any_of(ruling.pocketed.begin(), ruling.pocketed.end(),
                                                [](BallId ball) { return ball != cue_ball; });
  ruling.illegal_break =
      !object_ball_pocketed && facts.object_balls_to_cushion.size() < least_balls_to_rail;
  status.breaking = false;

  if (contains(ruling.pocketed, eight_ball_id)) {
    if (foul) status.turn = opponent;
    status.options = {Option::rerack_and_break, Option::spot_eight};
  } else if (foul || ruling.illegal_break) {
    status.turn = opponent;
    status.options = opponents_options(ruling);
    if (status.options == std::vector{Option::ball_in_hand_behind_head_string}) {
      give_ball_behind_head_string(after, scene);
    }
  } else if (!object_ball_pocketed) {
    status.turn = opponent;
  }
}

EightBallAfter choose(const EightBall& game, const physics::Scene& scene,
                      const physics::State& table, Option option) {
  EightBallAfter after{game, {}, table, false};
  GameStatus& status = after.game.status;
  const bool spotting_was_offered = std::find(status.options.begin(), status.options.end(),
                                              Option::spot_nearest_ball) != status.options.end();
  status.options.clear();
  switch (option) {
    case Option::accept_table:
      break;
    case Option::ball_in_hand_behind_head_string:
      if (!spotting_was_offered) give_ball_behind_head_string(after, scene);
      break;
    case Option::rerack_and_break:
      return reracked(status.turn, table);
    case Option::rerack_opponent_breaks:
      return reracked(other(status.turn), table);
    case Option::spot_eight:
      spot(after, scene, eight_ball_id);
      // Only after a scratch does the choice belong to the breaker's opponent (WPA 3.3 f).
      if (status.turn != game.breaker) give_ball_behind_head_string(after, scene);
      break;
    case Option::spot_nearest_ball:
      spot_nearest(after, scene);
      break;
  }
  return after;
}

}  // namespace breakshot::rules
