// Things that happen at one instant and have nothing, or everything, to do with one another.
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

/// Decelerations of 1 m/s^2 and radii of 1/32 m: times and places are exact.
Scene dyadic(const Motion& motion, const BallBallModel& pair) {
  Scene scene = gas();
  scene.gravity_m_s2 = 8;
  scene.ball.radius_m = 0.03125;
  scene.bed.motion = motion;
  scene.ball_ball = pair;
  return scene;
}

TEST(OneInstant, AStraightSlideThatTurnsToRollAtContactGivesOneCollision) {
  for (const BallBallModel& pair : pair_models()) {
    const Scene scene = dyadic(Straight{0.125, 0.0125, 1}, pair);
    // 2 m/s down to 1 m/s in 1 s and 1.5 m.
    const double place = 1.5 + 0.0625;
    for (const double x : {place, std::nextafter(place, 0.0), std::nextafter(place, 2.0)}) {
      const Shot shot = shot_of(scene, balls({ball(0, {0, 0}, {2, 0}), ball(1, {x, 0})}),
                                std::nullopt, {}, until(1.001));
      ASSERT_EQ(all_of<BallBall>(shot).size(), 1u) << name_of(scene);
      EXPECT_NEAR(all_of<BallBall>(shot)[0].time_s, 1, 1e-15);
      const double sum =
          state_of(shot, 0, 1.0 + 1e-12).velocity.x + state_of(shot, 1, 1.0 + 1e-12).velocity.x;
      EXPECT_NEAR(sum, 1, 0.03) << name_of(scene);
      expect_sound(scene, shot, name_of(scene));
    }
  }
}

TEST(OneInstant, ASpinningSlideThatTurnsToRollAtContactGivesOneCollision) {
  for (const BallBallModel& pair : pair_models()) {
    const Scene scene = dyadic(Spinning{0.125, 0.0125, 0.125}, pair);
    // 3.5 m/s without spin roll at 2.5 m/s after 1 s and 3 m.
    const double place = 3 + 0.0625;
    double speeds[3];
    int which = 0;
    for (const double x : {place, std::nextafter(place, 0.0), std::nextafter(place, 9.0)}) {
      const Shot shot = shot_of(scene, balls({ball(0, {0, 0}, {3.5, 0}), ball(1, {x, 0})}),
                                std::nullopt, {}, until(1.0001));
      ASSERT_EQ(all_of<BallBall>(shot).size(), 1u) << name_of(scene);
      EXPECT_NEAR(all_of<BallBall>(shot)[0].time_s, 1, 1e-14);
      speeds[which++] = state_of(shot, 1, 1.0 + 1e-12).velocity.x;
      expect_sound(scene, shot, name_of(scene));
    }
    EXPECT_NEAR(speeds[0], speeds[1], 1e-12) << name_of(scene);
    EXPECT_NEAR(speeds[0], speeds[2], 1e-12) << name_of(scene);
    EXPECT_GT(speeds[0], 2.2);
  }
}

TEST(OneInstant, ABallThatComesToRestAsItIsHitIsMovedOn) {
  for (const BallBallModel& pair : pair_models()) {
    const Scene scene = dyadic(Straight{0.125, 0.125, 1}, pair);
    // Ball 1 rolls 1/2 m to rest in 1 s; ball 0 comes at that place at that instant, at 1 m/s.
    const double place = 0.5;
    const Shot shot =
        shot_of(scene, balls({ball(0, {place - 0.0625 - 1.5, 0}, {2, 0}), ball(1, {0, 0}, {1, 0})}),
                std::nullopt, {}, until(1.5));
    ASSERT_EQ(all_of<BallBall>(shot).size(), 1u) << name_of(scene);
    EXPECT_NEAR(all_of<BallBall>(shot)[0].time_s, 1, 1e-14) << name_of(scene);
    EXPECT_GT(state_of(shot, 1, 1.001).velocity.x, 0.9) << name_of(scene);
    expect_sound(scene, shot, name_of(scene));
  }
}

TEST(OneInstant, ABallDropsAsTwoOthersMeet) {
  for (const Pockets& pockets : {Pockets{StandardPockets{}}, Pockets{JawedPockets{}}}) {
    for (const Motion& motion : motions()) {
      Scene scene = table(motion, Han2005{}, BallFriction{});
      scene.pockets = pockets;
      // Ball 0 drops into the side pocket; when, a first shot tells.
      const Ball drops = moving(scene, 0, {0, 0.2}, {0, 1});
      const Shot alone = shot_of(scene, balls({drops}), std::nullopt, {}, until(3));
      ASSERT_EQ(all_of<BallPocket>(alone).size(), 1u) << name_of(scene);
      const double t = all_of<BallPocket>(alone)[0].time_s;
      // Ball 1 is then where it meets ball 2: as near as doubles allow.
      const Ball runs = moving(scene, 1, {-0.9, -0.3}, {1, 0});
      const Shot second = shot_of(scene, balls({runs}), std::nullopt, {}, until(t));
      const Vec2 there = state_of(second, 1, t).position;
      double x = there.x + diameter_m;
      for (int i = 0; i < 4; ++i) x = std::nextafter(x, -2.0);
      int together = 0;
      for (int i = 0; i < 9; ++i, x = std::nextafter(x, 2.0)) {
        const Shot shot = shot_of(scene, balls({drops, runs, ball(2, {x, -0.3})}), std::nullopt, {},
                                  limits_for(scene, 3));
        const auto drop = all_of<BallPocket>(shot);
        const auto hit = all_of<BallBall>(shot);
        ASSERT_GE(drop.size(), 1u) << name_of(scene);
        ASSERT_GE(hit.size(), 1u) << name_of(scene);
        EXPECT_EQ(drop[0].time_s, t) << name_of(scene);
        EXPECT_NEAR(hit[0].time_s, t, 4e-15) << name_of(scene);
        together += hit[0].time_s == t;
        expect_sound(scene, shot, name_of(scene));
      }
      EXPECT_GT(together, 0) << name_of(scene);
    }
  }
}

TEST(OneInstant, ABallAtAMouthDropsAsItIsHitOutwards) {
  for (const Motion& motion : motions()) {
    Scene scene = table(motion, Mirror{}, BallRestitution{});
    scene.pockets = StandardPockets{};
    const double y = eight_foot_width_m / 2 - radius_m;
    const Shot shot =
        shot_of(scene, balls({ball(0, {0, y}), moving(scene, 1, {0, y - 0.3}, {0, 2})}),
                std::nullopt, {}, until(0.5));
    const auto drops = all_of<BallPocket>(shot);
    ASSERT_GE(drops.size(), 1u) << name_of(scene);
    EXPECT_EQ(drops[0].ball, BallId{0});
    EXPECT_EQ(drops[0].time_s, all_of<BallBall>(shot).at(0).time_s) << name_of(scene);
  }
}

}  // namespace
}  // namespace breakshot::physics
