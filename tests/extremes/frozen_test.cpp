// Racks and cue balls that touch. The frictionless break: tests/physics/contact_test.cpp.
#include "common/physics/simulation.hpp"
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

TEST(FrozenRack, AtRestStaysAtRest) {
  for (const Scene& scene : every_table()) {
    const State state = racked(scene, 0);
    const Shot shot = shot_of(scene, state, std::nullopt, {}, until(10));
    EXPECT_TRUE(shot.events.empty()) << name_of(scene);
    EXPECT_EQ(shot.stop, Stop::rest);
    EXPECT_EQ(state_after(shot), state) << name_of(scene);
  }
}

TEST(FrozenRack, StaysAtRestWhileAnotherBallMoves) {
  for (const Scene& scene : every_table()) {
    const State state = racked(scene, 0);
    const Shot shot = shot_of(scene, state, Strike{BallId{0}, {-1, 0}, 0.2, {}}, {}, until(3));
    EXPECT_TRUE(all_of<BallBall>(shot).empty()) << name_of(scene);
    for (std::uint32_t id = 1; id < 16; ++id) {
      EXPECT_EQ(state_of(shot, id).position, state.balls[id].position) << name_of(scene);
    }
  }
}

/// All balls right after the set of contacts of a break, which may be spread over some instants
/// that rounding keeps apart.
std::vector<BallState> after_first_set(const Scene& scene, const State& state, double speed_m_s) {
  Simulation simulation(scene, state, Strike{BallId{0}, {1, 0}, speed_m_s, {}}, {}, until(1));
  simulation.advance_to(0.2);
  const auto hits = all_of<BallBall>(simulation.shot());
  if (hits.empty()) return {};
  double last = hits[0].time_s;
  for (const BallBall& hit : hits) {
    if (hit.time_s < hits[0].time_s + 1e-9) last = hit.time_s;
  }
  return Timeline(simulation.shot()).states(last);
}

double energy_of(const std::vector<BallState>& states) {
  double sum = 0;
  for (const BallState& b : states) {
    sum += dot(b.velocity, b.velocity) + 0.4 * radius_m * radius_m * dot(b.spin, b.spin);
  }
  return sum;
}

TEST(FrozenRack, HeadOnKeepsTheMirrorInEveryScene) {
  for (const Scene& scene : every_table()) {
    const auto after = after_first_set(scene, racked(scene, 0), 8);
    ASSERT_EQ(after.size(), 16u);
    for (const BallState& here : after) {
      const auto mirrored = std::find_if(after.begin(), after.end(), [&](const BallState& other) {
        return length(Vec2{other.position.x, -other.position.y} - here.position) < 1e-6;
      });
      ASSERT_NE(mirrored, after.end());
      EXPECT_NEAR(mirrored->velocity.x, here.velocity.x, 1e-12) << name_of(scene);
      EXPECT_NEAR(mirrored->velocity.y, -here.velocity.y, 1e-12) << name_of(scene);
      // A spin is mirrored the other way; 1e-12 m/s at the surface.
      EXPECT_NEAR(mirrored->spin.x, -here.spin.x, 1e-12 / radius_m) << name_of(scene);
      EXPECT_NEAR(mirrored->spin.y, here.spin.y, 1e-12 / radius_m) << name_of(scene);
      EXPECT_NEAR(mirrored->spin.z, -here.spin.z, 1e-12 / radius_m) << name_of(scene);
    }
    EXPECT_LE(energy_of(after), 64 * (1 + 1e-14)) << name_of(scene);
  }
}

TEST(FrozenRack, DoesNotDependOnTheNumberingInEveryScene) {
  for (const Scene& scene : every_table()) {
    const State state = racked(scene, 0);
    const auto reference = after_first_set(scene, state, 8);
    Chance chance(23);
    for (int round = 0; round < 3; ++round) {
      std::vector<std::uint32_t> renamed(16);
      for (std::uint32_t i = 0; i < 16; ++i) renamed[i] = i;
      for (std::size_t i = 15; i > 1; --i) std::swap(renamed[i], renamed[1 + chance.below(i)]);
      State shuffled = state;
      for (std::size_t i = 0; i < 16; ++i) shuffled.balls[i].id = BallId{renamed[i]};
      const auto after = after_first_set(scene, shuffled, 8);
      for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_LE(length(after[renamed[i]].velocity - reference[i].velocity), 1e-13)
            << name_of(scene) << " ball " << i;
      }
    }
  }
}

