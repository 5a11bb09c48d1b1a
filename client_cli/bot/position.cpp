#include "client_cli/bot/position.hpp"

#include <algorithm>

#include "common/rules/groups.hpp"
#include "common/rules/placement.hpp"

namespace breakshot::bot {
namespace {

using rules::Group;

std::size_t count_of(const physics::State& table, Group group) {
  return static_cast<std::size_t>(
      std::count_if(table.balls.begin(), table.balls.end(),
                    [&](const physics::Ball& ball) { return rules::group_of(ball.id) == group; }));
}

Group group_of(const rules::GameStatus& status, rules::Seat seat) {
  const std::size_t index = rules::number(seat);
  return index < status.groups.size() ? status.groups[index] : Group::none;
}

}  // namespace

std::vector<BallId> targets_of(const Position& position) {
  if (position.game == match::GameKind::eight_ball) {
    return rules::targets(position.status, position.table);
  }
  std::vector<BallId> all;
  for (const auto& ball : position.table.balls) {
    if (ball.id != rules::cue_ball) all.push_back(ball.id);
  }
  return all;
}

std::size_t balls_left(const Position& position, rules::Seat seat) {
  const Group group = group_of(position.status, seat);
  if (group != Group::none) return count_of(position.table, group) + 1;
  return std::min(count_of(position.table, Group::solids),
                  count_of(position.table, Group::stripes)) +
         1;
}

bool can_place(const Position& position, Vec2 place) {
  return !rules::placement_fault(position.scene, position.table, rules::cue_ball, place,
                                 position.status.ball_in_hand);
}

}  // namespace breakshot::bot
