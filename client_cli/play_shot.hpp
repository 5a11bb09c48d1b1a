// Shows one shot in a terminal.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "client_cli/draw/picture.hpp"
#include "client_cli/draw/terminal.hpp"
#include "client_cli/playback.hpp"
#include "common/physics/timeline.hpp"

namespace breakshot::client {

struct PlaybackOptions {
  double speed = 1;
  bool paused = false;
  double from_s = 0;
  bool velocities = false;
  bool paths = false;
  /// Wait for a key at the end instead of returning.
  bool stay = false;
  std::optional<CueVector> cue;           ///< shown for a moment before the balls move
  std::vector<physics::BallId> pocketed;  ///< before this shot
  std::string caption;
  std::vector<std::string> lines;  ///< under the table, above the clock
  std::string ruling;              ///< told when the balls have come to rest
  /// Called once a frame, so that a connection can be served meanwhile; false ends the playback.
  std::function<bool()> each_frame;
};

struct Played {
  PlaybackKey ended_by = PlaybackKey::none;  ///< none: the shot was over, or each_frame said so
  // As the viewer left them.
  double speed = 1;
  bool paused = false;
  bool velocities = false;
  bool paths = false;
};

/// Plays until the shot is over or the viewer asks for something else. Besides the keys of
/// `apply_key`, v shows velocities and t the tracks of the balls.
Played play_shot(Terminal& terminal, const Table& table, const physics::Shot& shot,
                 const PlaybackOptions& options);

/// The balls of `shot` that are down at `time_s`, after those of `before`, in order.
std::vector<physics::BallId> pocketed_by(const physics::Shot& shot, double time_s,
                                         std::vector<physics::BallId> before = {});

/// "12.34 of 20.10 s, 0.5x, paused".
std::string clock_text(const Playback& playback);

}  // namespace breakshot::client
