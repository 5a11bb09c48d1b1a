#include "client_cli/playback.hpp"

#include <gtest/gtest.h>

#include "client_cli/play_shot.hpp"

namespace breakshot::client {
namespace {

Playback three_events(double speed = 1) {
  return {10, {0, 2, 5}, speed};
}

TEST(Playback, RunsInRealTimeUnlessToldOtherwise) {
  Playback playback = three_events();
  playback.advance(1.5);
  EXPECT_DOUBLE_EQ(playback.time_s(), 1.5);
  Playback fast = three_events(4);
  fast.advance(1.5);
  EXPECT_DOUBLE_EQ(fast.time_s(), 6);
}

TEST(Playback, StopsAtTheEnd) {
  Playback playback = three_events(16);
  playback.advance(1);
  EXPECT_EQ(playback.time_s(), 10);
  EXPECT_TRUE(playback.at_end());
}

TEST(Playback, StandsStillWhilePausedAndGoesOnFromThere) {
  Playback playback = three_events();
  playback.advance(1);
  playback.toggle_pause();
  playback.advance(100);
  EXPECT_DOUBLE_EQ(playback.time_s(), 1);
  playback.toggle_pause();
  playback.advance(1);
  EXPECT_DOUBLE_EQ(playback.time_s(), 2);
}

TEST(Playback, StartsAgainWhereItWasPausedAtTheEnd) {
  Playback playback = three_events();
  playback.pause();
  playback.seek(10);
  playback.toggle_pause();
  EXPECT_EQ(playback.time_s(), 0);
  EXPECT_FALSE(playback.paused());
}

TEST(Playback, KeepsItsSpeedWithinTheLimits) {
  Playback playback = three_events();
  for (int i = 0; i < 10; ++i) playback.faster();
  EXPECT_EQ(playback.speed(), max_speed);
  for (int i = 0; i < 20; ++i) playback.slower();
  EXPECT_EQ(playback.speed(), min_speed);
  EXPECT_EQ(three_events(1000).speed(), max_speed);
}

TEST(Playback, StepsFromEventToEventAndPauses) {
  Playback playback = three_events();
  playback.step_forward();
  EXPECT_EQ(playback.time_s(), 2);
  EXPECT_TRUE(playback.paused());
  playback.step_forward();
  EXPECT_EQ(playback.time_s(), 5);
  playback.step_forward();
  EXPECT_EQ(playback.time_s(), 10);
  for (const double expected : {5, 2, 0, 0}) {
    playback.step_back();
    EXPECT_EQ(playback.time_s(), expected);
  }
}

TEST(Playback, SeeksWithinTheShot) {
  Playback playback = three_events();
  playback.seek(-1);
  EXPECT_EQ(playback.time_s(), 0);
  playback.seek(3.25);
  EXPECT_EQ(playback.time_s(), 3.25);
  playback.seek(11);
  EXPECT_EQ(playback.time_s(), 10);
}

TEST(Playback, AShotWithoutTimeIsOverAtOnce) {
  const Playback playback(0, {0});
  EXPECT_TRUE(playback.at_end());
}

TEST(Playback, KeysDoWhatTheHelpSays) {
  Playback playback = three_events();
  EXPECT_EQ(apply_key(playback, U' '), PlaybackKey::changed);
  EXPECT_TRUE(playback.paused());
  EXPECT_EQ(apply_key(playback, U'+'), PlaybackKey::changed);
  EXPECT_EQ(playback.speed(), 2);
  EXPECT_EQ(apply_key(playback, U'-'), PlaybackKey::changed);
  EXPECT_EQ(playback.speed(), 1);
  EXPECT_EQ(apply_key(playback, Special::right), PlaybackKey::changed);
  EXPECT_DOUBLE_EQ(playback.time_s(), seek_step_s);
  EXPECT_EQ(apply_key(playback, Special::left), PlaybackKey::changed);
  EXPECT_EQ(playback.time_s(), 0);
  EXPECT_EQ(apply_key(playback, U'.'), PlaybackKey::changed);
  EXPECT_EQ(playback.time_s(), 2);
  EXPECT_EQ(apply_key(playback, U','), PlaybackKey::changed);
  EXPECT_EQ(playback.time_s(), 0);
  EXPECT_EQ(apply_key(playback, Special::end), PlaybackKey::changed);
  EXPECT_EQ(playback.time_s(), 10);
  EXPECT_EQ(apply_key(playback, Special::home), PlaybackKey::changed);
  EXPECT_EQ(playback.time_s(), 0);
  EXPECT_EQ(apply_key(playback, U'n'), PlaybackKey::next_shot);
  EXPECT_EQ(apply_key(playback, U'p'), PlaybackKey::previous_shot);
  EXPECT_EQ(apply_key(playback, U'q'), PlaybackKey::quit);
  EXPECT_EQ(apply_key(playback, Special::closed), PlaybackKey::quit);
  EXPECT_EQ(apply_key(playback, U'x'), PlaybackKey::none);
}

physics::Shot shot_with_two_drops() {
  physics::Shot shot;
  shot.end_s = 4;
  shot.events = {physics::Struck{0, physics::BallId{0}},
                 physics::BallPocket{1, 0, physics::BallId{7}, physics::PocketId{2}},
                 physics::BallPocket{3, 0, physics::BallId{0}, physics::PocketId{0}}};
  return shot;
}

TEST(Playback, StepsOverTheEventsOfAShot) {
  Playback playback(shot_with_two_drops());
  EXPECT_EQ(playback.end_s(), 4);
  playback.step_forward();
  EXPECT_EQ(playback.time_s(), 1);
}

TEST(Playback, CountsABallAsPocketedFromTheInstantOnWhichItDrops) {
  const physics::Shot shot = shot_with_two_drops();
  const physics::BallId seven{7};
  const physics::BallId cue{0};
  const physics::BallId three{3};
  EXPECT_TRUE(pocketed_by(shot, 0.99).empty());
  EXPECT_EQ(pocketed_by(shot, 1), (std::vector{seven}));
  EXPECT_EQ(pocketed_by(shot, 4, {three}), (std::vector{three, seven, cue}));
}

TEST(Playback, SaysWhereItIs) {
  Playback playback = three_events(0.5);
  playback.advance(5);
  EXPECT_EQ(clock_text(playback), "2.50 of 10.00 s, 0.5x");
  playback.pause();
  EXPECT_EQ(clock_text(playback), "2.50000 of 10.00 s, 0.5x, paused");
}

}  // namespace
}  // namespace breakshot::client
