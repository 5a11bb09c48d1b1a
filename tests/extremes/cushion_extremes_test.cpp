// Balls parked on cushions, in corners, wedges and lanes, and rolled at the seams of jaws.
#include "common/physics/angle.hpp"
#include "common/physics/simulation.hpp"
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

constexpr double half_length = eight_foot_length_m / 2;
constexpr double half_width = eight_foot_width_m / 2;
/// The centre of a ball that touches the left cushion.
constexpr double at_left = half_width - radius_m;

/// Where a parked ball may be: on the cushion, one ulp off and one ulp inside it.
std::vector<double> parked_places() {
  return {at_left, std::nextafter(at_left, 0.0), std::nextafter(at_left, 1.0)};
}

TEST(ParkedBall, StaysWhereItIs) {
  for (const Scene& scene : every_table()) {
    for (const double y : parked_places()) {
      const State state = balls({ball(0, {0.2, y})});
      const Shot shot = shot_of(scene, state, std::nullopt, {}, until(1));
      EXPECT_TRUE(shot.events.empty()) << name_of(scene);
      EXPECT_EQ(state_after(shot), state);
    }
  }
}

TEST(ParkedBall, StruckAlongTheCushionDoesNotMeetIt) {
  for (const Scene& scene : every_table()) {
    for (const double y : parked_places()) {
      const Shot shot = shot_of(scene, balls({ball(0, {0.2, y})}),
                                Strike{BallId{0}, {1, 0}, 0.5, {}}, {}, until(0.5));
      EXPECT_TRUE(all_of<BallCushion>(shot).empty()) << name_of(scene);
      EXPECT_EQ(state_of(shot, 0).position.y, y) << name_of(scene);
    }
  }
}

TEST(ParkedBall, StruckIntoTheCushionComesBackAtOnce) {
  for (const Scene& scene : every_table()) {
    for (const double y : parked_places()) {
      const Shot shot = shot_of(scene, balls({ball(0, {0.2, y})}),
                                Strike{BallId{0}, {0.6, 0.8}, 2, {}}, {}, until(0.1));
      const auto hits = all_of<BallCushion>(shot);
      ASSERT_GE(hits.size(), 1u) << name_of(scene);
      // One ulp off, the cushion is met as soon as that ulp is covered.
      EXPECT_LT(hits[0].time_s, 1e-15) << name_of(scene);
      EXPECT_LT(state_of(shot, 0).position.y, y) << name_of(scene);
      expect_sound(scene, shot, name_of(scene));
    }
  }
}

TEST(ParkedBall, StruckAwayLeavesTheCushionWithoutMeetingIt) {
  for (const Scene& scene : every_table()) {
    for (const double y : parked_places()) {
      const Shot shot = shot_of(scene, balls({ball(0, {0.2, y})}),
                                Strike{BallId{0}, {0.6, -0.8}, 0.4, {}}, {}, until(0.5));
      EXPECT_TRUE(all_of<BallCushion>(shot).empty()) << name_of(scene);
    }
  }
}

