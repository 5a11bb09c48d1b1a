// What contacts do: one at a time, weak ones, and sets of simultaneous ones.
#include <algorithm>
#include <cmath>
#include <map>

#include "common/physics/audit.hpp"
#include "common/physics/simulation.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

constexpr double diameter = 0.05715;

Vec2 velocity_after(const Shot& shot, std::uint32_t id) {
  return Timeline(shot).state(BallId{id}, shot.end_s).velocity;
}

TEST(BallBall, ElasticHeadOnSwapsVelocities) {
  const Shot shot = shot_of(gas(), balls({ball(0, {0, 0}, {3, 0}), ball(1, {1, 0}, {-1, 0})}),
                            std::nullopt, {}, until(1));
  EXPECT_EQ(velocity_after(shot, 0), (Vec2{-1, 0}));
  EXPECT_EQ(velocity_after(shot, 1), (Vec2{3, 0}));
}

TEST(BallBall, ElasticCutLeavesAtRightAngles) {
  const double offset = diameter * 0.5;  // a half-ball hit: 30 degrees
  const Shot shot = shot_of(gas(), balls({ball(0, {0, offset}, {2, 0}), ball(1, {1, 0})}),
                            std::nullopt, {}, until(2));
  const Vec2 cue = velocity_after(shot, 0);
  const Vec2 object = velocity_after(shot, 1);
  EXPECT_NEAR(dot(cue, object), 0, 1e-14);
  EXPECT_NEAR(object.x, 2 * 0.75, 1e-13);
  EXPECT_NEAR(object.y, -2 * 0.5 * std::sqrt(0.75), 1e-13);
  EXPECT_NEAR(dot(cue, cue) + dot(object, object), 4, 1e-14);
}

TEST(BallBall, RestitutionKeepsThatShareOfTheApproach) {
  Scene scene = gas();
  scene.ball_ball = BallRestitution{0.9, 1e-3};
  const Shot shot =
      shot_of(scene, balls({ball(0, {0, 0}, {3, 0}), ball(1, {1, 0})}), std::nullopt, {}, until(1));
  EXPECT_NEAR(velocity_after(shot, 1).x - velocity_after(shot, 0).x, 0.9 * 3, 1e-15);
  EXPECT_NEAR(velocity_after(shot, 1).x + velocity_after(shot, 0).x, 3, 1e-15);
}

TEST(BallBall, AbsentLetsBallsPassThroughOneAnother) {
  Scene scene = gas();
  scene.ball_ball.reset();
  const Shot shot =
      shot_of(scene, balls({ball(0, {0, 0}, {3, 0}), ball(1, {1, 0})}), std::nullopt, {}, until(1));
  EXPECT_TRUE(shot.events.empty());
  EXPECT_EQ(velocity_after(shot, 0), (Vec2{3, 0}));
}

TEST(BallCushion, MirrorReflects) {
  const Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  const Shot shot = shot_of(scene, balls({ball(0, {1, 0}, {1, 0.25})}), std::nullopt, {}, until(1));
  ASSERT_EQ(all_of<BallCushion>(shot).size(), 1u);
  EXPECT_EQ(all_of<BallCushion>(shot)[0].cushion, CushionId{0});
  EXPECT_EQ(velocity_after(shot, 0), (Vec2{-1, 0.25}));
}

TEST(BallCushion, RestitutionActsAlongAndAcross) {
  const Scene scene = table(Frictionless{}, CushionRestitution{0.8, 0.9, 1e-3}, Elastic{});
  const Shot shot =
      shot_of(scene, balls({ball(0, {0, 0.4}, {0.5, 2})}), std::nullopt, {}, until(0.3));
  EXPECT_EQ(all_of<BallCushion>(shot).at(0).cushion, CushionId{1});
  EXPECT_NEAR(velocity_after(shot, 0).x, 0.45, 1e-15);
  EXPECT_NEAR(velocity_after(shot, 0).y, -1.6, 1e-15);
}

TEST(BallCushion, InACornerBothReflectAsOneSet) {
  const Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  const double x = eight_foot_length_m / 2 - 0.028575;
  const double y = eight_foot_width_m / 2 - 0.028575;
  const Shot shot =
      shot_of(scene, balls({ball(0, {x - 0.25, y - 0.25}, {1, 1})}), std::nullopt, {}, until(0.5));
  const auto hits = all_of<BallCushion>(shot);
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0].time_s, hits[1].time_s, 1e-15);
  EXPECT_EQ(velocity_after(shot, 0), (Vec2{-1, -1}));
}

