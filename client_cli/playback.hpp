// The clock of a shot that is shown: it runs at any speed, stops, steps from event to event and
// seeks. A value without any input or output.
#pragma once

#include <vector>

#include "client_cli/draw/keys.hpp"
#include "common/physics/event.hpp"

namespace breakshot::client {

inline constexpr double min_speed = 0.01;
inline constexpr double max_speed = 1000;
/// How far the arrow keys go, s of the shot.
inline constexpr double seek_step_s = 0.5;

/// Times are seconds since the start of the shot and stay within [0, end_s].
class Playback {
 public:
  /// `event_times_s` ascends.
  Playback(double end_s, std::vector<double> event_times_s, double speed = 1);
  /// Steps over the events of `shot`.
  explicit Playback(const physics::Shot& shot, double speed = 1);

  double time_s() const { return time_s_; }
  double end_s() const { return end_s_; }
  double speed() const { return speed_; }
  bool paused() const { return paused_; }
  bool at_end() const { return time_s_ >= end_s_; }

  /// Lets `wall_s` seconds of real time pass.
  void advance(double wall_s);
  void pause() { paused_ = true; }
  /// At the end, goes on from the start.
  void toggle_pause();
  void faster();
  void slower();
  void seek(double time_s);
  /// Pauses at the next event after now, or at the last one before.
  void step_forward();
  void step_back();

 private:
  double end_s_;
  std::vector<double> event_times_s_;
  double speed_;
  double time_s_ = 0;
  bool paused_ = false;
};

/// What a key meant.
enum class PlaybackKey { none, changed, next_shot, previous_shot, quit };

/// Space pauses, + and - change the speed, left and right seek, full stop and comma step, home and
/// end jump; n and p are for other shots, q and escape quit.
PlaybackKey apply_key(Playback& playback, const Key& key);

}  // namespace breakshot::client