TEST(ParkedBall, PressedByItsSpinComesToRest) {
  // Spin alone drives a standing ball against the cushion again and again.
  for (const CushionModel& cushion : cushion_models()) {
    if (std::holds_alternative<Mirror>(cushion)) continue;
    const Scene scene = table(Spinning{}, cushion, BallFriction{});
    for (const double y : parked_places()) {
      Ball pressed = ball(0, {0.2, y});
      pressed.spin = {-100, 0, 50};
      const Shot shot = shot_of(scene, balls({pressed}));
      EXPECT_EQ(shot.stop, Stop::rest) << name_of(scene);
      EXPECT_LT(shot.events.size(), 20'000u) << name_of(scene);
      expect_sound(scene, shot, name_of(scene));
    }
  }
}

TEST(ParkedBall, HitSquarelyAgainstItsCushionLetsNothingThrough) {
  for (const Scene& scene : every_table()) {
    if (presses_for_ever(scene)) continue;
    for (const double y : parked_places()) {
      const Shot shot =
          shot_of(scene, balls({ball(0, {0.2, y}), moving(scene, 1, {0.2, -0.2}, {0, 4})}),
                  std::nullopt, {}, limits_for(scene, 2));
      expect_sound(scene, shot, name_of(scene));
      EXPECT_LE(deepest_in_rails(scene, shot, 20), 1e-12) << name_of(scene);
    }
  }
}

TEST(CornerTrap, HoldsWhateverIsShotIntoIt) {
  const Vec2 corner{half_length - radius_m, half_width - radius_m};
  for (const Scene& scene : every_table()) {
    if (presses_for_ever(scene)) continue;
    for (const double speed : {1e-3, 0.5, 8.0}) {
      const Vec2 way{-std::sqrt(0.5), -std::sqrt(0.5)};
      const Ball trapped = ball(0, corner);
      const Ball first = moving(scene, 1, corner + way * 0.2, way * -speed);
      const Ball second = moving(scene, 2, corner + way * 0.4, way * (-1.5 * speed));
      const Shot shot = shot_of(scene, balls({trapped, first, second}), std::nullopt, {},
                                limits_for(scene, 0.5 / speed));
      const std::string where = name_of(scene) + " speed " + std::to_string(speed);
      expect_sound(scene, shot, where);
      EXPECT_LE(deepest_in_rails(scene, shot, 10), 1e-12) << where;
      EXPECT_LT(shot.events.size(), 5000u) << where;
    }
  }
}

TEST(CornerTrap, AllThreeTouchingAreStruckAtOnce) {
  // A ball in the corner, frozen to both cushions, and two more frozen to it and one cushion each.
  const Vec2 corner{half_length - radius_m, half_width - radius_m};
  for (const Scene& scene : every_table()) {
    if (presses_for_ever(scene)) continue;
    const Vec2 way{-std::sqrt(0.5), -std::sqrt(0.5)};
    const Shot shot = shot_of(scene,
                              balls({ball(0, corner), ball(1, corner - Vec2{diameter_m, 0}),
                                     ball(2, corner - Vec2{0, diameter_m}),
                                     moving(scene, 3, corner + way * 0.3, way * -6)}),
                              std::nullopt, {}, limits_for(scene, 0.5));
    expect_sound(scene, shot, name_of(scene));
    EXPECT_LE(deepest_in_rails(scene, shot, 10), 1e-12) << name_of(scene);
  }
}

// ---- Wedges

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

// A storm of events: follow presses the ball into both noses of a wedge of 34 degrees, where the
// hops of the weak-contact rule become ever smaller; more than 100,000 events, where a push against
// one cushion takes some hundreds.
TEST(Wedge, DISABLED_OfDeadNosesStopsAPressedBallInAFewEvents) {
  const Squeeze squeeze(motions()[2], CushionRestitution{0, 0.9, 1e-3}, 0.3);
  Limits limits;
  limits.max_events = 20'000;
  const auto outcome = simulate(squeeze.scene, squeeze.state, std::nullopt, {}, limits);
  EXPECT_TRUE(std::holds_alternative<Shot>(outcome));
}

// ---- A bed exactly one ball wide

Scene lane(const Scene& wide) {
  Scene scene = wide;
  scene.bed.width_m = 2 * radius_m;
  return scene;
}

TEST(Lane, OfOneBallsWidthKeepsBallsInLineAndInOrder) {
  for (const Scene& wide : every_table()) {
    if (presses_for_ever(wide)) continue;
    const Scene scene = lane(wide);
    State state;
    for (std::uint32_t i = 0; i < 5; ++i) state.balls.push_back(ball(i, {-0.9 + 0.4 * i, 0}));
    const Shot shot =
        shot_of(scene, state, Strike{BallId{0}, {1, 0}, 3, {}}, {}, limits_for(scene, 3));
    expect_sound(scene, shot, name_of(scene));
    EXPECT_GE(all_of<BallBall>(shot).size(), 4u) << name_of(scene);
    const auto end = Timeline(shot).states(shot.end_s);
    for (std::size_t i = 0; i < end.size(); ++i) {
      EXPECT_NEAR(end[i].position.y, 0, 1e-15) << name_of(scene);
      if (i == 0) continue;
      EXPECT_GE(end[i].position.x - end[i - 1].position.x, diameter_m - 1e-14);
    }
  }
}

TEST(Lane, OfOneBallsWidthStandsTheGreatestNoise) {
  for (const Scene& wide : every_table()) {
    if (presses_for_ever(wide)) continue;
    Scene scene = lane(wide);
    scene.perturbation = Perturbation{1, 1};
    State state;
    for (std::uint32_t i = 0; i < 5; ++i) state.balls.push_back(ball(i, {-0.9 + 0.4 * i, 0}));
    // Normals turned by up to 45 degrees wedge balls between both cushions: passes may never end.
    expect_sound_if_stalled(scene, state, Strike{BallId{0}, {1, 0}, 3, {}}, limits_for(scene, 1),
                            name_of(scene));
  }
}

// ---- Restitution 0 and 0.01. Restitution 0 in straight motion: tests/physics/contact_test.cpp.

TEST(DeadContacts, ComeToRest) {
  for (const Motion& motion : {motions()[1], motions()[2]}) {
    for (const double e : {0.0, 0.01}) {
      for (int kind = 0; kind < 3; ++kind) {
        const std::array<BallBallModel, 3> pairs{BallRestitution{e, 1e-3},
                                                 BallFriction{e, 0.01, 0.1, 1, 1e-3},
                                                 Mathavan2014{e, 0.05, 1e-3}};
        const std::array<CushionModel, 4> noses{
            CushionRestitution{e, 1, 1e-3}, Han2005{e, 0.2, 0.0357}, Mathavan2010{e, 0.14, 0.0357},
            Stronge2000{e, 0.2, 0.0357, 1.8}};
        for (const CushionModel& nose : noses) {
          const Scene scene = table(motion, nose, pairs[static_cast<std::size_t>(kind)]);
          for (const double gap : {0.0, 1e-9, rack_gap_m}) {
            const Shot shot = shot_of(scene, racked(scene, gap), Strike{BallId{0}, {1, 0}, 8, {}});
            EXPECT_EQ(shot.stop, Stop::rest);
            expect_sound(
                scene, shot,
                name_of(scene) + " e " + std::to_string(e) + " gap " + std::to_string(gap));
          }
        }
      }
    }
  }
}

// ---- Seams of jaws

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
  curving.spin = {200, 0, 0};
  curving.spin.x = -200;
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
