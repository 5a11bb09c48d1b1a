// Pockets with jaws: where they are, and how balls drop, rattle, hang and pass.
#include <gtest/gtest.h>

#include <cmath>

#include "common/physics/angle.hpp"
#include "common/physics/audit.hpp"
#include "common/physics/rails.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

Scene jawed() {
  Scene scene = table(Spinning{}, Han2005{}, BallFriction{});
  scene.pockets = JawedPockets{};
  return scene;
}

double angle_between(Vec2 a, Vec2 b) {
  return std::atan2(cross(a, b), dot(a, b));
}

TEST(Jaws, StandAtTheCutAngles) {
  const Rails rails = rails_of(jawed());
  const JawedPockets jaws;
  ASSERT_EQ(rails.segments.size(), 18U);
  ASSERT_EQ(rails.arcs.size(), 12U);
  ASSERT_EQ(rails.holes.size(), 6U);
  // The foot cushion runs from pocket 2 to pocket 3: its last jaw has id 4 + 2 * 3.
  const auto jaw = [&](std::uint32_t id) {
    for (std::size_t i = 6; i < rails.segments.size(); ++i) {
      if (number(rails.segments[i].id) == id)
        return rails.segments[i].nose.to - rails.segments[i].nose.from;
    }
    return Vec2{};
  };
  EXPECT_NEAR(angle_between(jaw(10), {0, 1}), 3.141592653589793 - jaws.corner_cut_rad, 1e-9);
  EXPECT_NEAR(angle_between(jaw(12), {-1, 0}), 3.141592653589793 - jaws.side_cut_rad, 1e-9);
}

TEST(Jaws, JoinCushionAndFacingWithoutAGap) {
  const Rails rails = rails_of(jawed());
  for (const RailArc& arc : rails.arcs) {
    int joined = 0;
    for (const RailSegment& s : rails.segments) {
      for (const Vec2 end : {s.nose.from, s.nose.to}) {
        for (const Vec2 direction : {arc.nose.from, arc.nose.to}) {
          if (length(arc.nose.centre + direction * arc.nose.radius_m - end) < 1e-15) ++joined;
        }
      }
    }
    EXPECT_EQ(joined, 2) << number(arc.id);
  }
}

TEST(Jaws, AreTheSameOnAllSides) {
  const Rails rails = rails_of(jawed());
  for (const RailArc& arc : rails.arcs) {
    int mirrored = 0;
    for (const RailArc& other : rails.arcs) {
      const Vec2 sum = arc.nose.centre + other.nose.centre;
      if (length(sum) < 1e-15) ++mirrored;
    }
    EXPECT_EQ(mirrored, 1);
  }
}

/// One ball sent from the middle of the table towards a place.
Shot sent(const Scene& scene, Vec2 from, Vec2 to, double speed_m_s) {
  const Vec2 way = to - from;
  return shot_of(scene, balls({ball(0, from)}),
                 Strike{BallId{0}, way * (1 / length(way)), speed_m_s, {}});
}

TEST(Jaws, TakeABallThatComesStraight) {
  const Scene scene = jawed();
  const Rails rails = rails_of(scene);
  for (const Hole& hole : rails.holes) {
    const Mouth mouth = mouth_of(scene.bed, hole.pocket, 0.1158875, 0.1285875);
    const Shot shot = sent(scene, hole.centre - mouth.outward * 0.5, hole.centre, 2);
    const auto dropped = all_of<BallPocket>(shot);
    ASSERT_EQ(dropped.size(), 1U) << number(hole.pocket);
    EXPECT_EQ(dropped[0].pocket, hole.pocket);
    const BallState gone = Timeline(shot).state(BallId{0}, shot.end_s);
    EXPECT_NEAR(length(gone.position - hole.centre), hole.radius_m, 1e-14);
    EXPECT_EQ(gone.phase, Phase::pocketed);
  }
}

