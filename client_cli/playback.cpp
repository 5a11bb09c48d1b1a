#include "client_cli/playback.hpp"

#include <algorithm>
#include <utility>

namespace breakshot::client {
namespace {

std::vector<double> times_of(const physics::Shot& shot) {
  std::vector<double> times;
  for (const physics::Event& event : shot.events) {
    const double time_s = physics::time_of(event);
    if (times.empty() || times.back() < time_s) times.push_back(time_s);
  }
  return times;
}

PlaybackKey changed(Playback& playback, void (Playback::*change)()) {
  (playback.*change)();
  return PlaybackKey::changed;
}

PlaybackKey sought(Playback& playback, double time_s) {
  playback.seek(time_s);
  return PlaybackKey::changed;
}

PlaybackKey apply_character(Playback& playback, char32_t character) {
  switch (character) {
    case U' ':
      return changed(playback, &Playback::toggle_pause);
    case U'+':
    case U'=':
      return changed(playback, &Playback::faster);
    case U'-':
      return changed(playback, &Playback::slower);
    case U'.':
      return changed(playback, &Playback::step_forward);
    case U',':
      return changed(playback, &Playback::step_back);
    case U'n':
      return PlaybackKey::next_shot;
    case U'p':
      return PlaybackKey::previous_shot;
    case U'q':
      return PlaybackKey::quit;
    default:
      return PlaybackKey::none;
  }
}

PlaybackKey apply_special(Playback& playback, Special special) {
  switch (special) {
    case Special::right:
      return sought(playback, playback.time_s() + seek_step_s);
    case Special::left:
      return sought(playback, playback.time_s() - seek_step_s);
    case Special::home:
      return sought(playback, 0);
    case Special::end:
      return sought(playback, playback.end_s());
    case Special::page_down:
      return PlaybackKey::next_shot;
    case Special::page_up:
      return PlaybackKey::previous_shot;
    case Special::escape:
    case Special::closed:
      return PlaybackKey::quit;
    case Special::resized:
      return PlaybackKey::changed;
    default:
      return PlaybackKey::none;
  }
}

}  // namespace

Playback::Playback(double end_s, std::vector<double> event_times_s, double speed)
    : end_s_(end_s),
      event_times_s_(std::move(event_times_s)),
      speed_(std::clamp(speed, min_speed, max_speed)) {}

Playback::Playback(const physics::Shot& shot, double speed)
    : Playback(shot.end_s, times_of(shot), speed) {}

void Playback::advance(double wall_s) {
  if (!paused_) seek(time_s_ + wall_s * speed_);
}

void Playback::toggle_pause() {
  if (paused_ && at_end()) time_s_ = 0;
  paused_ = !paused_;
}

void Playback::faster() {
  speed_ = std::min(2 * speed_, max_speed);
}

void Playback::slower() {
  speed_ = std::max(speed_ / 2, min_speed);
}

void Playback::seek(double time_s) {
  time_s_ = std::clamp(time_s, 0.0, end_s_);
}

void Playback::step_forward() {
  const auto next = std::upper_bound(event_times_s_.begin(), event_times_s_.end(), time_s_);
  seek(next == event_times_s_.end() ? end_s_ : *next);
  paused_ = true;
}

void Playback::step_back() {
  const auto here = std::lower_bound(event_times_s_.begin(), event_times_s_.end(), time_s_);
  seek(here == event_times_s_.begin() ? 0 : *std::prev(here));
  paused_ = true;
}

PlaybackKey apply_key(Playback& playback, const Key& key) {
  if (const auto* character = std::get_if<char32_t>(&key)) {
    return apply_character(playback, *character);
  }
  return apply_special(playback, std::get<Special>(key));
}

}  // namespace breakshot::client
