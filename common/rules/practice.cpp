#include "common/rules/practice.hpp"

#include <algorithm>

#include "common/physics/timeline.hpp"
#include "common/rules/groups.hpp"
#include "common/rules/placement.hpp"

namespace breakshot::rules {
namespace {

/// The next seat after `seat` that has not left; `seat` itself if there is no other.
Seat next_after(const std::vector<bool>& left, Seat seat) {
  const std::size_t seats = left.size();
  for (std::size_t step = 1; step <= seats; ++step) {
    const std::size_t candidate = (number(seat) + step) % seats;
    if (!left[candidate]) return Seat{static_cast<std::uint8_t>(candidate)};
  }
  return seat;
}

}  // namespace

Practice practice_start(std::size_t seats) {
  Practice game;
  game.status.ball_in_hand = BallInHand::anywhere;
  game.status.groups.assign(seats, Group::none);
  game.left.assign(seats, false);
  return game;
}

std::optional<std::string> call_fault(const Practice&, const Call& call) {
  if (call == Call{}) return std::nullopt;
  return "call: nothing is called in practice; leave out ball, pocket and safety";
}

Practice without(const Practice& game, Seat seat) {
  Practice next = game;
  next.left[number(seat)] = true;
  if (next.status.turn == seat) next.status.turn = next_after(next.left, seat);
  return next;
}

PracticeAfter judge(const Practice& game, const physics::Scene& scene, const physics::Shot& shot) {
  PracticeAfter after{game, {}, state_after(shot)};
  after.game.status.turn = next_after(game.left, game.status.turn);
  for (const physics::Event& event : shot.events) {
    const auto* drop = std::get_if<physics::BallPocket>(&event);
    if (drop != nullptr) after.ruling.pocketed.push_back(drop->ball);
  }
  if (find(after.table, cue_ball) == nullptr) {
    after.table = with_cue_ball_at_head_spot(scene, after.table);
  }
  return after;
}

}  // namespace breakshot::rules
