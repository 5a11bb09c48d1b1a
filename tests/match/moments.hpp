// Moments of a match of 8-ball from which its tests go on.
#pragma once

#include "common/rules/groups.hpp"
#include "tests/support/match_fold.hpp"

namespace breakshot::match {

using physics::BallId;
using physics::PocketId;
using physics::Vec2;
using rules::BallInHand;
using rules::Group;
using support::after;
using support::ask;
using support::eight_ball_settings;
using support::refusal;
using support::seat;
using support::started;
using support::table_of;
using support::the_server;

inline constexpr Shoot hard_break{{1, 0}, 9, {}};
inline constexpr rules::Call safety{{}, {}, true};

inline Vec2 cue_position(const Match& match) {
  return rules::find(match.table, rules::cue_ball)->position;
}

/// A running match at some later moment: seat 0 is to shoot, with these groups and balls.
inline Match in_play(const physics::State& table, Group group_of_0, std::uint32_t race_to = 1) {
  Match match = started(eight_ball_settings(race_to));
  auto& game = std::get<rules::EightBall>(match.game);
  game.status.breaking = false;
  game.status.ball_in_hand = BallInHand::none;
  game.status.groups = {group_of_0, rules::opposite(group_of_0)};
  match.status.game = game.status;
  match.table = table;
  return match;
}

/// The 8 lies before the foot-left pocket with the cue ball behind it: a stop shot wins.
inline Match at_the_winning_shot(std::uint32_t race_to = 1) {
  return in_play(table_of({{0, {0.7, 0.1442}}, {8, {0.9, 0.3442}}, {9, {-0.5, 0}}}), Group::solids,
                 race_to);
}
inline const double diagonal = 0.70710678118654752;
inline const Shoot winning_shot{{diagonal, diagonal}, 2, {BallId{8}, PocketId{3}, false}};

}  // namespace breakshot::match
