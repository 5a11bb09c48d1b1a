// Constant step, continuous detection inside it.
#include "tests/study/studied.hpp"

namespace breakshot::study {
namespace {

using support::all_of;
using support::ball;
using support::balls;
using support::mean_error_s;
using support::shot_by;

TEST(Swept, ErrsByTheSecondPowerOfTheStep) {
  // The mean of a chord's distance from a parabola is a dt^2 / 12; v at the meeting is 1.3 to 1.6.
  for (const double step_s : {1e-2, 1e-3, 1e-4}) {
    EXPECT_NEAR(mean_error_s(SweptStep{step_s}) / (step_s * step_s), 1.962 / 12 / 1.45, 0.03)
        << step_s;
  }
}

TEST(Swept, IsExactWithoutFriction) {
  support::Setting gas{
      support::table(physics::Frictionless{}, physics::Mirror{}, physics::Elastic{}),
      balls({ball(0, {0, 0}, {1.3, 0.4}), ball(1, {0.4, 0.1}), ball(2, {-0.7, 0.3}, {0.2, -0.9})}),
      {},
      {},
      support::until(2)};
  const physics::Shot exact = shot_by(Exact{}, gas);
  const physics::Shot swept = shot_by(SweptStep{0.01}, gas);
  ASSERT_EQ(swept.events.size(), exact.events.size());
  EXPECT_GE(exact.events.size(), 4u);
  for (std::size_t i = 0; i < exact.events.size(); ++i) {
    EXPECT_EQ(swept.events[i].index(), exact.events[i].index());
    EXPECT_NEAR(time_of(swept.events[i]), time_of(exact.events[i]), 1e-9) << i;
  }
}

/// A ball with follow is pressed against the one that it has met; the object ball escapes it in the
/// end, and at no time is it overtaken.
TEST(Swept, MeetsWhatIsPressedTogetherWithinAStep) {
  physics::Scene scene = support::cloth();
  scene.bed.motion = physics::Spinning{};
  scene.ball_ball = physics::BallRestitution{};
  const support::Setting follow{scene, balls({ball(0, {0, 0}), ball(1, {0.1, 0})}),
                                physics::Strike{physics::BallId{0}, {1, 0}, 1, {0, 0.4}}};
  for (const double step_s : {0.02, 1e-3}) {
    const physics::Shot shot = shot_by(SweptStep{step_s}, follow);
    EXPECT_GT(all_of<physics::BallBall>(shot).size(), 0u);
    const physics::Timeline timeline(shot);
    for (double t = 0; t < shot.end_s; t += 0.01) {
      const auto states = timeline.states(t);
      EXPECT_GT(states[1].position.x - states[0].position.x,
                2 * physics::BallKind{}.radius_m - 4 * step_s * step_s)
          << step_s << " at " << t;
    }
  }
}

}  // namespace
}  // namespace breakshot::study
