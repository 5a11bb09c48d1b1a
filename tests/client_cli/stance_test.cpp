#include "client_cli/play/stance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/physics/simulate.hpp"
#include "common/physics/table.hpp"
#include "common/rules/groups.hpp"

namespace breakshot::client {
namespace {

using physics::BallId;
using physics::PocketId;
using rules::Group;

/// Seat 0 on solids with the 3 in the open, and a stripe in the way of the 5.
struct Stanza {
  physics::Scene scene = physics::presets().front().scene;
  physics::State table{{{BallId{0}, {0, 0}, {}, {}},
                        {BallId{3}, {0.6, 0.2}, {}, {}},
                        {BallId{5}, {-0.6, 0}, {}, {}},
                        {BallId{8}, {0, -0.4}, {}, {}},
                        {BallId{9}, {-0.3, 0}, {}, {}}}};
  rules::GameStatus game;
  match::GameKind kind = match::GameKind::eight_ball;

  Stanza() { game.groups = {Group::solids, Group::stripes}; }
  Moment moment() const { return {kind, scene, table, game}; }
};

TEST(Stance, AimsByAngleAndTurns) {
  Stance stance;
  EXPECT_TRUE(turn_by(stance, 1));
  EXPECT_FALSE(stance.direction);
  EXPECT_FALSE(aim_along(stance, 90));
  EXPECT_NEAR(stance.direction->x, 0, 1e-15);
  EXPECT_NEAR(stance.direction->y, 1, 1e-15);
  EXPECT_FALSE(turn_by(stance, -45.5));
  EXPECT_NEAR(degrees_of(*stance.direction), 44.5, 1e-9);
  EXPECT_NEAR(physics::length(*stance.direction), 1, 1e-15);
  EXPECT_TRUE(aim_along(stance, 1e9));
  EXPECT_NEAR(degrees_of(*stance.direction), 44.5, 1e-9);
}

TEST(Stance, AimedAtABallAndAPocketTheBallDrops) {
  Stanza at;
  at.scene.perturbation.reset();
  Stance stance;
  ASSERT_FALSE(aim_at(stance, at.moment(), BallId{3}, PocketId{3}));
  EXPECT_EQ(stance.call, (rules::Call{BallId{3}, PocketId{3}, false}));
  EXPECT_FALSE(missing(stance, at.moment()));
  const auto result = physics::simulate(at.scene, at.table,
                                        physics::Strike{rules::cue_ball, *stance.direction, 2}, {});
  bool dropped = false;
  for (const auto& event : std::get<physics::Shot>(result).events) {
    const auto* drop = std::get_if<physics::BallPocket>(&event);
    dropped =
        dropped || (drop != nullptr && drop->ball == BallId{3} && drop->pocket == PocketId{3});
  }
  EXPECT_TRUE(dropped);
}

TEST(Stance, SaysWhatIsMetFirst) {
  const Stanza at;
  Stance stance;
  ASSERT_FALSE(aim_at(stance, at.moment(), BallId{5}, std::nullopt));
  EXPECT_NE(preview(stance, at.moment())[0].find("meets the 9 ball, full"), std::string::npos);
  // Half a ball to the right of the 3's centre as seen from the cue ball: it goes to the left.
  const double distance = std::sqrt(0.6 * 0.6 + 0.2 * 0.2);
  const double aside = std::asin(at.scene.ball.radius_m / distance) * 180 / 3.14159265358979;
  ASSERT_FALSE(aim_at(stance, at.moment(), BallId{3}, std::nullopt));
  ASSERT_FALSE(turn_by(stance, -aside));
  EXPECT_NE(preview(stance, at.moment())[0].find("cut by 30 degrees to the left"),
            std::string::npos)
      << preview(stance, at.moment())[0];
  ASSERT_FALSE(aim_along(stance, 90));
  EXPECT_NE(preview(stance, at.moment())[0].find("meets no ball"), std::string::npos);
}

TEST(Stance, RefusesWhatCannotBe) {
  Stanza at;
  Stance stance;
  ASSERT_FALSE(aim_along(stance, 12));
  const Stance before = stance;
  EXPECT_TRUE(aim_at(stance, at.moment(), BallId{4}, std::nullopt));
  EXPECT_TRUE(aim_at(stance, at.moment(), BallId{3}, PocketId{5})) << "behind the cue ball";
  EXPECT_TRUE(set_speed(stance, 0));
  EXPECT_TRUE(set_speed(stance, match::max_shot_speed_m_s * 1.01));
  EXPECT_TRUE(set_call(stance, at.moment(), {BallId{9}, PocketId{0}, false})) << "not one's own";
  EXPECT_TRUE(set_call(stance, at.moment(), {BallId{8}, PocketId{0}, false})) << "too early";
  at.scene.pockets.reset();
  EXPECT_TRUE(aim_at(stance, at.moment(), BallId{3}, PocketId{3}));
  EXPECT_EQ(stance.direction, before.direction);
  EXPECT_EQ(stance.speed_m_s, before.speed_m_s);
  EXPECT_EQ(stance.call, before.call);
}

TEST(Stance, TheTipStaysOnTheBall) {
  Stanza at;
  at.scene.bed.motion = physics::Spinning{};
  Stance stance;
  EXPECT_FALSE(set_tip(stance, at.moment(), {0.3, -0.4}));
  EXPECT_EQ(stance.tip, (physics::Tip{0.3, -0.4}));
  EXPECT_NE(preview(stance, at.moment())
                .front()
                .find("the tip 0.30 R left of and 0.40 R below the centre"),
            std::string::npos);
  const auto problem = set_tip(stance, at.moment(), {0.4, 0.4});
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->find("at most 0.5 radii"), std::string::npos) << *problem;
  EXPECT_EQ(stance.tip, (physics::Tip{0.3, -0.4}));
  at.scene.bed.motion = physics::Straight{};
  EXPECT_TRUE(set_tip(stance, at.moment(), {0.1, 0}));
  EXPECT_FALSE(set_tip(stance, at.moment(), {}));
}

TEST(Stance, KnowsWhatIsMissing) {
  Stanza at;
  Stance stance;
  EXPECT_NE(missing(stance, at.moment())->find("Aim first"), std::string::npos);
  ASSERT_FALSE(aim_along(stance, 0));
  EXPECT_NE(missing(stance, at.moment())->find("call"), std::string::npos);
  ASSERT_FALSE(set_call(stance, at.moment(), {{}, {}, true}));
  EXPECT_FALSE(missing(stance, at.moment()));
  at.game.ball_in_hand = rules::BallInHand::behind_head_string;
  EXPECT_NE(missing(stance, at.moment())->find("place X Y"), std::string::npos);
}

TEST(Stance, NothingIsCalledOnTheBreakAndInPractice) {
  Stanza breaking;
  breaking.game.breaking = true;
  Stanza practice;
  practice.kind = match::GameKind::practice;
  for (const Stanza& at : {breaking, practice}) {
    Stance stance;
    EXPECT_FALSE(asks_for_call(at.moment()));
    ASSERT_FALSE(aim_at(stance, at.moment(), BallId{3}, PocketId{3}));
    EXPECT_EQ(stance.call, rules::Call{});
    EXPECT_FALSE(missing(stance, at.moment()));
  }
}

TEST(Stance, DrawsTheLinesOfAim) {
  const Stanza at;
  Stance stance;
  Picture picture;
  draw_aim(stance, at.moment(), picture);
  EXPECT_FALSE(picture.cue);
  ASSERT_FALSE(aim_at(stance, at.moment(), BallId{3}, PocketId{3}));
  draw_aim(stance, at.moment(), picture);
  ASSERT_TRUE(picture.cue);
  EXPECT_EQ(picture.cue->from, (physics::Vec2{0, 0}));
  ASSERT_EQ(picture.paths.size(), 2u);
  EXPECT_EQ(picture.paths[1].ball, BallId{3});
  // The ball's line ends in the mouth of the pocket.
  const physics::Vec2 end = picture.paths[1].points.back();
  EXPECT_GT(end.x, 1.1);
  EXPECT_GT(end.y, 0.5);
}

}  // namespace
}  // namespace breakshot::client
