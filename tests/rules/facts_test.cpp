#include "common/rules/facts.hpp"

#include <gtest/gtest.h>

#include "common/physics/rails.hpp"
#include "tests/support/shot_builder.hpp"

namespace breakshot::rules {
namespace {

using physics::BallId;
using support::club_scene;
using support::ShotBuilder;
using support::table_of;

// The club table is 2.3368 m by 1.1684 m, a ball's radius 0.028575 m: centres of balls that touch
// the foot rail (cushion 0) have x = 1.139825, those that touch the left rail (cushion 1) have
// y = 0.555625. The head string is at x = -0.5842.
constexpr double at_foot_rail = 1.139825;

Facts facts(const physics::State& before, const ShotBuilder& shot) {
  return facts_of(club_scene(), before, shot.shot());
}

TEST(Facts, AShotThatHitsNothingHasNoFirstHit) {
  const auto table = table_of({{0, {0, 0}}, {1, {0.5, 0}}});
  const Facts f = facts(table, ShotBuilder(table).reaches_rail(1, 0, 1).stops(2, 0, {0, 0.1}));
  EXPECT_FALSE(f.first_hit);
  EXPECT_TRUE(f.first_hits.empty());
  EXPECT_FALSE(f.cushion_after_contact);
}

TEST(Facts, TheFirstHitIsTheCueBallsAndNotThatOfObjectBalls) {
  const auto table = table_of({{0, {0, 0}}, {1, {0.5, 0}}, {2, {0.6, 0}}, {3, {0.8, 0}}});
  const Facts f = facts(
      table, ShotBuilder(table).hits(0.5, 1, 2).hits(0.7, 0, 3).hits(0.9, 0, 1).stops(2, 0, {}));
  EXPECT_EQ(f.first_hit, BallId{3});
  EXPECT_EQ(f.first_hits, std::vector{BallId{3}});
}

TEST(Facts, BallsHitAtTheSameInstantAreAllFirst) {
  const auto table = table_of({{0, {0, 0}}, {4, {0.5, 0.03}}, {9, {0.5, -0.03}}});
  const Facts f = facts(table, ShotBuilder(table).hits(0.5, 0, 9).hits(0.5, 0, 4).hits(0.6, 0, 9));
  EXPECT_EQ(f.first_hits, (std::vector{BallId{4}, BallId{9}}));
}

TEST(Facts, PocketedBallsStandInTheOrderInWhichTheyDropped) {
  const auto table = table_of({{0, {0, 0}}, {4, {0.5, 0}}, {9, {0.6, 0}}});
  const Facts f = facts(table, ShotBuilder(table).drops(2, 4, 3).drops(1, 9, 2).drops(3, 0, 5));
  ASSERT_EQ(f.pocketed.size(), 3u);
  EXPECT_EQ(f.pocketed[0], (Pocketed{BallId{9}, physics::PocketId{2}, 1}));
  EXPECT_EQ(f.pocketed[1], (Pocketed{BallId{4}, physics::PocketId{3}, 2}));
  EXPECT_EQ(f.pocketed[2], (Pocketed{BallId{0}, physics::PocketId{5}, 3}));
}

TEST(Facts, ACushionBeforeTheContactDoesNotCountAsOneAfterIt) {
  const auto table = table_of({{0, {0, 0}}, {1, {0.5, 0}}});
  EXPECT_FALSE(facts(table, ShotBuilder(table).reaches_rail(0.3, 0, 1).hits(0.5, 0, 1))
                   .cushion_after_contact);
  EXPECT_TRUE(facts(table, ShotBuilder(table).hits(0.5, 0, 1).reaches_rail(0.7, 0, 1))
                  .cushion_after_contact);
  EXPECT_TRUE(facts(table, ShotBuilder(table).hits(0.5, 0, 1).reaches_rail(0.7, 1, 0))
                  .cushion_after_contact);
}

TEST(Facts, ACushionMetAtTheInstantOfTheContactIsNotAfterItUnlessItFollowedFromIt) {
  const auto table = table_of({{0, {0, 0}}, {1, {0.5, 0}}});
  EXPECT_FALSE(facts(table, ShotBuilder(table).hits(0.5, 0, 1).reaches_rail(0.5, 0, 1, 0))
                   .cushion_after_contact);
  EXPECT_TRUE(facts(table, ShotBuilder(table).hits(0.5, 0, 1).reaches_rail(0.5, 0, 1, 1))
                  .cushion_after_contact);
}

TEST(Rule8_4, ABallFrozenToARailIsNotDrivenToItByStaying) {
  const auto table = table_of({{0, {0, 0}}, {1, {at_foot_rail, 0}}});
  const Facts f = facts(table, ShotBuilder(table).hits(0.5, 0, 1).reaches_rail(0.5, 1, 0, 1));
  EXPECT_FALSE(f.cushion_after_contact);
  EXPECT_TRUE(f.object_balls_to_cushion.empty());
}

TEST(Rule8_4, ABallWithinAMicrometreOfARailIsFrozenToItAndOneFartherOffIsNot) {
  for (const auto& [gap_m, driven] : {std::pair{0.9e-6, false}, std::pair{1.1e-6, true}}) {
    const auto table = table_of({{0, {0, 0}}, {1, {at_foot_rail - gap_m, 0}}});
    const Facts f = facts(table, ShotBuilder(table)
                                     .hits(0.5, 0, 1)
                                     .moves(0.5, 1, {at_foot_rail - gap_m, 0}, {1e-3, 0})
                                     .reaches_rail(0.502, 1, 0));
    EXPECT_EQ(f.cushion_after_contact, driven) << gap_m;
  }
}

TEST(Rule8_4, AFrozenBallThatLeavesAndReturnsIsDrivenToTheRail) {
  const auto table = table_of({{0, {0, 0}}, {1, {at_foot_rail, 0}}});
  const Facts f = facts(table, ShotBuilder(table)
                                   .hits(0.5, 0, 1)
                                   .reaches_rail(0.5, 1, 0, 1)
                                   .moves(0.5, 1, {at_foot_rail, 0}, {-0.2, 0})
                                   .hits(0.6, 1, 2)
                                   .moves(0.6, 1, {at_foot_rail - 0.02, 0}, {0.2, 0})
                                   .reaches_rail(0.7, 1, 0));
  EXPECT_TRUE(f.cushion_after_contact);
  EXPECT_EQ(f.object_balls_to_cushion, std::vector{BallId{1}});
}

TEST(Rule8_4, AFrozenBallThatReturnsWithinOneCurvedSegmentHasLeft) {
  const auto table = table_of({{0, {0, 0}}, {1, {at_foot_rail, 0}}});
  const Facts f = facts(table, ShotBuilder(table)
                                   .hits(0.5, 0, 1)
                                   .moves(0.5, 1, {at_foot_rail, 0}, {-0.2, 0}, {2, 0})
                                   .reaches_rail(0.7, 1, 0));
  EXPECT_TRUE(f.cushion_after_contact);
}

TEST(Rule8_4, TheJawsOfPocketsAreRails) {
  physics::Scene scene = support::club_scene();
  scene.pockets = physics::JawedPockets{};
  const physics::RailArc jaw = physics::rails_of(scene).arcs.at(0);
  const physics::Vec2 middle = jaw.nose.from + jaw.nose.to;
  const physics::Vec2 outward = middle / physics::length(middle);
  const double touching_m = jaw.nose.radius_m + scene.ball.radius_m;
  for (const auto& [gap_m, driven] : {std::pair{0.0, false}, std::pair{1e-3, true}}) {
    const physics::Vec2 place = jaw.nose.centre + outward * (touching_m + gap_m);
    const auto table = table_of({{0, {0, 0}}, {1, place}});
    const physics::Shot shot = ShotBuilder(table)
                                   .hits(0.5, 0, 1)
                                   .moves(0.5, 1, place, outward * -0.1)
                                   .reaches_rail(0.51, 1, physics::number(jaw.id))
                                   .shot();
    EXPECT_EQ(facts_of(scene, table, shot).cushion_after_contact, driven) << gap_m;
  }
}

TEST(Rule8_4, ABallFrozenToOneRailIsDrivenToAnother) {
  const auto table = table_of({{0, {0, 0}}, {1, {at_foot_rail, 0}}});
  const Facts f = facts(table, ShotBuilder(table)
                                   .hits(0.5, 0, 1)
                                   .moves(0.5, 1, {at_foot_rail, 0}, {0, 1})
                                   .reaches_rail(1.0, 1, 1));
  EXPECT_TRUE(f.cushion_after_contact);
}

TEST(Rule8_4, ACueBallFrozenToARailMustLeaveItToo) {
  const auto table = table_of({{0, {at_foot_rail, 0}}, {1, {at_foot_rail, 0.1}}});
  ShotBuilder along(table);
  along.moves(0, 0, {at_foot_rail, 0}, {0, 1}).hits(0.04285, 0, 1).reaches_rail(0.1, 0, 0);
  EXPECT_FALSE(facts(table, along).cushion_after_contact);
}

TEST(Facts, ObjectBallsAtCushionsAreCountedOnceEach) {
  const auto table = table_of({{0, {0, 0}}, {1, {0.5, 0}}, {2, {0.6, 0}}});
  const Facts f = facts(table, ShotBuilder(table)
                                   .hits(0.5, 0, 1)
                                   .reaches_rail(0.6, 2, 0)
                                   .reaches_rail(0.7, 1, 0)
                                   .reaches_rail(0.8, 1, 1)
                                   .reaches_rail(0.9, 0, 1));
  EXPECT_EQ(f.object_balls_to_cushion, (std::vector{BallId{1}, BallId{2}}));
}

TEST(Rule6_11, TheCueBallCrossesTheHeadStringOnlyIfItDoesSoBeforeItsFirstContact) {
  const auto table = table_of({{0, {-0.8, 0}}, {1, {-0.7, 0.3}}});
  const auto over_and_back = [&](double turn_x) {
    return ShotBuilder(table)
        .moves(0, 0, {-0.8, 0}, {1, 0})
        .moves(turn_x + 0.8, 0, {turn_x, 0}, {-1, 0})
        .hits(0.6, 0, 1);
  };
  EXPECT_TRUE(facts(table, over_and_back(-0.58)).crossed_head_string_before_contact);
  EXPECT_FALSE(facts(table, over_and_back(-0.59)).crossed_head_string_before_contact);
}

TEST(Rule6_11, ACrossingThatDeceleratesAndTurnsWithinOneSegmentIsSeen) {
  const auto table = table_of({{0, {-0.8, 0}}, {1, {-0.9, 0}}});
  const auto turning = [&](double speed) {
    return ShotBuilder(table).moves(0, 0, {-0.8, 0}, {speed, 0}, {-1, 0}).hits(2 * speed, 0, 1);
  };
  // The farthest point is 0.5 speed^2 from the start; the string is 0.2158 m away.
  EXPECT_FALSE(facts(table, turning(0.65)).crossed_head_string_before_contact);
  EXPECT_TRUE(facts(table, turning(0.66)).crossed_head_string_before_contact);
}

TEST(Rule6_11, ACrossingAfterTheContactDoesNotCount) {
  const auto table = table_of({{0, {-0.8, 0}}, {1, {-0.7, 0}}});
  const Facts f = facts(
      table,
      ShotBuilder(table).moves(0, 0, {-0.8, 0}, {1, 0}).hits(0.04285, 0, 1).stops(2, 0, {0.5, 0}));
  EXPECT_FALSE(f.crossed_head_string_before_contact);
  EXPECT_FALSE(f.first_hit_beyond_head_string);
}

TEST(Rule6_11, ABallExactlyOnTheHeadStringIsNotBehindIt) {
  const double string_x = physics::head_string_x(club_scene().bed);
  const auto table = table_of({{0, {-0.8, 0}}, {1, {string_x, 0}}, {2, {string_x - 1e-9, 0.3}}});
  EXPECT_TRUE(facts(table, ShotBuilder(table).hits(0.5, 0, 1)).first_hit_beyond_head_string);
  EXPECT_FALSE(facts(table, ShotBuilder(table).hits(0.5, 0, 2)).first_hit_beyond_head_string);
}

}  // namespace
}  // namespace breakshot::rules
