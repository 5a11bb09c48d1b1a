#include "client_cli/play_shot.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "client_cli/draw/table_grid.hpp"

namespace breakshot::client {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds frame_time{33};
/// How long, at speed 1, the cue vector is seen before the balls move, and the balls and the ruling
/// after they have come to rest, s.
constexpr double aim_s = 0.8;
constexpr double rest_s = 1.5;

constexpr const char* key_help =
    "q quit  space pause  ,. step  arrows seek  -+ speed  pn shot  v speeds  t paths";

/// One shot on its way: what is fixed and what the viewer changes.
class Show {
 public:
  Show(Terminal& terminal, const Table& table, const physics::Shot& shot,
       const PlaybackOptions& options)
      : terminal_(terminal),
        table_(table),
        shot_(shot),
        options_(options),
        timeline_(shot),
        playback_(shot, options.speed),
        velocities_(options.velocities),
        paths_(options.paths),
        lead_s_(options.cue && options.from_s <= 0 ? aim_s : 0) {
    playback_.seek(options.from_s);
    if (options.paused) playback_.pause();
  }

  Played run() {
    Clock::time_point before = Clock::now();
    for (;;) {
      draw();
      const PlaybackKey key = handle(terminal_.key(frame_time));
      const bool leaves = key != PlaybackKey::none && key != PlaybackKey::changed;
      if (leaves) return result(key);
      if (options_.each_frame && !options_.each_frame()) return result(PlaybackKey::none);
      const Clock::time_point now = Clock::now();
      pass(std::chrono::duration<double>(now - before).count());
      before = now;
      if (rested_s_ > rest_s && !options_.stay) return result(PlaybackKey::none);
    }
  }

 private:
  Terminal& terminal_;
  const Table& table_;
  const physics::Shot& shot_;
  const PlaybackOptions& options_;
  physics::Timeline timeline_;
  Playback playback_;
  bool velocities_;
  bool paths_;
  double lead_s_;
  double rested_s_ = 0;

  Played result(PlaybackKey ended_by) const {
    return {ended_by, playback_.speed(), playback_.paused(), velocities_, paths_};
  }

  PlaybackKey handle(const std::optional<Key>& key) {
    if (!key) return PlaybackKey::none;
    if (*key == Key(U'v')) velocities_ = !velocities_;
    if (*key == Key(U't')) paths_ = !paths_;
    return apply_key(playback_, *key);
  }

  void pass(double wall_s) {
    if (playback_.paused()) return;
    // What is left of the time to aim passes at the speed of the shot.
    const double passed_s = wall_s * playback_.speed();
    const double aiming_s = playback_.time_s() > 0 ? 0 : std::min(lead_s_, passed_s);
    lead_s_ -= aiming_s;
    playback_.advance(wall_s - aiming_s / playback_.speed());
    rested_s_ = playback_.at_end() ? rested_s_ + passed_s : 0;
  }

  void draw() {
    const double time_s = playback_.time_s();
    Picture picture;
    picture.table = table_;
    picture.balls = balls_at(table_, timeline_, time_s);
    if (paths_) picture.paths = paths_until(timeline_, time_s);
    if (time_s <= 0) picture.cue = options_.cue;
    picture.velocities = velocities_;
    picture.pocketed = pocketed_by(shot_, time_s, options_.pocketed);
    picture.caption = options_.caption;
    std::vector<std::string> lines = options_.lines;
    lines.push_back(playback_.at_end() ? options_.ruling : std::string());
    lines.push_back(clock_text(playback_));
    lines.push_back(key_help);
    terminal_.show(grid_of(picture, lines, terminal_.size(), terminal_.abilities()));
  }
};

}  // namespace

Played play_shot(Terminal& terminal, const Table& table, const physics::Shot& shot,
                 const PlaybackOptions& options) {
  return Show(terminal, table, shot, options).run();
}

std::vector<physics::BallId> pocketed_by(const physics::Shot& shot, double time_s,
                                         std::vector<physics::BallId> before) {
  for (const physics::Event& event : shot.events) {
    if (physics::time_of(event) > time_s) break;
    const auto* dropped = std::get_if<physics::BallPocket>(&event);
    if (dropped != nullptr) before.push_back(dropped->ball);
  }
  return before;
}

std::string clock_text(const Playback& playback) {
  char text[80];
  // Within a break events follow each other in less than a millisecond, and steps should be seen.
  const int digits = playback.paused() ? 5 : 2;
  std::snprintf(text, sizeof text, "%.*f of %.2f s, %gx%s", digits, playback.time_s(),
                playback.end_s(), playback.speed(), playback.paused() ? ", paused" : "");
  return text;
}

}  // namespace breakshot::client
