// Errors against the reference.
#include "common/study/compare.hpp"
#include "tests/study/studied.hpp"

namespace breakshot::study {
namespace {

using support::ball;
using support::balls;

WideShot wide(const support::Setting& setting, const Method& method = Exact{},
              Scalar scalar = Scalar::double_precision) {
  Simulation simulation = setting.under(method, scalar);
  simulation.advance_to(physics::never<double>);
  return simulation.wide_shot();
}

TEST(Compare, AShotIsNoDistanceFromItself) {
  const support::Setting setting = support::break_shot(true);
  const WideShot shot = wide(setting);
  const Comparison same = compare(shot, shot, setting.scene, physics::BallId{0});
  EXPECT_TRUE(same.outcome());
  EXPECT_EQ(same.energy, 0);
  EXPECT_EQ(same.end.balls, 16u);
  EXPECT_EQ(same.end.wrong, 0u);
  EXPECT_GE(same.contacts[0].balls, 14u);
  for (const ContactErrors& errors : same.contacts) {
    EXPECT_EQ(errors.wrong, 0u);
    for (const double error : errors.times_s) EXPECT_EQ(error, 0);
    for (const double error : errors.positions_m) EXPECT_EQ(error, 0);
  }
}

/// The step ends after the contact: late by a known time, too deep by the way since.
TEST(Compare, KnowsHowLateAndHowDeepAFixedStepIs) {
  const support::Setting setting = support::head_on(0.5);
  const double meeting_s = support::head_on_meeting_s<double>(0.5);
  const double step_s = meeting_s * 1.01;
  const Comparison late = compare(wide(setting, FixedStep{step_s}),
                                  wide(setting, Exact{}, Scalar::reference), setting.scene, {});
  ASSERT_EQ(late.contacts[0].times_s.size(), 2u);
  EXPECT_NEAR(late.contacts[0].times_s[0], meeting_s * 0.01, 1e-15);
  const double speed_m_s = 2 - 0.2 * 9.81 * step_s;
  EXPECT_NEAR(late.overlap_m, speed_m_s * meeting_s * 0.01, 1e-4);
  EXPECT_NEAR(late.contacts[0].positions_m[0], late.overlap_m / 2, 1e-12);
  EXPECT_LT(late.energy, 1e-12);  // the stroke is passed on whole, and slows down as before
  EXPECT_TRUE(late.outcome());
}

TEST(Compare, CountsWhatIsMissedAndAllThatFollowsAsWrong) {
  const support::Setting setting{
      support::table(physics::Frictionless{}, physics::Mirror{}, physics::Elastic{}),
      balls({ball(0, {-0.9, 0}, {8, 0}), ball(1, {-0.3, 0}, {-8, 0})}),
      {},
      {},
      support::until(0.3)};
  const WideShot truth = wide(setting);
  const Comparison missed =
      compare(wide(setting, FixedStep{0.05}), truth, setting.scene, physics::BallId{0});
  EXPECT_EQ(missed.contacts[0].balls, 2u);
  EXPECT_EQ(missed.contacts[0].wrong, 2u);
  EXPECT_EQ(missed.contacts[1].wrong, missed.contacts[1].balls);
  EXPECT_TRUE(missed.contacts[0].times_s.empty());
  EXPECT_FALSE(missed.first_contact);
  EXPECT_FALSE(missed.outcome());
}

TEST(Compare, ManyHopsOfAPushAreOneContact) {
  physics::Scene scene = support::cloth();
  scene.bed.motion = physics::Spinning{};
  scene.ball_ball = physics::BallRestitution{};
  const support::Setting push{scene,
                              balls({ball(0, {0, 0}), ball(1, {0.1, 0}), ball(2, {0.15715, 0})}),
                              physics::Strike{physics::BallId{0}, {1, 0}, 1, {0, 0.4}}};
  const WideShot shot = wide(push);
  const Comparison same = compare(shot, shot, push.scene, physics::BallId{0});
  EXPECT_GT(shot.events.size(), 100u);
  EXPECT_LT(same.contacts[most_contacts - 1].balls, 3u);
}

}  // namespace
}  // namespace breakshot::study
