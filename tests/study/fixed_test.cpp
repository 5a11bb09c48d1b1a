// Constant step, corrective detection.
#include "common/physics/audit.hpp"
#include "tests/study/studied.hpp"

namespace breakshot::study {
namespace {

using support::all_of;
using support::ball;
using support::balls;
using support::head_on;
using support::mean_error_s;
using support::shot_by;

TEST(Fixed, MeetsAtTheEndOfTheStep) {
  const double meeting_s = support::head_on_meeting_s<double>(0.5);
  for (const double step_s : {0.01, 0.003, 1e-4}) {
    const auto met = all_of<physics::BallBall>(shot_by(FixedStep{step_s}, head_on(0.5)));
    ASSERT_EQ(met.size(), 1u);
    EXPECT_GE(met[0].time_s, meeting_s);
    EXPECT_LE(met[0].time_s, meeting_s + step_s);
    EXPECT_EQ(met[0].time_s, step_s * std::round(met[0].time_s / step_s));
  }
}

TEST(Fixed, PutsBackWhatOverlaps) {
  const physics::Shot shot = shot_by(FixedStep{0.01}, head_on(0.5));
  const double met_s = time_of(shot.events.front());
  const physics::Timeline timeline(shot);
  const auto states = timeline.states(met_s);
  EXPECT_NEAR(states[1].position.x - states[0].position.x, 2 * physics::BallKind{}.radius_m, 1e-15);
  EXPECT_GT(states[1].position.x, 0.5);
}

TEST(Fixed, ErrsByTheFirstPowerOfTheStep) {
  for (const double step_s : {1e-2, 1e-3, 1e-4}) {
    EXPECT_NEAR(mean_error_s(FixedStep{step_s}) / step_s, 0.5, 0.1) << step_s;
  }
}

TEST(Fixed, BallsTunnelWhereTheyPassWithinAStep) {
  const support::Setting fast{support::gas(),
                              balls({ball(0, {0, 0}, {8, 0}), ball(1, {1, 0}, {-8, 0})}),
                              {},
                              {},
                              support::until(0.2)};
  EXPECT_EQ(all_of<physics::BallBall>(shot_by(FixedStep{1e-3}, fast)).size(), 1u);
  EXPECT_EQ(all_of<physics::BallBall>(shot_by(FixedStep{0.05}, fast)).size(), 0u);
  EXPECT_EQ(all_of<physics::BallBall>(shot_by(SweptStep{0.05}, fast)).size(), 1u);
}

TEST(Fixed, BallsTunnelThroughACushion) {
  const support::Setting fast{
      support::table(physics::Frictionless{}, physics::Mirror{}, physics::Elastic{}),
      balls({ball(0, {0, 0}, {100, 0})}),
      {},
      {},
      support::until(0.1)};
  EXPECT_GT(all_of<physics::BallCushion>(shot_by(FixedStep{1e-4}, fast)).size(), 3u);
  EXPECT_TRUE(all_of<physics::BallCushion>(shot_by(FixedStep{0.01}, fast)).empty());
  EXPECT_GT(all_of<physics::BallCushion>(shot_by(SweptStep{0.01}, fast)).size(), 3u);
}

}  // namespace
}  // namespace breakshot::study
