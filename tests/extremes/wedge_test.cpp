// Balls squeezed between two cushions.
#include "common/physics/angle.hpp"
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

/// Two cushions that meet in the origin at an angle of 2 `half`, open towards +x.
FreeCushions wedge(double half, const CushionModel& model) {
  const Vec2 d = direction_of(half);
  return {{{{0, 0}, Vec2{d.x, -d.y} * 50, model}, {d * 50, {0, 0}, model}}, {}};
}

TEST(Wedge, OfMirrorsGivesTheBallBackAfterAsManyHitsAsUnfolded) {
  for (const double half : {0.7, 0.3, 0.1, 0.01, 1e-3}) {
    Scene scene = gas();
    scene.cushions = wedge(half, Mirror{});
    // The ball's centre lives in a wedge of the same angle, whose tip is R / sin(half) away.
    const double tip = radius_m / std::sin(half);
    const Vec2 from{tip + 0.5, 0.1 * half};
    const Vec2 velocity{-1, 0.01 * half};
    const Shot shot = shot_of(scene, balls({ball(0, from, velocity)}), std::nullopt, {}, until(2));
    // Unfolded, the path is a straight line through images of the wedge, half a turn in all.
    const auto hits = all_of<BallCushion>(shot).size();
    EXPECT_LE(hits, static_cast<std::size_t>(3.141592653589793 / (2 * half)) + 1) << half;
    EXPECT_GE(hits + 2, static_cast<std::size_t>(3.141592653589793 / (2 * half))) << half;
    EXPECT_NEAR(length(state_of(shot, 0).velocity), length(velocity), 1e-12) << half;
    EXPECT_GT(state_of(shot, 0).velocity.x, 0) << half;
    EXPECT_LE(deepest_in_rails(scene, shot, 4), 1e-12) << half;
  }
}

/// Two balls, one behind the other, rolled into a wedge.
struct Squeeze {
  Scene scene;
  State state;

  Squeeze(const Motion& motion, const CushionModel& nose, double half) {
    scene = carpet(BallFriction{});
    scene.bed.motion = motion;
    scene.cushions = wedge(half, nose);
    const double tip = radius_m / std::sin(half);
    state = balls({moving(scene, 0, {tip + 0.3, 0}, {-3, 0.2 * half}),
                   moving(scene, 1, {tip + 0.3 + 3 * diameter_m, 0}, {-6, -0.1 * half})});
  }
};

TEST(Wedge, OfAnyModelSqueezesNoBallThrough) {
  for (const Motion& motion : {motions()[1], motions()[2]}) {
    for (const CushionModel& model : cushion_models()) {
      for (const double half : {0.7, 0.3}) {
        const Squeeze squeeze(motion, model, half);
        const Shot shot = shot_of(squeeze.scene, squeeze.state);
        const std::string where = name_of(squeeze.scene) + " model " +
                                  std::to_string(model.index()) + " half " + std::to_string(half);
        EXPECT_EQ(shot.stop, Stop::rest) << where;
        EXPECT_LT(shot.events.size(), 20'000u) << where;
        expect_sound(squeeze.scene, shot, where);
        EXPECT_LE(deepest_in_rails(squeeze.scene, shot, 4), 1e-12) << where;
      }
    }
  }
}

TEST(Wedge, OfAFewDegreesSqueezesNoBallThroughBeforeItStalls) {
  // Between noses that nearly face one another a pass turns the velocity by the angle of the wedge
  // alone: more passes than there may be, or more hops than events.
  for (const Motion& motion : {motions()[1], motions()[2]}) {
    for (const CushionModel& model : cushion_models()) {
      for (const double half : {0.05, 0.005}) {
        const Squeeze squeeze(motion, model, half);
        Limits limits;
        limits.max_events = 20'000;
        const auto outcome = simulate(squeeze.scene, squeeze.state, std::nullopt, {}, limits);
        const auto* stalled = std::get_if<Stalled>(&outcome);
        const Shot& shot = stalled != nullptr ? stalled->so_far : std::get<Shot>(outcome);
        const std::string where = name_of(squeeze.scene) + " model " +
                                  std::to_string(model.index()) + " half " + std::to_string(half);
        expect_sound(squeeze.scene, shot, where);
        EXPECT_LE(deepest_in_rails(squeeze.scene, shot, 4), 1e-12) << where;
      }
    }
  }
}

// Follow presses the ball into both noses of a wedge of 34 degrees: a push that hops between two
// cushions at once.
TEST(Wedge, OfDeadNosesStopsAPressedBallInAFewEvents) {
  const Squeeze squeeze(motions()[2], CushionRestitution{0, 0.9, 1e-3}, 0.3);
  Limits limits;
  limits.max_events = 20'000;
  const auto outcome = simulate(squeeze.scene, squeeze.state, std::nullopt, {}, limits);
  EXPECT_TRUE(std::holds_alternative<Shot>(outcome));
}

}  // namespace
}  // namespace breakshot::physics