TEST(Pockets, TakeTheBallAtTheirMouths) {
  Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  scene.pockets = StandardPockets{};
  const std::map<std::uint32_t, Vec2> shots = {{0, {-2, -1}}, {1, {0, -1}}, {2, {2, -1}},
                                               {3, {2, 1}},   {4, {0, 1}},  {5, {-2, 1}}};
  for (const auto& [pocket, direction] : shots) {
    const Shot shot =
        shot_of(scene, balls({ball(7, {0, 0}, direction)}), std::nullopt, {}, until(5));
    const auto drops = all_of<BallPocket>(shot);
    ASSERT_EQ(drops.size(), 1u) << pocket;
    EXPECT_EQ(number(drops[0].pocket), pocket);
    EXPECT_EQ(shot.stop, Stop::rest);
    EXPECT_EQ(Timeline(shot).state(BallId{7}, 5).phase, Phase::pocketed);
    EXPECT_TRUE(state_after(shot).balls.empty());
  }
}

TEST(Pockets, EndWhereTheirMouthsEnd) {
  Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  scene.pockets = StandardPockets{};
  const double corner = 0.1158875 / std::sqrt(2.0);
  const auto drops = [&](Vec2 position, Vec2 velocity) {
    const Shot shot =
        shot_of(scene, balls({ball(0, position, velocity)}), std::nullopt, {}, until(1));
    return !all_of<BallPocket>(shot).empty();
  };
  const double half_length = eight_foot_length_m / 2;
  const double half_width = eight_foot_width_m / 2;
  EXPECT_TRUE(drops({half_length - corner + 1e-9, 0}, {0, 1}));
  EXPECT_FALSE(drops({half_length - corner - 1e-9, 0}, {0, 1}));
  EXPECT_TRUE(drops({0, half_width - corner + 1e-9}, {-2, 0}));
  EXPECT_FALSE(drops({0, half_width - corner - 1e-9}, {-2, 0}));
  EXPECT_TRUE(drops({0.1285875 / 2 - 1e-9, 0}, {0, -1}));
  EXPECT_FALSE(drops({0.1285875 / 2 + 1e-9, 0}, {0, -1}));
}

// ---- Weak contacts

TEST(WeakContact, SeparatesAtTheApproachBelowTheBound) {
  Scene scene = gas();
  scene.ball_ball = BallRestitution{0.5, 1e-3};
  for (const double s : {1e-12, 1e-6, 4e-4, 9e-4, 1.5e-3, 3e-3, 0.1}) {
    const Shot shot = shot_of(scene, balls({ball(0, {0, 0}, {s, 0}), ball(1, {diameter, 0})}),
                              std::nullopt, {}, until(0.01));
    const double expected = std::max(0.5 * s, std::min(s, 1e-3));
    EXPECT_NEAR((velocity_after(shot, 1) - velocity_after(shot, 0)).x, expected, 1e-15 * s) << s;
  }
}

TEST(WeakContact, APushTakesABoundedNumberOfHops) {
  // The ball behind slides to the left of the line of centres' normal and is held back less than
  // the one in front: the pair would close for ever.
  Scene scene = cloth();
  scene.ball_ball = BallRestitution{0.9, 1e-3};
  const Shot shot =
      shot_of(scene, balls({ball(0, {0, 0}, {0.998, 0}), ball(1, {diameter, 0}, {0.998, 0.2})}));
  const Audit found = audit(scene, shot);
  EXPECT_LE(found.worst_rise_J, 1e-15);
  EXPECT_LE(found.worst_penetration_m, 1e-14);
  EXPECT_GT(all_of<BallBall>(shot).size(), 1u);
  EXPECT_LT(shot.events.size(), 2000u);
}

TEST(WeakContact, ElasticBallsPressedTogetherByTheirFrictionHop) {
  // They slow down in different directions, so that the slower one is in the way of the other.
  const State state = balls({ball(3, {0, 0}, {0.99, 0}), ball(5, {diameter, 0}, {0.99, 0.15})});
  const Shot shot = shot_of(cloth(), state);
  EXPECT_EQ(shot.stop, Stop::rest);
  EXPECT_LT(shot.events.size(), 50u);
  EXPECT_FALSE(all_of<BallBall>(shot).empty());
  EXPECT_EQ(audit(cloth(), shot).worst_rise_J, 0);
}

TEST(WeakContact, ElasticBallsWhoseNormalsAreTurnedHopSinceVersion3) {
  Scene scene = cloth();
  const State state = balls({ball(3, {0, 0}, {0.99, 0}), ball(5, {diameter, 0}, {0.99, 0.15})});
  scene.perturbation = Perturbation{1e-9, 0};
  Limits limits;
  EXPECT_TRUE(std::holds_alternative<Shot>(simulate(scene, state, std::nullopt, {}, limits)));
  limits.physics = 2;
  EXPECT_TRUE(std::holds_alternative<Stalled>(simulate(scene, state, std::nullopt, {}, limits)));
}

