// Games and tables of 8-ball from which its tests shoot.
#pragma once

#include "common/rules/eight_ball.hpp"
#include "common/rules/groups.hpp"
#include "tests/support/shot_builder.hpp"

namespace breakshot::rules {

using physics::BallId;
using physics::PocketId;
using physics::Vec2;
using support::club_scene;
using support::ShotBuilder;
using support::table_of;

inline constexpr Seat shooter{0};
inline constexpr Seat opponent{1};
inline constexpr Call safety{{}, {}, true};

constexpr Call call_of(std::uint32_t ball, std::uint8_t pocket) {
  return {BallId{ball}, PocketId{pocket}, false};
}

inline EightBall game_of(Group shooters) {
  EightBall game = eight_ball_start(shooter);
  game.status.breaking = false;
  game.status.ball_in_hand = BallInHand::none;
  game.status.groups = {shooters, opposite(shooters)};
  return game;
}
inline const EightBall open_table = game_of(Group::none);
inline const EightBall solids = game_of(Group::solids);

/// Solids 1 and 2, stripes 9 and 10, the 8.
inline physics::State table() {
  return table_of({{0, {0, 0}},
                   {1, {0.5, 0.1}},
                   {2, {0.5, -0.2}},
                   {8, {0.3, 0.3}},
                   {9, {-0.5, 0.2}},
                   {10, {-0.5, -0.2}}});
}
/// The shooter's group is cleared: he is at the 8.
inline physics::State at_the_eight() {
  return table_of({{0, {0, 0}}, {8, {0.3, 0.3}}, {9, {-0.5, 0.2}}});
}
inline EightBallAfter after(const EightBall& game, const physics::State& before,
                            const ShotBuilder& shot, const Call& call) {
  return judge(game, club_scene(), before, shot.shot(), call);
}
inline EightBallAfter after(const EightBall& game, const ShotBuilder& shot, const Call& call) {
  return after(game, table(), shot, call);
}
inline ShotBuilder hit_first(std::uint32_t ball) {
  return ShotBuilder(table()).hits(0.5, 0, ball);
}

inline EightBallAfter eight_shot(const ShotBuilder& shot, const Call& call) {
  return after(solids, at_the_eight(), shot, call);
}
inline ShotBuilder hit_eight() {
  return ShotBuilder(at_the_eight()).hits(0.5, 0, 8);
}

}  // namespace breakshot::rules
