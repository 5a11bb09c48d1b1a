// What holds for every method.
#include "common/physics/audit.hpp"
#include "tests/study/studied.hpp"

namespace breakshot::study {
namespace {

using support::break_shot;
using support::shot_by;

TEST(Method, SlicesChangeNoBit) {
  support::Setting setting = break_shot(false);
  for (const Method& method : support::all_methods(2e-3)) {
    const physics::Shot whole = shot_by(method, setting);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      support::Chance chance(seed);
      Simulation sliced = setting.under(method);
      for (double t = 0; t < 4; t += chance.between(0, 0.1)) sliced.advance_to(t);
      sliced.advance_to(physics::never<double>);
      EXPECT_EQ(sliced.shot(), whole) << "method " << method.index() << ", seed " << seed;
    }
  }
}

TEST(Method, NeverAddsEnergyAndAlwaysEnds) {
  for (const bool full : {false, true}) {
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      support::Setting setting = break_shot(full);
      setting.scene.perturbation = physics::Perturbation{0.01, 0.01};
      setting.seed = support::seed_of(seed);
      for (const Method& method : support::all_methods(1e-3)) {
        if (refusal_of(method, setting.scene)) continue;
        const physics::Shot shot = shot_by(method, setting);
        EXPECT_EQ(shot.stop, physics::Stop::rest);
        const physics::Audit audit = physics::audit(setting.scene, shot);
        EXPECT_LT(audit.worst_rise_J, 1e-12 * audit.energy_start_J)
            << "method " << method.index() << ", seed " << seed;
        EXPECT_EQ(audit.energy_end_J, 0);
      }
    }
  }
}

TEST(Method, StopsAtTheEventLimitAndAtTheHorizon) {
  for (const Method& method : support::all_methods(1e-3)) {
    support::Setting setting = break_shot(false);
    setting.limits.max_events = 3;
    Simulation simulation = setting.under(method);
    EXPECT_EQ(simulation.advance_to(physics::never<double>), physics::Progress::stalled);
    EXPECT_TRUE(std::holds_alternative<physics::Stalled>(std::move(simulation).take()));
    setting.limits = support::until(0.3);
    const physics::Shot shot = shot_by(method, setting);
    EXPECT_EQ(shot.end_s, 0.3);
    EXPECT_EQ(shot.stop, physics::Stop::horizon);
  }
}

/// Sets of contacts are resolved by the same code: a cradle passes a stroke on by every method.
TEST(Method, ARowOfTouchingBallsPassesTheStrokeOn) {
  support::Setting row{support::gas(), {}, {}, {}, support::until(1)};
  const double diameter_m = 2 * row.scene.ball.radius_m;
  row.state.balls.push_back(support::ball(0, {-0.2, 0}, {1, 0}));
  for (std::uint32_t k = 1; k < 5; ++k) {
    row.state.balls.push_back(support::ball(k, {(k - 1) * diameter_m, 0}));
  }
  for (const Method& method : support::all_methods(1e-3)) {
    const physics::Shot shot = shot_by(method, row);
    const auto states = physics::Timeline(shot).states(shot.end_s);
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_NEAR(states[k].velocity.x, k == 4 ? 1 : 0, 1e-9) << "method " << method.index();
    }
  }
}

TEST(Method, LiteralKnowsOnlyThePapersScenes) {
  physics::Scene scene = physics::presets().front().scene;
  EXPECT_EQ(refusal_of(Literal{}, scene)->field, "scene.bed.motion.spinning");
  EXPECT_EQ(refusal_of(Exact{}, scene), std::nullopt);
  scene.bed.motion = physics::Straight{};
  EXPECT_EQ(refusal_of(Literal{}, scene)->field, "scene.pockets.jawed");
  scene.pockets.reset();
  EXPECT_EQ(refusal_of(Literal{}, scene), std::nullopt);
  scene.cushions = physics::FreeCushions{{}, {{{0, 0}, 1, {1, 0}, {0, 1}, physics::Mirror{}}}};
  EXPECT_EQ(refusal_of(Literal{}, scene)->field, "scene.cushions.arcs");
}

TEST(Method, NamesAStepOutOfRange) {
  const physics::Scene scene = support::cloth();
  for (const double step_s : {0.0, -1.0, 1e-10, 1e4, std::nan("")}) {
    EXPECT_EQ(refusal_of(FixedStep{step_s}, scene)->field, "dt") << step_s;
    EXPECT_EQ(refusal_of(SweptStep{step_s}, scene)->field, "dt") << step_s;
    EXPECT_EQ(refusal_of(Literal{step_s}, scene)->field, "dt") << step_s;
  }
  EXPECT_EQ(refusal_of(FixedStep{1e-9}, scene), std::nullopt);
}

}  // namespace
}  // namespace breakshot::study
