// Shots by any method, and one whose contact has a closed form.
#pragma once

#include <array>

#include "common/physics/simulation.hpp"
#include "common/study/simulation.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::support {

struct Setting {
  physics::Scene scene;
  physics::State state;
  std::optional<physics::Strike> strike{};
  physics::ShotSeed seed{};
  physics::Limits limits{};

  study::Simulation under(const study::Method& method,
                          study::Scalar scalar = study::Scalar::double_precision) const {
    return {method, scalar, {scene, state, strike, seed, limits}};
  }
};

/// A shot that must come to its end.
inline physics::Shot shot_by(const study::Method& method, const Setting& setting,
                             study::Scalar scalar = study::Scalar::double_precision) {
  study::Simulation simulation = setting.under(method, scalar);
  EXPECT_EQ(simulation.advance_to(physics::never<double>), physics::Progress::finished);
  return simulation.shot();
}

/// A ball that slides at 2 m/s towards one that lies `distance_m` away, both elastic.
inline Setting head_on(double distance_m) {
  return {cloth(), balls({ball(0, {0, 0}, {2, 0}), ball(1, {distance_m, 0})})};
}

/// When they meet, as long as the ball still slides.
template <class Real>
Real head_on_meeting_s(double distance_m) {
  using std::sqrt;
  const Real deceleration = Real(0.2) * Real(9.81);
  const Real gap = Real(distance_m) - 2 * Real(physics::BallKind{}.radius_m);
  return 2 * gap / (2 + sqrt(4 - 2 * deceleration * gap));
}

/// The mean error of that meeting over many distances.
inline double mean_error_s(const study::Method& method) {
  double sum = 0;
  constexpr int shots = 200;
  for (int i = 0; i < shots; ++i) {
    const double distance_m = 0.4 + 0.1 * i / shots;
    const physics::Shot shot = shot_by(method, head_on(distance_m));
    sum += time_of(shot.events.front()) - head_on_meeting_s<double>(distance_m);
  }
  return sum / shots;
}

/// The break of 16 balls on an 8-foot table, without spin or with all that is modelled.
inline Setting break_shot(bool full) {
  Setting setting;
  setting.scene =
      full ? physics::presets().front().scene
           : table(physics::Straight{0.2, 0.01, 1.0}, physics::CushionRestitution{0.85, 1.0, 1e-3},
                   physics::BallRestitution{});
  setting.state = racked(setting.scene, physics::rack_gap_m);
  setting.strike = physics::Strike{physics::BallId{0}, {1, 0}, 8, {}};
  return setting;
}

inline std::array<study::Method, 4> all_methods(double step_s) {
  return {study::Exact{}, study::FixedStep{step_s}, study::SweptStep{step_s},
          study::Literal{step_s}};
}

}  // namespace breakshot::support
