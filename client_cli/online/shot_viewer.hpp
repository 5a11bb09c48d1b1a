// Shows the shots of a followed match in a terminal, one after the other.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "client_cli/draw/picture.hpp"
#include "client_cli/draw/terminal.hpp"
#include "client_cli/online/match_view.hpp"
#include "client_cli/play_shot.hpp"
#include "client_cli/stored_match.hpp"
#include "client_cli/words.hpp"

namespace breakshot::client {

class ShotViewer {
 public:
  explicit ShotViewer(double speed) { wishes_.speed = speed; }

  /// Plays the entry's shot until it is over or the viewer asks for something else; the speed and
  /// what else he changed hold for the next one too. Entries must be followed after they are shown.
  PlaybackKey show(Terminal& terminal, const MatchView& view, const record::Entry& entry,
                   const std::function<bool()>& each_frame);
  /// Takes note of an entry, shown or not.
  void follow(const record::Entry& entry);

  /// The table as it lies now.
  Picture picture(const MatchView& view) const;

 private:
  Played wishes_;
  match::Status before_;
  PocketedBalls pocketed_;
};

/// The names of a match's players as far as they are known.
Names names_of(const MatchView& view);

}  // namespace breakshot::client
