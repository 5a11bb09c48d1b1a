#include "client_cli/figures.hpp"

#include <gtest/gtest.h>

#include "client_cli/draw/image.hpp"
#include "common/physics/table.hpp"

namespace breakshot::client {
namespace {

TEST(Figures, AreThoseOfThePaperOnEveryTable) {
  for (const physics::Preset& preset : physics::presets()) {
    SCOPED_TRACE(preset.name);
    const Picture layout = figure(1, preset.scene);
    EXPECT_EQ(layout.balls.size(), 16u);
    ASSERT_TRUE(layout.cue);
    EXPECT_EQ(layout.cue->from, physics::head_spot(preset.scene.bed));

    const Picture rack = figure(2, preset.scene);
    ASSERT_TRUE(rack.window);
    for (const DrawnBall& ball : rack.balls) {
      const bool seen = ball.position.x > rack.window->low.x;
      EXPECT_EQ(seen, number(ball.id) != 0);
    }

    const Picture start = figure(3, preset.scene, 0);
    const Picture broken = figure(3, preset.scene);
    EXPECT_FALSE(broken.velocities);
    std::size_t moved = 0;
    for (const DrawnBall& ball : broken.balls) {
      moved += physics::length(ball.velocity) > 0 ? 1 : 0;
    }
    EXPECT_GT(moved, 8u);
    EXPECT_NE(start.balls.front().position, broken.balls.front().position);
    EXPECT_TRUE(figure(4, preset.scene).velocities);
  }
}

TEST(Figures, ShowMoreIfAsked) {
  const physics::Scene& scene = physics::presets().front().scene;
  const Picture plain = figure(3, scene);
  EXPECT_TRUE(plain.paths.empty());
  EXPECT_FALSE(plain.cue);
  const Picture full = figure(3, scene, std::nullopt, {true, true, true});
  EXPECT_GT(full.paths.size(), 8u);
  EXPECT_TRUE(full.velocities);
  ASSERT_TRUE(full.cue);
  EXPECT_GT(full.cue->direction.y, 0);
}

}  // namespace
}  // namespace breakshot::client