TEST(FrozenRack, OffCentreIsSoundInEveryScene) {
  for (const Scene& scene : every_table()) {
    for (const double offset : {1e-15, 1e-9, 1e-3, 0.03, diameter_m - 1e-9}) {
      State state = racked(scene, 0);
      state.balls[0].position.y = offset;
      const Shot shot =
          shot_of(scene, state, Strike{BallId{0}, {1, 0}, 8, {}}, {}, limits_for(scene, 0.3));
      expect_sound(scene, shot, name_of(scene) + " offset " + std::to_string(offset));
      EXPECT_LT(shot.events.size(), 5000u) << name_of(scene) << " offset " << offset;
    }
  }
}

TEST(NearlyFrozenRack, IsSoundForGapsOf1e15To1e3Radii) {
  for (const Scene& scene : every_table()) {
    for (int exponent = -15; exponent <= -3; ++exponent) {
      const double gap = radius_m * std::pow(10.0, exponent);
      const Shot shot = shot_of(scene, racked(scene, gap), Strike{BallId{0}, {1, 0}, 8, {}}, {},
                                limits_for(scene, 0.3));
      const std::string where = name_of(scene) + " gap 1e" + std::to_string(exponent) + " R";
      expect_sound(scene, shot, where);
      EXPECT_LT(shot.events.size(), 5000u) << where;
    }
  }
}

/// A head-on break of a rack with gaps of 1e-15 m, found by the audit.
struct TightBreak {
  BallKind ball;
  Vec2 bed;
  Straight motion;
  CushionModel cushion;
  double speed_m_s;
};

const TightBreak tight_breaks[] = {{pool_ball,
                                    {2.54, 1.27},
                                    {0.18842030172236263, 0.03195603466941975, 1.250679983291775},
                                    CushionRestitution{1, 0.62545030983164907, 1e-3},
                                    1.5384291766677052},
                                   {carom_ball,
                                    {2.84, 1.42},
                                    {0.45571766573702915, 0.042497539530741056, 1.8816815204918385},
                                    Mirror{},
                                    1.51624695234932},
                                   {carom_ball,
                                    {2.84, 1.42},
                                    {0.35416351712774485, 0.041358964340761306, 1.437523219268769},
                                    CushionRestitution{0.85, 0.85405460395850241, 1e-3},
                                    1.9701630694326013}};

Scene scene_of(const TightBreak& b) {
  Scene scene = table(b.motion, b.cushion, Elastic{});
  scene.ball = b.ball;
  scene.bed.length_m = b.bed.x;
  scene.bed.width_m = b.bed.y;
  return scene;
}

Shot played(const TightBreak& b, const State& state) {
  return shot_of(scene_of(b), state, Strike{BallId{0}, {1, 0}, b.speed_m_s, {}});
}

// The second row slows down into the apex, which is hardly hit: two elastic contacts that mirror
// one another hopped a million times, or ever less until no time passed.
TEST(NearlyFrozenRack, OfElasticBallsThatSlowDownIntoTheApexComesToRest) {
  for (const TightBreak& b : tight_breaks) {
    const std::string where = "at " + std::to_string(b.speed_m_s);
    const Shot shot = played(b, racked(scene_of(b), 1e-15));
    EXPECT_EQ(shot.stop, Stop::rest) << where;
    EXPECT_LT(shot.events.size(), 200u) << where;
    expect_sound(scene_of(b), shot, where);
  }
}

