#include <gtest/gtest.h>

#include "tests/support/match_fold.hpp"

namespace breakshot::match {
namespace {

using support::eight_ball_settings;
using support::practice_settings;

std::string faults(const Settings& settings) {
  std::string text;
  for (const physics::Fault& fault : faults_of(settings)) {
    text += fault.field + " " + fault.what + "\n";
  }
  return text;
}

TEST(Settings, EveryPresetIsFitForBothGames) {
  for (const physics::Preset& preset : physics::presets()) {
    Settings settings = eight_ball_settings(max_race_to);
    settings.scene = preset.scene;
    EXPECT_EQ(faults(settings), "") << preset.name;
    settings = practice_settings(max_practice_seats);
    settings.scene = preset.scene;
    EXPECT_EQ(faults(settings), "") << preset.name;
  }
}

TEST(Settings, SeatsAndRaceHaveRanges) {
  Settings settings = eight_ball_settings();
  settings.seats = 3;
  settings.race_to = 0;
  EXPECT_EQ(faults(settings), "seats is 3; it must be 2\nrace_to is 0; it must be from 1 to 100\n");
  settings = practice_settings(0);
  settings.race_to = 2;
  EXPECT_EQ(faults(settings), "seats is 0; it must be from 1 to 8\nrace_to is 2; it must be 1\n");
  EXPECT_EQ(faults(practice_settings(9)), "seats is 9; it must be from 1 to 8\n");
  settings = eight_ball_settings(101);
  EXPECT_EQ(faults(settings), "race_to is 101; it must be from 1 to 100\n");
}

TEST(Settings, AnUnknownGameIsNamed) {
  Settings settings = eight_ball_settings();
  settings.game = GameKind{7};
  EXPECT_EQ(faults(settings), "game is unknown; it must be eight_ball or practice\n");
}

TEST(Settings, TheFaultsOfTheSceneComeWithTheirFields) {
  Settings settings = eight_ball_settings();
  settings.scene.ball.mass_kg = 0;
  EXPECT_NE(faults(settings).find("scene.ball.mass is 0;"), std::string::npos);
}

TEST(Settings, AMatchNeedsWhatPoolNeeds) {
  Settings settings = eight_ball_settings();
  settings.scene.pockets.reset();
  EXPECT_EQ(faults(settings), "scene.pockets are missing; a match needs pockets\n");
  settings.scene.cushions.reset();
  EXPECT_EQ(faults(settings),
            "scene.cushions are not a rectangle; a match needs a rectangle's\n"
            "scene.pockets are missing; a match needs pockets\n");
  settings = eight_ball_settings();
  settings.scene.ball_ball.reset();
  EXPECT_EQ(faults(settings),
            "scene.ballBall is missing; in a match balls must not pass through\n");
}

TEST(Settings, BallsMustComeToRest) {
  Settings settings = eight_ball_settings();
  settings.scene.bed.motion = physics::Frictionless{};
  EXPECT_EQ(faults(settings), "scene.bed.motion may never end; a match needs friction above 0\n");
}

TEST(Settings, ARackAndASpottedBallMustHaveRoom) {
  Settings settings = eight_ball_settings();
  settings.scene.bed.length_m = 1.8;
  EXPECT_EQ(faults(settings),
            "scene.bed.length is too short to spot a ball; it must be at least 64 radii of a "
            "ball\n");
  settings = eight_ball_settings();
  settings.scene.bed.width_m = 0.29;
  EXPECT_EQ(faults(settings), "scene.bed has no room for a rack; it must be longer or wider\n");
}

}  // namespace
}  // namespace breakshot::match