TEST(WeakContact, RestitutionZeroEndsInRest) {
  Scene scene = table(Straight{}, CushionRestitution{0, 0.5, 1e-3}, BallRestitution{0, 1e-3});
  const Shot shot = shot_of(scene, racked(scene, rack_gap_m), Strike{BallId{0}, {1, 0}, 8});
  EXPECT_EQ(shot.stop, Stop::rest);
  const Audit found = audit(scene, shot);
  EXPECT_LE(found.worst_rise_J, 1e-14);
  EXPECT_LE(found.worst_penetration_m, 1e-13);
}

// ---- Sets

TEST(Cradle, PassesTheStrokeOnBallByBall) {
  for (const std::uint32_t n : {3u, 5u, 15u}) {
    State state{{ball(0, {0, 0}, {2, 0})}};
    for (std::uint32_t i = 1; i < n; ++i) state.balls.push_back(ball(i, {1 + i * diameter, 0}));
    // Decimal multiples of the diameter leave gaps of an ulp; the row is set end to end.
    for (std::uint32_t i = 2; i < n; ++i) {
      state.balls[i].position.x = state.balls[i - 1].position.x + diameter;
    }
    const Shot shot = shot_of(gas(), state, std::nullopt, {}, until(2));
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      EXPECT_NEAR(velocity_after(shot, i).x, 0, 1e-15) << i << " of " << n;
    }
    EXPECT_NEAR(velocity_after(shot, n - 1).x, 2, 1e-15);
    const auto hits = all_of<BallBall>(shot);
    ASSERT_EQ(hits.size(), n - 1);
    for (std::uint32_t i = 0; i + 1 < n; ++i) EXPECT_EQ(hits[i].lower, BallId{i});
  }
}

TEST(Set, TwoBallsIntoOneAtOneInstantKeepTheMirror) {
  const double y = 0.04;
  const Shot shot =
      shot_of(gas(), balls({ball(0, {-1, y}, {2, 0}), ball(1, {-1, -y}, {2, 0}), ball(2, {0, 0})}),
              std::nullopt, {}, until(1));
  ASSERT_EQ(all_of<BallBall>(shot).size(), 2u);
  EXPECT_EQ(all_of<BallBall>(shot)[0].time_s, all_of<BallBall>(shot)[1].time_s);
  EXPECT_NEAR(velocity_after(shot, 2).y, 0, 1e-15);
  EXPECT_NEAR(velocity_after(shot, 0).x, velocity_after(shot, 1).x, 1e-15);
  EXPECT_NEAR(velocity_after(shot, 0).y, -velocity_after(shot, 1).y, 1e-15);
  const Audit found = audit(gas(), shot);
  EXPECT_NEAR(found.energy_end_J, found.energy_start_J, 1e-15);
}

TEST(Set, OfDifferingRestitutionTakesTheSmallest) {
  // Between an elastic neighbour and a dead cushion, hit by both at once.
  Scene scene = gas();
  scene.cushions = FreeCushions{{{{1, -1}, {1, 1}, CushionRestitution{0, 1, 0}}}};
  const double x = 1 - diameter / 2;
  const Shot shot =
      shot_of(scene, balls({ball(0, {x - diameter, 0}, {2, 0}), ball(1, {x, 0}, {1, 0})}),
              std::nullopt, {}, until(1e-9));
  ASSERT_GE(shot.events.size(), 2u);
  EXPECT_EQ(shot.events[0], (Event{BallBall{0, 0, BallId{0}, BallId{1}}}));
  EXPECT_EQ(shot.events[1], (Event{BallCushion{0, 0, BallId{1}, CushionId{0}}}));
  EXPECT_NEAR(velocity_after(shot, 0).x, 0, 1e-15);
  EXPECT_NEAR(velocity_after(shot, 1).x, 0, 1e-15);
}

/// The velocities right after the set of a head-on break of a rack without gaps.
std::vector<BallState> after_frozen_break(const Scene& scene, const State& state) {
  Simulation simulation(scene, state, Strike{BallId{0}, {1, 0}, 8}, {}, until(1));
  simulation.advance_to(0.15);
  const Shot& shot = simulation.shot();
  return Timeline(shot).states(time_of(shot.events.back()));
}

TEST(FrozenRack, KeepsMirrorSymmetryAndEnergy) {
  Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  const State state = racked(scene, 0);
  const auto after = after_frozen_break(scene, state);
  double energy = 0;
  for (const BallState& here : after) {
    energy += dot(here.velocity, here.velocity);
    const auto mirrored = std::find_if(after.begin(), after.end(), [&](const BallState& other) {
      return length(Vec2{other.position.x, -other.position.y} - here.position) < 1e-6;
    });
    ASSERT_NE(mirrored, after.end());
    EXPECT_NEAR(mirrored->velocity.x, here.velocity.x, 1e-12);
    EXPECT_NEAR(mirrored->velocity.y, -here.velocity.y, 1e-12);
  }
  EXPECT_NEAR(energy / 64, 1, 1e-14);
}

