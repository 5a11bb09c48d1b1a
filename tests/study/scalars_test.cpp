// The exact method in other numbers.
#include "tests/study/studied.hpp"

namespace breakshot::study {
namespace {

using support::break_shot;
using support::head_on;
using support::shot_by;

WideShot wide_shot(const support::Setting& setting, Scalar scalar) {
  Simulation simulation = setting.under(Exact{}, scalar);
  EXPECT_EQ(simulation.advance_to(physics::never<double>), physics::Progress::finished);
  return simulation.wide_shot();
}

TEST(Scalars, DoubleIsThePhysicsBitForBit) {
  for (const bool full : {false, true}) {
    const support::Setting s = break_shot(full);
    const auto outcome = physics::simulate(s.scene, s.state, s.strike, s.seed, s.limits);
    EXPECT_EQ(shot_by(Exact{}, s), std::get<physics::Shot>(outcome));
  }
}

TEST(Scalars, ReferenceHasTheClosedFormToAlmostAllOfItsDigits) {
  const WideShot shot = wide_shot(head_on(0.5), Scalar::reference);
  const Reference wrong = time_of(shot.events.front()) - support::head_on_meeting_s<Reference>(0.5);
  EXPECT_LT(abs(wrong), Reference("1e-49"));
}

/// How far the first contacts of a break are from those of the reference, s.
double worst_time_error_s(Scalar scalar, const WideShot& reference) {
  const WideShot shot = wide_shot(break_shot(true), scalar);
  constexpr std::size_t first_contacts = 8;
  Reference worst = 0;
  for (std::size_t i = 0; i < first_contacts; ++i) {
    EXPECT_EQ(shot.events[i].index(), reference.events[i].index());
    const Reference wrong = abs(time_of(shot.events[i]) - time_of(reference.events[i]));
    worst = std::max(worst, wrong);
  }
  return static_cast<double>(worst);
}

TEST(Scalars, ErrByTheirDigitsAndAgreeOnTheFirstContacts) {
  const WideShot reference = wide_shot(break_shot(true), Scalar::reference);
  const double in_float = worst_time_error_s(Scalar::single_precision, reference);
  const double in_double = worst_time_error_s(Scalar::double_precision, reference);
  const double in_long_double = worst_time_error_s(Scalar::long_double, reference);
  EXPECT_LT(in_float, 1e-3);
  EXPECT_GT(in_float, 1e-10);
  EXPECT_LT(in_double, 1e-12);
  EXPECT_GT(in_double, 1e-19);
  EXPECT_LE(in_long_double, in_double);
}

TEST(Scalars, RunEveryModelAndManyBalls) {
  support::Setting gas{support::gas(), {}, {}, {}, support::until(1)};
  for (std::uint32_t k = 0; k < physics::most_balls_at_a_table + 8; ++k) {
    const std::uint32_t row = k / 6;
    gas.state.balls.push_back(
        support::ball(k, {0.1 * (k % 6), 0.1 * row}, {k % 2 ? 0.3 : -0.3, k % 3 ? 0.2 : -0.1}));
  }
  for (const Scalar scalar : {Scalar::single_precision, Scalar::double_precision,
                              Scalar::long_double, Scalar::reference}) {
    EXPECT_GT(support::all_of<physics::BallBall>(shot_by(Exact{}, gas, scalar)).size(), 10u);
    EXPECT_GT(shot_by(Exact{}, break_shot(true), scalar).events.size(), 50u);
  }
}

}  // namespace
}  // namespace breakshot::study
