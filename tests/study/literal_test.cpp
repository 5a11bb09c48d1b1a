// The paper's algorithm as printed, and what is wrong with it.
#include "tests/study/studied.hpp"

namespace breakshot::study {
namespace {

using support::all_of;
using support::ball;
using support::balls;
using support::head_on;
using support::shot_by;

TEST(Literal, BallsCollideAcrossTheGapThatSlowingDownLeaves) {
  const physics::Shot shot = shot_by(Literal{}, head_on(0.5));
  const double predicted_s = (0.5 - 2 * physics::BallKind{}.radius_m) / 2;
  ASSERT_EQ(all_of<physics::BallBall>(shot).size(), 1u);
  EXPECT_NEAR(time_of(shot.events.front()), predicted_s, 1e-15);
  const auto states = physics::Timeline(shot).states(predicted_s);
  const double gap_m =
      states[1].position.x - states[0].position.x - 2 * physics::BallKind{}.radius_m;
  EXPECT_NEAR(gap_m, 0.2 * 9.81 * predicted_s * predicted_s / 2, 1e-15);
}

TEST(Literal, DependsOnTheLengthOfTheFramesAndTendsToTheTruth) {
  const double meeting_s = support::head_on_meeting_s<double>(0.5);
  const double long_frames = time_of(shot_by(Literal{0.25}, head_on(0.5)).events.front());
  const double short_frames = time_of(shot_by(Literal{0.01}, head_on(0.5)).events.front());
  const double tiny_frames = time_of(shot_by(Literal{1e-5}, head_on(0.5)).events.front());
  EXPECT_GT(meeting_s - long_frames, 1e-3);
  EXPECT_LT(meeting_s - short_frames, 1e-4);
  EXPECT_GT(meeting_s - short_frames, 1e-6);
  EXPECT_NEAR(tiny_frames, meeting_s, 1e-9);
}

TEST(Literal, BallsThatStopOnTheWayMeetNobody) {
  physics::Scene slow = support::cloth();
  const support::Setting out_of_reach{slow, balls({ball(0, {0, 0}, {0.1, 0}), ball(1, {0.2, 0})})};
  const physics::Shot shot = shot_by(Literal{}, out_of_reach);
  const auto states = physics::Timeline(shot).states(shot.end_s);
  EXPECT_EQ(states[1].position.x, 0.2);
  EXPECT_NEAR(states[0].position.x, 0.01 / (2 * 0.01 * 9.81), 1e-12);
  EXPECT_TRUE(all_of<physics::BallBall>(shot).empty());
}

TEST(Literal, IsExactWithoutFriction) {
  const support::Setting gas{
      support::table(physics::Frictionless{}, physics::Mirror{}, physics::Elastic{}),
      balls({ball(0, {0, 0}, {1.3, 0.4}), ball(1, {0.4, 0.1}), ball(2, {-0.7, 0.3}, {0.2, -0.9})}),
      {},
      {},
      support::until(2)};
  const physics::Shot exact = shot_by(Exact{}, gas);
  const physics::Shot literal = shot_by(Literal{}, gas);
  ASSERT_EQ(literal.events.size(), exact.events.size());
  for (std::size_t i = 0; i < exact.events.size(); ++i) {
    EXPECT_NEAR(time_of(literal.events[i]), time_of(exact.events[i]), 1e-9) << i;
  }
}

TEST(Literal, DropsBallsIntoPockets) {
  support::Setting setting = support::break_shot(false);
  setting.scene.pockets = physics::StandardPockets{};
  setting.state = balls({ball(0, {0, 0}, {0, 2})});
  const auto drops =
      all_of<physics::BallPocket>(shot_by(Literal{0.01}, {setting.scene, setting.state}));
  ASSERT_EQ(drops.size(), 1u);
  EXPECT_EQ(number(drops[0].pocket), 4u);
}

}  // namespace
}  // namespace breakshot::study
