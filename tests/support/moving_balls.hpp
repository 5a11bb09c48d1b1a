// Balls at the instant of a contact: random ones, their energy, mirrored and turned.
#pragma once

#include <cmath>

#include "common/physics/impact.hpp"
#include "tests/support/chance.hpp"

namespace breakshot::support {

using Ball = physics::Moving<double>;

/// Of one kilogram, J: translation and 1/2 2/5 R^2 w^2.
inline double energy_of(const Ball& ball, double radius_m) {
  return physics::dot(ball.velocity, ball.velocity) / 2 +
         radius_m * radius_m / 5 * physics::dot(ball.spin, ball.spin);
}

/// The speed whose energy the difference has, m/s.
inline double difference(const Ball& a, const Ball& b, double radius_m) {
  const Ball between{a.velocity - b.velocity, a.spin - b.spin};
  return std::sqrt(2 * energy_of(between, radius_m));
}

/// Of any speed from `slowest` to `fastest`, spins as fast as speeds; now and then without one of
/// them, or rolling.
inline Ball random_ball(Chance& chance, double radius_m, double slowest, double fastest) {
  const auto size = [&] { return slowest * std::pow(fastest / slowest, chance.between(0, 1)); };
  const auto part = [&](double most) { return chance.between(-most, most); };
  const double speed = size();
  const double turn = chance.below(3) == 0 ? speed : size();
  Ball ball{{part(speed), part(speed)},
            {part(turn) / radius_m, part(turn) / radius_m, part(turn) / radius_m}};
  switch (chance.below(6)) {
    case 0:
      ball.spin = {};
      break;
    case 1:
      ball.velocity.x = 0;
      break;
    case 2:
      ball.spin = {-ball.velocity.y / radius_m, ball.velocity.x / radius_m, ball.spin.z};
      break;
    default:
      break;
  }
  return ball;
}

/// Mirrored at the plane x = 0; spins are axial.
inline Ball mirrored(const Ball& ball) {
  return {{-ball.velocity.x, ball.velocity.y}, {ball.spin.x, -ball.spin.y, -ball.spin.z}};
}

inline physics::Vec2 turned(physics::Vec2 v, physics::Vec2 by) {
  return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x};
}

/// Turned about the vertical by the direction of a unit vector.
inline Ball turned(const Ball& ball, physics::Vec2 by) {
  const physics::Vec2 axis = turned(physics::Vec2{ball.spin.x, ball.spin.y}, by);
  return {turned(ball.velocity, by), {axis.x, axis.y, ball.spin.z}};
}

}  // namespace breakshot::support