TEST(FrozenRack, DoesNotDependOnTheNumbering) {
  Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  const State state = racked(scene, 0);
  const auto reference = after_frozen_break(scene, state);
  Chance chance(17);
  for (int round = 0; round < 20; ++round) {
    // renamed[i] is the new id of ball i; the cue ball keeps its own.
    std::vector<std::uint32_t> renamed(16);
    for (std::uint32_t i = 0; i < 16; ++i) renamed[i] = i;
    for (std::size_t i = 15; i > 1; --i) std::swap(renamed[i], renamed[1 + chance.below(i)]);
    State shuffled = state;
    for (std::size_t i = 0; i < 16; ++i) shuffled.balls[i].id = BallId{renamed[i]};
    const auto after = after_frozen_break(scene, shuffled);
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_EQ(after[renamed[i]].velocity, reference[i].velocity) << "ball " << i;
    }
  }
}

TEST(FrozenRack, HitOffCentreKeepsEnergy) {
  Scene scene = table(Frictionless{}, Mirror{}, Elastic{});
  for (const double offset : {1e-9, 1e-3, 0.01, 0.03, 0.05}) {
    State state = racked(scene, 0);
    state.balls[0].position.y = offset;
    const Shot shot = shot_of(scene, state, Strike{BallId{0}, {1, 0}, 8}, {}, until(0.2));
    const Audit found = audit(scene, shot);
    EXPECT_NEAR(found.energy_end_J / found.energy_start_J, 1, 1e-14) << offset;
    EXPECT_LE(found.worst_penetration_m, 2e-14) << offset;
  }
}

TEST(Stalled, NamesTheBallsOfAContactThatNeitherPartsNorLetsTimePass) {
  // Touching, without relative velocity, pressed together by their friction, and told not to hop.
  Scene scene = cloth();
  scene.ball_ball = BallRestitution{0.95, 0};
  const auto outcome =
      simulate(scene, balls({ball(3, {0, 0}, {0.99, 0}), ball(5, {diameter, 0}, {0.99, 0.15})}),
               std::nullopt, {}, {});
  const auto* stalled = std::get_if<Stalled>(&outcome);
  ASSERT_NE(stalled, nullptr);
  EXPECT_EQ(stalled->cause, StallCause::instant);
  EXPECT_EQ(stalled->balls, (std::vector{BallId{3}, BallId{5}}));
}

// ---- Breaks

TEST(Breaks, TenThousandKeepEveryBallApartAndEnergyFalling) {
  constexpr double gaps[] = {rack_gap_m, 1e-3, 1e-5, 1e-9, 1e-13, 0};
  std::size_t events = 0;
  for (std::uint32_t seed = 0; seed < 10'000; ++seed) {
    Chance chance(seed);
    const bool elastic = seed % 4 == 0;
    Scene scene = table(Straight{0.2, 0.01, chance.between(0, 2)},
                        elastic ? CushionModel{Mirror{}} : CushionModel{CushionRestitution{}},
                        elastic ? BallBallModel{Elastic{}} : BallBallModel{BallRestitution{}});
    scene.pockets = StandardPockets{};
    if (chance.coin()) scene.perturbation = Perturbation{1e-3, 1e-3};
    State state = racked(scene, gaps[seed % 6]);
    state.balls[0].position.y = chance.between(-0.3, 0.3);
    const Vec2 aim = state.balls[1].position - state.balls[0].position;
    const double angle = std::atan2(aim.y, aim.x) + chance.between(-0.03, 0.03);
    const Strike strike{BallId{0}, {std::cos(angle), std::sin(angle)}, chance.between(1, 12)};
    const auto outcome = simulate(scene, state, strike, seed_of(seed), {20'000, {}});
    const auto* shot = std::get_if<Shot>(&outcome);
    ASSERT_NE(shot, nullptr) << "seed " << seed << " stalled";
    const Audit found = audit(scene, *shot);
    // Energy to some ulps of what the strike brought; overlap to the stated bound,
    // 8 ulp(coordinate) + 2 v ulp(t), at most 12 m/s and 128 s here.
    ASSERT_LE(found.worst_rise_J, 1e-14 * found.energy_start_J) << "seed " << seed;
    ASSERT_LE(found.worst_penetration_m, 8 * ulp(1.2) + 2 * 12 * ulp(shot->end_s))
        << "seed " << seed;
    events += shot->events.size();
  }
  EXPECT_GT(events, 400'000u);
}

}  // namespace
}  // namespace breakshot::physics
