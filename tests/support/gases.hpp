// Gases: many balls that move at random, without friction, in a box or on endless cloth.
#pragma once

#include <cmath>
#include <cstdint>

#include "common/physics/scene.hpp"
#include "tests/support/chance.hpp"

namespace breakshot::support {

struct Gas {
  physics::Scene scene;
  physics::State state;
};

/// `count` elastic balls, frictionless, that cover the share `cover` of a nearly square box with
/// mirrors round it: one in each square of a grid, anywhere in it; speeds up to 1 m/s along each
/// axis.
inline Gas gas_in_a_box(std::size_t count, double cover, std::uint64_t seed) {
  Chance chance(seed);
  Gas gas;
  const double radius = gas.scene.ball.radius_m;
  const double square = 2 * radius * std::sqrt(0.78539816339744831 / cover);
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const std::size_t rows = (count + columns - 1) / columns;
  gas.scene.bed = {physics::Frictionless{}, square * static_cast<double>(columns),
                   square * static_cast<double>(rows)};
  gas.scene.cushions = physics::RectangleCushions{physics::Mirror{}};
  gas.scene.ball_ball = physics::Elastic{};
  const double play = 0.999 * (square / 2 - radius);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t row = k / columns;
    const physics::Vec2 middle{
        (static_cast<double>(k % columns) + 0.5) * square - *gas.scene.bed.length_m / 2,
        (static_cast<double>(row) + 0.5) * square - *gas.scene.bed.width_m / 2};
    physics::Ball ball;
    ball.id = physics::BallId{static_cast<std::uint32_t>(k)};
    ball.position =
        middle + physics::Vec2{chance.between(-play, play), chance.between(-play, play)};
    ball.velocity = {chance.between(-1, 1), chance.between(-1, 1)};
    gas.state.balls.push_back(ball);
  }
  return gas;
}

}  // namespace breakshot::support
