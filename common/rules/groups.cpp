#include "common/rules/groups.hpp"

#include <algorithm>

namespace breakshot::rules {

Group group_of(physics::BallId ball) {
  if (ball == cue_ball || ball == eight_ball_id) return Group::none;
  return ball < eight_ball_id ? Group::solids : Group::stripes;
}

Group opposite(Group group) {
  if (group == Group::none) return Group::none;
  return group == Group::solids ? Group::stripes : Group::solids;
}

const physics::Ball* find(const physics::State& table, physics::BallId ball) {
  const auto found = std::find_if(table.balls.begin(), table.balls.end(),
                                  [&](const physics::Ball& b) { return b.id == ball; });
  return found == table.balls.end() ? nullptr : &*found;
}

std::vector<physics::BallId> targets(const GameStatus& status, const physics::State& table) {
  const Group group = status.groups[number(status.turn)];
  std::vector<physics::BallId> result;
  for (const physics::Ball& ball : table.balls) {
    if (ball.id == cue_ball) continue;
    const Group of_ball = group_of(ball.id);
    const bool in_group = of_ball != Group::none && (group == Group::none || of_ball == group);
    if (status.breaking || in_group) result.push_back(ball.id);
  }
  if (result.empty() && find(table, eight_ball_id) != nullptr) result.push_back(eight_ball_id);
  return result;
}

}  // namespace breakshot::rules