// Both contacts of the apex hop at the same instants.
TEST(NearlyFrozenRack, KeepsTheMirrorAndKnowsNoNumbersThroughPushesOfTwoIntoOne) {
  for (const TightBreak& b : tight_breaks) {
    const State state = racked(scene_of(b), 1e-15);
    State reversed = state;
    for (std::uint32_t i = 1; i < 16; ++i) reversed.balls[i].id = BallId{16 - i};
    const Shot shot = played(b, state);
    const Shot other = played(b, reversed);
    for (std::uint32_t i = 1; i < 16; ++i) {
      const Vec2 place = state_of(shot, i).position;
      double nearest = 1;
      for (std::uint32_t k = 1; k < 16; ++k) {
        const Vec2 mirrored = state_of(shot, k).position;
        nearest = std::min(nearest, length(Vec2{mirrored.x, -mirrored.y} - place));
      }
      EXPECT_LT(nearest, 1e-12) << i << " at " << b.speed_m_s;
      EXPECT_LT(length(state_of(other, 16 - i).position - place), 1e-12) << i;
    }
  }
}

// ---- A frozen cue ball

Shot frozen_cue(const Scene& scene, Vec2 direction, double speed_m_s = 2) {
  return shot_of(scene, balls({ball(0, {0, 0}), ball(1, {diameter_m, 0})}),
                 Strike{BallId{0}, direction, speed_m_s, {}}, {}, until(2));
}

TEST(FrozenCueBall, StruckIntoItsNeighbourMovesItAtOnce) {
  for (const Scene& scene : every_cloth()) {
    const Shot shot = frozen_cue(scene, {1, 0});
    const auto hits = all_of<BallBall>(shot);
    ASSERT_GE(hits.size(), 1u) << name_of(scene);
    EXPECT_EQ(hits[0].time_s, 0) << name_of(scene);
    const double e = scene.ball_ball->index() == 0   ? 1
                     : scene.ball_ball->index() == 3 ? 0.89
                                                     : 0.95;
    const double there = state_of(shot, 1, 0).velocity.x;
    EXPECT_NEAR(there, 1 + e, scene.ball_ball->index() == 3 ? 0.05 : 1e-14) << name_of(scene);
    expect_sound(scene, shot, name_of(scene));
  }
}

TEST(FrozenCueBall, StruckAwayLeavesItsNeighbourAlone) {
  for (const Scene& scene : every_cloth()) {
    for (const Vec2 direction : {Vec2{-1, 0}, Vec2{-0.6, 0.8}, Vec2{-0.8, -0.6}}) {
      const Shot shot = frozen_cue(scene, direction);
      EXPECT_TRUE(all_of<BallBall>(shot).empty()) << name_of(scene);
      EXPECT_EQ(state_of(shot, 1).position, (Vec2{diameter_m, 0}));
    }
  }
}

TEST(FrozenCueBall, StruckAlongItsNeighbourOnlyGrazesIt) {
  for (const Scene& scene : every_cloth()) {
    for (const double side : {1.0, -1.0}) {
      const Shot shot = frozen_cue(scene, {0, side});
      EXPECT_TRUE(all_of<BallBall>(shot).empty()) << name_of(scene);
      EXPECT_EQ(state_of(shot, 1).position, (Vec2{diameter_m, 0})) << name_of(scene);
    }
  }
}

TEST(FrozenCueBall, StruckAlongItsNeighbourAndAHairIntoItMovesItAHair) {
  for (const Scene& scene : every_cloth()) {
    for (const double hair : {1e-3, 1e-6, 1e-9}) {
      const Shot shot = frozen_cue(scene, {hair, std::sqrt(1 - hair * hair)});
      const auto hits = all_of<BallBall>(shot);
      ASSERT_GE(hits.size(), 1u) << name_of(scene) << hair;
      EXPECT_EQ(hits[0].time_s, 0);
      EXPECT_GT(state_of(shot, 1, 0).velocity.x, 0) << name_of(scene) << hair;
      EXPECT_LT(state_of(shot, 1, 0).velocity.x, 4.01 * hair) << name_of(scene) << hair;
      expect_sound(scene, shot, name_of(scene));
    }
  }
}

}  // namespace
}  // namespace breakshot::physics
