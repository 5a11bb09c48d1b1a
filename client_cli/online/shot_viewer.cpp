#include "client_cli/online/shot_viewer.hpp"

#include <utility>

namespace breakshot::client {

PlaybackKey ShotViewer::show(Terminal& terminal, const MatchView& view, const record::Entry& entry,
                             const std::function<bool()>& each_frame) {
  const Table table = table_of(view.info.settings.scene);
  const Names names = names_of(view);
  PlaybackOptions options;
  options.cue = cue_vector_of(entry);
  options.pocketed = pocketed_.balls();
  options.caption = score_text(before_, names);
  options.lines = {command_text(entry.author, entry.command, before_, names)};
  options.each_frame = each_frame;
  while (true) {
    options.speed = wishes_.speed;
    options.velocities = wishes_.velocities;
    options.paths = wishes_.paths;
    wishes_ = play_shot(terminal, table, *entry.outcome.shot, options);
    wishes_.paused = false;
    const PlaybackKey key = std::exchange(wishes_.ended_by, PlaybackKey::none);
    // There is no shot before the one that just came: it is shown again.
    if (key != PlaybackKey::previous_shot) return key;
  }
}

void ShotViewer::follow(const record::Entry& entry) {
  pocketed_.follow(entry.outcome);
  before_ = entry.outcome.status;
}

Picture ShotViewer::picture(const MatchView& view) const {
  Picture picture;
  picture.table = table_of(view.info.settings.scene);
  if (view.last) picture.balls = drawn(view.last->outcome.table);
  picture.pocketed = pocketed_.balls();
  picture.caption = score_text(before_, names_of(view));
  return picture;
}

Names names_of(const MatchView& view) {
  if (view.header) return names_of(*view.header);
  Names names;
  for (const auto& seat : view.info.seats) names.push_back(seat.name);
  return names;
}

}  // namespace breakshot::client
