// Random scenes over every combination of models, from a seed: what the engine and the reference
// are compared on.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tests/support/scenes.hpp"

namespace breakshot::support {

struct RandomScene {
  physics::Scene scene;
  physics::State state;
  double horizon_s = 0;
  std::string models;  ///< for people
};

/// How many combinations of models there are; `seed % model_combinations` chooses one.
inline constexpr std::uint32_t model_combinations = 3 * 4 * (1 + 5 * 3);

inline RandomScene random_scene(std::uint32_t seed) {
  Chance chance(seed);
  const std::uint32_t choice = seed % model_combinations;
  const std::uint32_t motion = choice % 3;
  const std::uint32_t pair = choice / 3 % 4;
  const std::uint32_t rails = choice / 12;
  RandomScene random;
  physics::Scene& scene = random.scene;
  const std::array<physics::Motion, 3> motions{
      physics::Frictionless{}, physics::Straight{0.2, 0.01, chance.between(0, 2)},
      physics::Spinning{0.2, chance.between(0.005, 0.02), 0.0127}};
  const std::array<physics::BallBallModel, 4> pairs{physics::Elastic{}, physics::BallRestitution{},
                                                    physics::BallFriction{},
                                                    physics::Mathavan2014{}};
  const std::array<physics::CushionModel, 5> cushions{
      physics::Mirror{}, physics::CushionRestitution{0.85, 0.9, 1e-3}, physics::Han2005{},
      physics::Mathavan2010{}, physics::Stronge2000{}};
  const std::array<const char*, 3> motion_names{"frictionless", "straight", "spinning"};
  const std::array<const char*, 4> pair_names{"elastic", "restitution", "frictional",
                                              "mathavan2014"};
  const std::array<const char*, 5> cushion_names{"mirror", "restitution", "han2005", "mathavan2010",
                                                 "stronge2000"};
  scene.gravity_m_s2 = 9.81;
  scene.bed = {motions[motion], physics::eight_foot_length_m, physics::eight_foot_width_m};
  scene.ball_ball = pairs[pair];
  random.models = std::string(motion_names[motion]) + ", " + pair_names[pair];
  if (rails > 0) {
    const std::uint32_t model = (rails - 1) % 5;
    const std::uint32_t pockets = (rails - 1) / 5;
    scene.cushions = physics::RectangleCushions{cushions[model]};
    if (pockets == 1) scene.pockets = physics::StandardPockets{};
    if (pockets == 2) scene.pockets = physics::JawedPockets{};
    random.models += std::string(", ") + cushion_names[model] +
                     (pockets == 0   ? ""
                      : pockets == 1 ? ", standard"
                                     : ", jawed");
  }
  if (chance.below(4) == 0) scene.perturbation = physics::Perturbation{1e-3, 1e-3};

  // Either all balls move, or one does.
  const bool all_move = chance.coin();
  const std::size_t count = 2 + chance.below(15);
  const double fastest = chance.between(0.5, 8);
  while (random.state.balls.size() < count) {
    physics::Ball ball{physics::BallId{static_cast<std::uint32_t>(random.state.balls.size())},
                       {chance.between(-1.1, 1.1), chance.between(-0.55, 0.55)},
                       {},
                       {}};
    if (all_move || random.state.balls.empty()) {
      ball.velocity = {chance.between(-fastest, fastest), chance.between(-fastest, fastest)};
      const double spin = motion == 2 ? 2 * fastest / 0.028575 : 0;
      ball.spin = {chance.between(-spin, spin), chance.between(-spin, spin),
                   chance.between(-spin, spin)};
    }
    random.state.balls.push_back(ball);
    if (!physics::faults_of(scene, random.state).empty()) random.state.balls.pop_back();
  }
  random.horizon_s = motion == 0 ? chance.between(0.5, 3) : 60;
  return random;
}

}  // namespace breakshot::support
