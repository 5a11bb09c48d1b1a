// Hit or miss where the last bit decides, and stops where it decides whether there is a hit.
// One ulp on slanted straight paths: tests/physics/detect_test.cpp.
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

/// Neighbours of a number.
double up(double x) {
  return std::nextafter(x, 1e300);
}
double down(double x) {
  return std::nextafter(x, -1e300);
}

bool meets(const Scene& scene, const Ball& mover, const Ball& target) {
  const Shot shot = shot_of(scene, balls({mover, target}), std::nullopt, {}, until(3));
  return !all_of<BallBall>(shot).empty();
}

TEST(Grazing, IsDecidedByOneUlpInEveryScene) {
  for (const Scene& scene : every_cloth()) {
    for (const double x : {0.1, 0.3, 0.5}) {
      const Ball mover = moving(scene, 0, {0, 0}, {1, 0});
      EXPECT_TRUE(meets(scene, mover, ball(1, {x, down(diameter_m)}))) << name_of(scene) << x;
      EXPECT_FALSE(meets(scene, mover, ball(1, {x, diameter_m}))) << name_of(scene) << x;
      EXPECT_FALSE(meets(scene, mover, ball(1, {x, up(diameter_m)}))) << name_of(scene) << x;
    }
  }
}

TEST(Grazing, OfABallThatSlidesIsDecidedByOneUlp) {
  // Draw: the slip lies along the way, the path is the general one.
  const Scene scene = carpet(Elastic{});
  Ball mover = ball(0, {0, 0}, {2, 0});
  mover.spin = {0, -30, 0};
  EXPECT_TRUE(meets(scene, mover, ball(1, {0.2, down(diameter_m)})));
  EXPECT_FALSE(meets(scene, mover, ball(1, {0.2, diameter_m})));
  EXPECT_FALSE(meets(scene, mover, ball(1, {0.2, up(diameter_m)})));
}

TEST(Grazing, OfTwoMoversWithDifferentFrictionIsDecidedByOneUlp) {
  const Scene scene = cloth();
  const Ball mover = ball(0, {0, 0}, {2, 0});
  EXPECT_TRUE(meets(scene, mover, ball(1, {0.2, down(diameter_m)}, {0.5, 0})));
  EXPECT_FALSE(meets(scene, mover, ball(1, {0.2, diameter_m}, {0.5, 0})));
  EXPECT_FALSE(meets(scene, mover, ball(1, {0.2, up(diameter_m)}, {0.5, 0})));
}

/// Moves a target across the path of a ball in equal steps and counts how often hit and miss
/// change.
template <class Target>
int switches(const Scene& scene, const Ball& mover, double from, double step, int count,
             const Target& target) {
  int changes = 0;
  bool last = meets(scene, mover, target(from));
  for (int i = 1; i < count; ++i) {
    const bool now = meets(scene, mover, target(from + i * step));
    changes += now != last;
    last = now;
  }
  return changes;
}

TEST(ImpactParameter, SwitchesOnceOnStraightPathsUlpByUlp) {
  const Vec2 way{0.8, 0.6};
  for (const Scene& scene : every_cloth()) {
    const Ball mover = moving(scene, 0, {-0.31, 0.17}, way * 0.9);
    const auto target = [&](double aside) {
      return ball(1, mover.position + way * 0.35 + perp(way) * aside);
    };
    for (const double step : {1e-3, 1e-6, 1e-9, 1e-12, 1e-14}) {
      EXPECT_EQ(switches(scene, mover, diameter_m - 20.3 * step, step, 40, target), 1)
          << name_of(scene) << " step " << step;
    }
    // On the axis every ulp counts.
    const Ball level = moving(scene, 0, {0, 0}, {0.9, 0});
    double y = diameter_m;
    for (int i = 0; i < 50; ++i) y = down(y);
    int changes = 0;
    bool last = true;
    for (int i = 0; i < 100; ++i, y = up(y)) {
      const bool now = meets(scene, level, ball(1, {0.3, y}));
      changes += now != last;
      last = now;
    }
    EXPECT_EQ(changes, 1) << name_of(scene);
    EXPECT_FALSE(last) << name_of(scene);
  }
}

TEST(ImpactParameter, SwitchesOnceOnCurvedPaths) {
  const Scene scene = carpet(BallFriction{});
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Chance chance(seed);
    Ball mover = ball(0, {0, 0}, {chance.between(0.5, 3), chance.between(-1, 1)});
    mover.spin = {chance.between(-200, 200), chance.between(-200, 200), chance.between(-99, 99)};
    const Shot alone = shot_of(scene, balls({mover}));
    // Beside the place where the ball is at half of its slide.
    const double t = time_of(alone.events.at(0)) / 2;
    const BallState there = state_of(alone, 0, t);
    const Vec2 aside = perp(there.velocity) * (1 / length(there.velocity));
    for (const double side : {1.0, -1.0}) {
      const auto target = [&](double offset) {
        return ball(1, there.position + aside * (side * offset));
      };
      if (length(target(0.9 * diameter_m).position) < 1.2 * diameter_m) continue;
      if (!faults_of(scene, balls({mover, target(0.9 * diameter_m)})).empty()) continue;
      double hit = 0.9 * diameter_m;
      double miss = 1.2 * diameter_m;
      if (!meets(scene, mover, target(hit)) || meets(scene, mover, target(miss))) continue;
      for (int i = 0; i < 45; ++i) {
        const double middle = (hit + miss) / 2;
        (meets(scene, mover, target(middle)) ? hit : miss) = middle;
      }
      for (const double step : {1e-4, 1e-8, 1e-12, 1e-14}) {
        EXPECT_EQ(switches(scene, mover, hit - 20.3 * step, step, 40, target), 1)
            << "seed " << seed << " step " << step;
      }
    }
  }
}

