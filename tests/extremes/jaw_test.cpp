// Balls rolled at the seams of jaws, and from beside a cushion back to it.
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

TEST(JawSeam, RolledAtExactlyNeverLetsABallThrough) {
  const Scene scene = full_table();
  const Rails rails = rails_of(scene);
  for (const RailArc& arc : rails.arcs) {
    for (const Vec2 seam : {arc.nose.from, arc.nose.to}) {
      // The centre of a ball that touches both the straight nose and the rounded one.
      const Vec2 place = arc.nose.centre + seam * (arc.nose.radius_m + radius_m);
      for (int turn = -4; turn <= 4; ++turn) {
        for (const double off : {0.0, 1e-17, -1e-17, 1e-15, -1e-15, 1e-12, -1e-12, 1e-6, -1e-6}) {
          const Vec2 back = seam * std::cos(0.3 * turn) + perp(seam) * std::sin(0.3 * turn);
          const Vec2 from = place + back * 0.06 + perp(back) * off;
          const State state = balls({moving(scene, 0, from, back * -2)});
          if (!faults_of(scene, state).empty()) continue;
          const Shot shot = shot_of(scene, state);
          EXPECT_LE(deepest_in_rails(scene, shot, 30), 1e-12)
              << "jaw " << number(arc.id) << " turn " << turn << " off " << off;
          expect_sound(scene, shot, "jaw");
        }
      }
    }
  }
}

TEST(JawSeam, ABallFromTheRoundedNoseThatCurvesBackMeetsTheCushion) {
  // With follow off the rounded nose, aimed so that it curves back to the cushion beside it.
  const Scene scene = full_table();
  const Rails rails = rails_of(scene);
  for (std::uint32_t seed = 0; seed < 2'000; ++seed) {
    Chance chance(seed);
    const RailArc& arc = rails.arcs[chance.below(rails.arcs.size())];
    const Vec2 middle = arc.nose.from + arc.nose.to;
    const Vec2 out = middle * (1 / length(middle));
    const double turn = chance.between(-1.2, 1.2);
    const Vec2 back = out * std::cos(turn) + perp(out) * std::sin(turn);
    Ball spun = ball(0, arc.nose.centre + back * (arc.nose.radius_m + radius_m + 0.02),
                     back * -chance.between(0.3, 3));
    spun.spin = {chance.between(-300, 300), chance.between(-300, 300), chance.between(-100, 100)};
    if (!faults_of(scene, balls({spun})).empty()) continue;
    const Shot shot = shot_of(scene, balls({spun}));
    EXPECT_LE(deepest_in_rails(scene, shot, 30), 1e-12) << "seed " << seed;
    expect_sound(scene, shot, "seed " + std::to_string(seed));
  }
}

TEST(Cushion, IsMetByABallThatComesFromBehindItsLineAndTurnsBack) {
  Scene scene = carpet(Elastic{});
  scene.cushions = FreeCushions{{{{0, 1}, {-1, 1}, Mirror{}}}, {}};
  // Beside the end of the cushion and beyond the line of contact; its spin turns it back.
  Ball curving = ball(0, {0.02, 0.99}, {-0.3, -0.4});
  curving.spin = {-200, 0, 0};
  const Shot shot = shot_of(scene, balls({curving}));
  ASSERT_GE(all_of<BallCushion>(shot).size(), 1u);
  const double t = all_of<BallCushion>(shot)[0].time_s;
  EXPECT_NEAR(state_of(shot, 0, t).position.y, 1 - radius_m, 1e-15);
  EXPECT_LT(state_of(shot, 0, t).position.x, 0);
}

TEST(Cushion, IsMetByABallThatTouchesItsLineBesideItAndTurnsBack) {
  Scene scene = carpet(Elastic{});
  scene.cushions = FreeCushions{{{{0, 1}, {-1, 1}, Mirror{}}}, {}};
  Ball curving = ball(0, {1e-9, 1 - radius_m}, {-0.3, -0.4});
  curving.spin = {-200, 0, 0};
  const Shot shot = shot_of(scene, balls({curving}));
  ASSERT_GE(all_of<BallCushion>(shot).size(), 1u);
  EXPECT_NEAR(state_of(shot, 0, all_of<BallCushion>(shot)[0].time_s).position.y, 1 - radius_m,
              1e-15);
}

}  // namespace
}  // namespace breakshot::physics
