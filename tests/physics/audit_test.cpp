// That the audit finds what must not happen, and nothing else.
#include "common/physics/audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

/// One ball into another, on the way from the far end of the table to near its middle.
struct LongWay {
  Scene scene = table(Straight{0.08131081722676754, 0.010704792208271103, 1.0892895269207656},
                      Mirror{}, Elastic{});
  Shot shot = shot_of(
      scene,
      balls({ball(0, {-0.9464352354814997, 0.3566713469735929}),
             ball(1, {-0.023448576345644012, -0.11090617885957471})}),
      Strike{BallId{0}, {0.8941814363739011, -0.44770476750232074}, 1.0705423127114773, {}});

  /// The segment with which a ball leaves the hit.
  Segment& after_hit(BallId ball) {
    const double hit = all_of<BallBall>(shot).at(0).time_s;
    return *std::find_if(shot.segments.begin(), shot.segments.end(),
                         [&](const Segment& s) { return s.ball == ball && s.start_s == hit; });
  }
};

// Where the balls meet, a tenth of the way out, doubles are eight times as fine as where the first
// came from: an audit counted the rounding of its path as an overlap.
TEST(Audit, KnowsThatAPathIsNoMoreExactThanItsStart) {
  const LongWay hit;
  const Audit found = audit(hit.scene, hit.shot);
  EXPECT_GT(found.worst_penetration_m, 3.5e-16);
  EXPECT_EQ(found.worst_excess_m, 0);
}

TEST(Audit, FindsAnOverlapThatRoundingDoesNotExplain) {
  LongWay hit;
  hit.after_hit(BallId{1}).position.x -= 1e-14;
  const Audit found = audit(hit.scene, hit.shot);
  EXPECT_GT(found.worst_excess_m, 5e-15);
  EXPECT_LT(found.worst_excess_m, 1e-14);
}

TEST(Audit, FindsEnergyThatRises) {
  LongWay hit;
  const double speed = length(hit.after_hit(BallId{1}).velocity);
  hit.after_hit(BallId{1}).velocity = hit.after_hit(BallId{1}).velocity * (1 + 1e-9);
  const double gift = hit.scene.ball.mass_kg * speed * speed * 1e-9;
  EXPECT_NEAR(audit(hit.scene, hit.shot).worst_rise_J, gift, gift * 1e-3);
}

}  // namespace
}  // namespace breakshot::physics