TEST(ImpactParameter, SwitchesOnceAtTheEndOfACushion) {
  // Where a free cushion begins: foot exactly at its end, and each side of it.
  Scene scene = gas();
  scene.cushions = FreeCushions{{{{0, 1}, {-1, 1}, Mirror{}}}, {}};
  int changes = 0;
  bool last = true;
  for (const double x : {-1e-3, -1e-9, -1e-15, -5e-324, 0.0, 5e-324, 1e-15, 1e-9, 1e-3}) {
    const Shot shot = shot_of(scene, balls({ball(0, {x, 0}, {0, 1})}), std::nullopt, {}, until(2));
    const bool now = !all_of<BallCushion>(shot).empty();
    EXPECT_EQ(now, x <= 0) << x;
    changes += now != last;
    last = now;
  }
  EXPECT_EQ(changes, 1);
}

// ---- Balls that stop at the gap. Rolls in straight motion: tests/physics/detect_test.cpp.

/// A ball that comes to rest after `reach` along +x, its target `gap` away.
bool reaches(const Scene& scene, const Ball& mover, double gap) {
  return meets(scene, mover, ball(1, {mover.position.x + diameter_m + gap, 0}));
}

TEST(StopShort, OfARollIsDecidedAtTheGapPlusMinus1e14) {
  const double v = 0.2;
  for (const BallBallModel& pair : pair_models()) {
    const Scene scene = carpet(pair);
    const double reach = v * v / (2 * 0.01 * 9.81);
    const Ball mover = moving(scene, 0, {0, 0}, {v, 0});
    EXPECT_TRUE(reaches(scene, mover, reach - 1e-14)) << name_of(scene);
    EXPECT_FALSE(reaches(scene, mover, reach + 1e-14)) << name_of(scene);
  }
}

TEST(StopShort, OfADrawnBallThatStopsDeadIsDecidedAtTheGapPlusMinus1e14) {
  // R w = -5/2 v: slip and speed are gone at one instant, and the ball stays where it is.
  const double v = 1.1;
  for (const BallBallModel& pair : pair_models()) {
    const Scene scene = carpet(pair);
    const double reach = v * v / (2 * 0.2 * 9.81);
    Ball mover = ball(0, {0, 0}, {v, 0});
    mover.spin = {0, -2.5 * v / radius_m, 0};
    EXPECT_TRUE(reaches(scene, mover, reach - 1e-14)) << name_of(scene);
    EXPECT_FALSE(reaches(scene, mover, reach + 1e-14)) << name_of(scene);
  }
}

/// Numbers of two: radius 1/32 m, decelerations 1 m/s^2, so that a ball of 1 m/s stops at exactly
/// 1/2 m.
Scene dyadic(const BallBallModel& pair) {
  Scene scene = carpet(pair);
  scene.gravity_m_s2 = 8;
  scene.ball.radius_m = 0.03125;
  scene.bed.motion = Spinning{0.125, 0.125, 0.125};
  return scene;
}

TEST(StopShort, ABallThatStopsExactlyAtContactTouchesAndDoesNothing) {
  for (const BallBallModel& pair : pair_models()) {
    const Scene scene = dyadic(pair);
    const Ball mover = moving(scene, 0, {0, 0}, {1, 0});
    const double place = 0.5 + 0.0625;
    const Shot exact = shot_of(scene, balls({mover, ball(1, {place, 0})}));
    EXPECT_TRUE(all_of<BallBall>(exact).empty()) << name_of(scene);
    EXPECT_EQ(state_of(exact, 0).position, (Vec2{0.5, 0})) << name_of(scene);
    EXPECT_FALSE(meets(scene, mover, ball(1, {up(place), 0})));
    // One ulp nearer it arrives at some 1e-8 m/s, and what rests against a ball is parted from it
    // at half of elastic_below each: 1.25e-7 m.
    const Shot nearer = shot_of(scene, balls({mover, ball(1, {down(place), 0})}));
    EXPECT_GE(all_of<BallBall>(nearer).size(), 1u) << name_of(scene);
    EXPECT_LE(all_of<BallBall>(nearer).size(), 3u) << name_of(scene);
    EXPECT_EQ(nearer.stop, Stop::rest);
    EXPECT_LT(length(state_of(nearer, 1).position - Vec2{place, 0}), 1.3e-7);
    expect_sound(scene, nearer, name_of(scene));
  }
}

TEST(StopShort, ABallThatStopsExactlyAtACushionDoesNotMeetIt) {
  for (const CushionModel& model : cushion_models()) {
    Scene scene = dyadic(Elastic{});
    const auto hits = [&](double x) {
      CushionModel nose = model;
      if (auto* han = std::get_if<Han2005>(&nose)) han->height_m = 0.04;
      if (auto* mathavan = std::get_if<Mathavan2010>(&nose)) mathavan->height_m = 0.04;
      if (auto* stronge = std::get_if<Stronge2000>(&nose)) stronge->height_m = 0.04;
      scene.cushions = FreeCushions{{{{x, -1}, {x, 1}, nose}}, {}};
      const Shot shot = shot_of(scene, balls({moving(scene, 0, {0, 0}, {1, 0})}));
      expect_sound(scene, shot, name_of(scene));
      return all_of<BallCushion>(shot).size();
    };
    EXPECT_EQ(hits(0.5 + 0.03125), 0u) << model.index();
    EXPECT_EQ(hits(up(0.5 + 0.03125)), 0u) << model.index();
    EXPECT_GE(hits(down(0.5 + 0.03125)), 1u) << model.index();
    EXPECT_LE(hits(down(0.5 + 0.03125)), 3u) << model.index();
  }
}

}  // namespace
}  // namespace breakshot::physics
