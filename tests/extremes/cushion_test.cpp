// Balls parked on cushions, trapped in corners and kept in lanes; dead contacts.
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

// ---- A bed exactly one ball wide

Scene lane(const Scene& wide) {
  Scene scene = wide;
  scene.bed.width_m = 2 * radius_m;
  return scene;
}

TEST(Lane, OfOneBallsWidthKeepsBallsInLineAndInOrder) {
  for (const Scene& wide : every_table()) {
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
    // One cushion model for each model of balls, and no more: what stalls takes 10,000 passes.
    const auto& cushions = std::get<RectangleCushions>(*wide.cushions);
    if (cushions.model.index() != wide.ball_ball->index() + 1) continue;
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
          for (const double gap : {0.0, rack_gap_m}) {
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

}  // namespace
}  // namespace breakshot::physics
