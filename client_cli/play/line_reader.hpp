// Lines from a file descriptor as they come, without waiting for them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace breakshot::client {

/// A line that is longer than this is cut into several.
inline constexpr std::size_t max_line_bytes = 4096;

class LineReader {
 public:
  explicit LineReader(int fd) : fd_(fd) {}

  int fd() const { return fd_; }
  /// The next whole line without its end; at the end of the input also one that has none.
  std::optional<std::string> next();
  /// Reads what is there, if anything; never waits.
  void fill();
  /// Nothing more will come, and all lines have been taken.
  bool at_end() const { return ended_ && text_.empty(); }

 private:
  int fd_;
  std::string text_;
  bool ended_ = false;
};

}  // namespace breakshot::client
