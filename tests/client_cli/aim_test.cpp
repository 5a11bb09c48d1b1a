// The geometry of aiming against closed forms.
#include "client_cli/bot/aim.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/physics/table.hpp"

namespace breakshot::bot {
namespace {

using physics::Ball;

constexpr double radius = 0.028575;
constexpr BallId cue{0};

physics::Scene club() {
  physics::Scene scene = physics::presets().front().scene;
  scene.pockets = physics::StandardPockets{};
  return scene;
}

Ball at(std::uint32_t id, double x, double y) {
  return {BallId{id}, {x, y}, {}, {}};
}

void expect_near(Vec2 got, Vec2 wanted) {
  EXPECT_NEAR(got.x, wanted.x, 1e-12);
  EXPECT_NEAR(got.y, wanted.y, 1e-12);
}

TEST(Aim, StraightShotAimsThroughTheBall) {
  const auto aim = aim_of({-1, 0}, {0, 0}, {1, 0}, radius);
  ASSERT_TRUE(aim);
  expect_near(aim->ghost, {-2 * radius, 0});
  expect_near(aim->direction, {1, 0});
  EXPECT_NEAR(aim->cut_cos, 1, 1e-12);
}

TEST(Aim, HalfBallHitCutsByThirtyDegrees) {
  // Aimed at the edge of the ball, the centres stand 2R apart and R beside the line: sin(cut) =
  // 1/2.
  const Vec2 object{0, 0};
  const Vec2 ghost{-std::sqrt(3.0) * radius, radius};
  const Vec2 cue_place = ghost - Vec2{0.5, 0};
  const auto aim = aim_of(cue_place, object, towards(ghost, object), radius);
  ASSERT_TRUE(aim);
  expect_near(aim->ghost, ghost);
  expect_near(aim->direction, {1, 0});
  EXPECT_NEAR(aim->cut_cos, std::sqrt(3.0) / 2, 1e-12);
}

TEST(Aim, NothingCutsByNinetyDegreesOrMore) {
  EXPECT_FALSE(aim_of({0, 1}, {0, 0}, {0, 1}, radius));
  EXPECT_FALSE(aim_of({-1, -2 * radius}, {0, 0}, {0, 1}, radius));
  EXPECT_TRUE(aim_of({-1, -2 * radius - 1e-3}, {0, 0}, {0, 1}, radius));
}

TEST(Aim, OverlappingBallsHaveNoAim) {
  EXPECT_FALSE(aim_of({-radius, 0}, {0, 0}, {1, 0}, radius));
}

TEST(Gates, CornerGateLiesWhereTheContactIsNearerThanTheMouthAllows) {
  const auto gates = gates_of(club());
  ASSERT_EQ(gates.size(), 6u);
  const double reach = 0.1158875 / std::sqrt(2.0);
  const double x = physics::eight_foot_length_m / 2;
  const double y = physics::eight_foot_width_m / 2;
  // Foot-left: towards the foot cushion the centre is a radius away from it, and the contact as far
  // from the corner as the mouth allows.
  expect_near(gates[3].from, {x - radius, y - reach});
  expect_near(gates[3].to, {x - reach, y - radius});
  expect_near(gates[0].from, {-(x - radius), -(y - reach)});
}

TEST(Gates, SideGateIsAsWideAsTheMouth) {
  const auto gates = gates_of(club());
  EXPECT_NEAR(gates[4].to.x - gates[4].from.x, 0.1285875, 1e-12);
  expect_near(gates[4].middle(), {0, physics::eight_foot_width_m / 2 - radius});
  expect_near(gates[1].middle(), {0, -physics::eight_foot_width_m / 2 + radius});
}

TEST(Gates, BetweenJawsTheMouthIsNarrowerByABall) {
  physics::Scene scene = club();
  scene.pockets = physics::JawedPockets{};
  const auto gates = gates_of(scene);
  ASSERT_EQ(gates.size(), 6u);
  const auto width = [&](std::size_t i) { return physics::length(gates[i].to - gates[i].from); };
  EXPECT_NEAR(width(3), 0.1158875 - 2 * radius, 1e-12);
  EXPECT_NEAR(width(4), 0.1285875 - 2 * radius, 1e-12);
  const double inward = 0.1158875 / std::sqrt(8.0);
  expect_near(gates[3].middle(), {physics::eight_foot_length_m / 2 - inward,
                                  physics::eight_foot_width_m / 2 - inward});
  expect_near(gates[1].middle(), {0, -physics::eight_foot_width_m / 2});
}

TEST(Gates, NoPocketsNoGates) {
  physics::Scene scene = club();
  scene.pockets.reset();
  EXPECT_TRUE(gates_of(scene).empty());
}

TEST(Corridor, IsBlockedByABallNearerThanADiameter) {
  const Vec2 from{-0.5, 0};
  const Vec2 to{0.5, 0};
  const auto free_with = [&](double y) {
    return corridor_free({{at(0, -0.5, 0), at(1, 0, y)}}, radius, from, to, cue);
  };
  EXPECT_FALSE(free_with(2 * radius - 1e-9));
  EXPECT_TRUE(free_with(2 * radius + 1e-9));
  EXPECT_FALSE(free_with(0));
}

TEST(Corridor, LeavesOutTheMoverAndTheTarget) {
  const physics::State table{{at(0, -0.5, 0), at(1, 0.5, 0)}};
  EXPECT_FALSE(corridor_free(table, radius, {-0.5, 0}, {0.45, 0}, cue));
  EXPECT_TRUE(corridor_free(table, radius, {-0.5, 0}, {0.45, 0}, cue, BallId{1}));
}

TEST(FirstContact, StopsADiameterFromTheBall) {
  const physics::State table{{at(0, -0.5, 0), at(3, 0.25, 0), at(4, 0.5, 0)}};
  const auto contact = first_contact(club(), table, cue, {1, 0}, 10);
  EXPECT_EQ(contact.ball, BallId{3});
  expect_near(contact.place, {0.25 - 2 * radius, 0});
  expect_near(contact.ball_way, {1, 0});
}

TEST(FirstContact, StopsARadiusFromTheCushion) {
  const physics::State table{{at(0, 0, 0), at(3, -0.25, 0)}};
  const auto contact = first_contact(club(), table, cue, {0, 1}, 10);
  EXPECT_FALSE(contact.ball);
  expect_near(contact.place, {0, physics::eight_foot_width_m / 2 - radius});
  const auto short_of_it = first_contact(club(), table, cue, {0, 1}, 0.1);
  expect_near(short_of_it.place, {0, 0.1});
}

TEST(Image, MirrorsInTheLineThatCentresReach) {
  const physics::CushionSegment cushion{{-1, -0.5}, {1, -0.5}, physics::Mirror{}};
  expect_near(image_in(cushion, radius, {0.3, 0}), {0.3, -1 + 2 * radius});
}

TEST(Image, StandsFurtherOffBehindACushionThatReturnsLess) {
  // From (0, d) by way of the cushion to (x, d): the ball comes in at a slope of vx / vy and leaves
  // at vx / (e vy), so the bounce divides x in the ratio 1 : 1 / e.
  const double e = 0.8;
  const double d = 0.4;
  const double x = 0.9;
  const physics::CushionSegment cushion{
      {-1, -radius}, {1, -radius}, physics::CushionRestitution{e, 1, 1e-3}};
  const Vec2 way = towards({0, d}, image_in(cushion, radius, {x, d}));
  EXPECT_NEAR(way.x / -way.y * d, x / (1 + 1 / e), 1e-12);
}

}  // namespace
}  // namespace breakshot::bot
