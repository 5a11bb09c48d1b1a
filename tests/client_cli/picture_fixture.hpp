// Pictures to draw in tests.
#pragma once

#include "client_cli/draw/picture.hpp"
#include "common/physics/table.hpp"

namespace breakshot::client {

inline const physics::Scene& default_scene() {
  return physics::presets().front().scene;
}

/// The empty default table.
inline Picture empty_picture() {
  Picture picture;
  picture.table = table_of(default_scene());
  return picture;
}

inline DrawnBall ball_at(std::uint32_t id, physics::Vec2 position, physics::Vec2 velocity = {}) {
  return {physics::BallId{id}, position, velocity, 1};
}

/// Cue ball on the head spot, balls 1 to 15 racked in order.
inline Picture racked_picture() {
  Picture picture = empty_picture();
  const physics::Scene& scene = default_scene();
  picture.balls.push_back(ball_at(0, physics::head_spot(scene.bed)));
  std::uint32_t id = 0;
  for (const physics::Vec2 place :
       physics::triangle_rack(scene.bed, scene.ball, physics::rack_gap_m)) {
    picture.balls.push_back(ball_at(++id, place));
  }
  return picture;
}

}  // namespace breakshot::client
