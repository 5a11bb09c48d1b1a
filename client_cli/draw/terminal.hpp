// The terminal as a screen and a keyboard, for as long as the object lives. It is given back as it
// was found on any way out: the destructor, an exception, exit(), or a signal that ends or stops
// the program.
#pragma once

#include <chrono>
#include <optional>

#include "client_cli/draw/abilities.hpp"
#include "client_cli/draw/grid.hpp"
#include "client_cli/draw/keys.hpp"

namespace breakshot::client {

class Terminal {
 public:
  /// Takes the terminal over: alternate screen, no cursor, keys as they are pressed. There may be
  /// one at a time. Throws CommandError where standard input and output are no terminal.
  explicit Terminal(const Abilities& abilities);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  const Abilities& abilities() const { return abilities_; }
  TerminalSize size() const { return terminal_size(); }

  /// Brings the screen to `grid`, writing only what has changed.
  void show(const Grid& grid);

  /// The next key, or nothing if none came in time. A change of the terminal's size comes as
  /// Special::resized, its end as Special::closed.
  std::optional<Key> key(std::chrono::milliseconds wait);

 private:
  Abilities abilities_;
  KeyDecoder decoder_;
  std::optional<Grid> shown_;

  bool read_bytes(std::chrono::milliseconds wait);
};

}  // namespace breakshot::client
