// The rules on shots that the physics played: what the shots made by hand assume does happen.
#include <gtest/gtest.h>

#include "common/physics/simulate.hpp"
#include "tests/rules/eight_ball_positions.hpp"

namespace breakshot::rules {
namespace {

/// The shot from `before` at `speed_m_s` in direction (x, y), judged as a safety of the solids.
EightBallAfter played(const physics::State& before, Vec2 direction, double speed_m_s) {
  const auto result =
      simulate(club_scene(), before, physics::Strike{cue_ball, direction, speed_m_s}, {});
  return judge(solids, club_scene(), before, std::get<physics::Shot>(result), safety);
}

TEST(Played, PressingAFrozenBallIntoItsRailIsAFoul) {
  const auto before = table_of({{0, {1, 0}}, {1, {1.139825, 0}}, {8, {-0.5, 0.3}}});
  EXPECT_EQ(played(before, {1, 0}, 0.3).ruling.fouls, std::vector{Foul::no_rail});
}

TEST(Played, DrivingABallThatIsNotFrozenToTheSameRailIsNone) {
  const auto before = table_of({{0, {1, 0}}, {1, {1.1398, 0}}, {8, {-0.5, 0.3}}});
  EXPECT_TRUE(played(before, {1, 0}, 0.3).ruling.fouls.empty());
}

TEST(Played, ShootingIntoABallThatTouchesTheCueBallHitsIt) {
  const auto before = table_of({{0, {0, 0}}, {1, {0.05715, 0}}, {8, {-0.5, 0.3}}});
  EXPECT_TRUE(played(before, {1, 0}, 3).ruling.fouls.empty());
}

TEST(Played, ShootingAwayFromABallThatTouchesTheCueBallDoesNotHitIt) {
  const auto before = table_of({{0, {0.3, 0}}, {1, {0.35715, 0}}, {8, {-0.5, 0.3}}});
  EXPECT_EQ(played(before, {0, 1}, 0.5).ruling.fouls, std::vector{Foul::no_contact});
}

TEST(Played, AHitOnTwoTouchingBallsAtOnceIsDecidedForTheShooter) {
  // The three centres form a triangle with equal sides: both object balls are met at one instant.
  const double across = 0.05715 * 0.8660254037844386;
  const auto before =
      table_of({{0, {-across, 0}}, {1, {0, 0.028575}}, {9, {0, -0.028575}}, {8, {-0.9, 0.3}}});
  EXPECT_TRUE(played(before, {1, 0}, 4).ruling.fouls.empty());
}

}  // namespace
}  // namespace breakshot::rules