TEST(Jaws, LetABallHangOnTheLip) {
  const Scene scene = jawed();
  const Hole hole = rails_of(scene).holes[3];
  const Vec2 from{0.6, 0.2};
  // The speed at which a ball stops 1 mm before the edge, found by bisection on where it stops.
  double slow = 0.1, fast = 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (slow + fast) / 2;
    (all_of<BallPocket>(sent(scene, from, hole.centre, middle)).empty() ? slow : fast) = middle;
  }
  const Shot hangs = sent(scene, from, hole.centre, slow);
  EXPECT_TRUE(all_of<BallPocket>(hangs).empty());
  const double left = length(state_after(hangs).balls[0].position - hole.centre) - hole.radius_m;
  EXPECT_GE(left, -1e-15);
  EXPECT_LT(left, 1e-9);
  EXPECT_TRUE(faults_of(scene, state_after(hangs)).empty());
}

// Where dead noses left balls of the audit: some um before a nose larger than a ball, beyond the
// line of the cushions, further from the hole than where the facings begin.
TEST(Jaws, LetABallRestBeforeALargeRoundedNose) {
  Scene scene = tables()[4].scene;
  ASSERT_EQ(tables()[4].name, "snooker");
  const Ball resting = ball(0, {0.031941962394856804, 0.89051751032514});
  EXPECT_TRUE(faults_of(scene, State{{resting}}).empty());
  EXPECT_TRUE(
      faults_of(scene, State{{ball(0, {-0.032690948444911869, -0.88928311422745243})}}).empty());
  const auto fault_at = [&](Vec2 place) {
    const auto faults = faults_of(scene, State{{ball(0, place)}});
    return faults.empty() ? "" : faults[0].what;
  };
  // A hair nearer it stands in the nose; behind the nose and behind the facing, in the rubber.
  EXPECT_EQ(fault_at({0.03195, 0.89053}).rfind("is 0.026", 0), 0U) << fault_at({0.03195, 0.89053});
  for (const Vec2 behind : {Vec2{0.081, 0.92}, Vec2{0.07, 0.93}, Vec2{0.2, 0.9}, Vec2{0, 1.1}}) {
    EXPECT_EQ(fault_at(behind).rfind("is beyond the line", 0), 0U) << fault_at(behind);
  }
}

TEST(Jaws, RattleAFastBallThatIsOffTheLine) {
  const Scene scene = jawed();
  int rattled = 0;
  int dropped = 0;
  for (int i = 0; i < 400; ++i) {
    const double off = -0.06 + 0.0003 * i;
    const Shot shot = sent(scene, {0.3, 0.5}, {1.1684 - 0.01, 0.5842 - 0.01 + off}, 6);
    int jaws = 0;
    for (const BallCushion& hit : all_of<BallCushion>(shot)) jaws += number(hit.cushion) >= 4;
    const bool down = !all_of<BallPocket>(shot).empty();
    rattled += jaws >= 2 && !down;
    dropped += down;
    EXPECT_LT(audit(scene, shot).worst_penetration_m, 1e-14) << off;
  }
  EXPECT_GT(rattled, 0);
  EXPECT_GT(dropped, 0);
}

TEST(Jaws, KeepEveryBallOnTheTableOrInAPocket) {
  const Scene scene = jawed();
  const Rails rails = rails_of(scene);
  for (std::uint32_t seed = 0; seed < 3'000; ++seed) {
    Chance chance(seed);
    const double angle = chance.between(0, 6.283185307);
    const Shot shot =
        shot_of(scene, balls({ball(0, {chance.between(-1.1, 1.1), chance.between(-0.5, 0.5)})}),
                Strike{BallId{0},
                       direction_of(angle),
                       chance.between(0.5, 12),
                       {chance.between(-0.35, 0.35), chance.between(-0.35, 0.35)}});
    for (const Ball& b : state_after(shot).balls) {
      const bool on_bed = std::abs(b.position.x) < 1.1684 && std::abs(b.position.y) < 0.5842;
      bool in_mouth = false;
      for (const Hole& hole : rails.holes) {
        const double d = length(b.position - hole.centre);
        in_mouth = in_mouth || (d >= hole.radius_m - 1e-12 && d < 2 * hole.radius_m);
      }
      ASSERT_TRUE(on_bed || in_mouth) << "seed " << seed;
    }
    const Audit checked = audit(scene, shot);
    ASSERT_LT(checked.worst_penetration_m, 1e-13) << "seed " << seed;
    ASSERT_LT(checked.worst_rise_J, 1e-12) << "seed " << seed;
    if (!state_after(shot).balls.empty()) {
      ASSERT_TRUE(faults_of(scene, state_after(shot)).empty()) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace breakshot::physics
