// Where in a value a codec is, for what it says when something is wrong there.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace breakshot::record {

/// The fields and indices from the outermost value to the current one. Names are kept by
/// reference and must be literals.
class Path {
 public:
  /// Steps into a field or an element that begins at `offset` of the bytes.
  void enter(std::string_view field, std::size_t offset) { steps_.push_back({field, 0, offset}); }
  void enter(std::size_t index, std::size_t offset) { steps_.push_back({{}, index, offset}); }
  void leave() { steps_.pop_back(); }

  /// Where the innermost value begins; 0 outside all of them.
  std::size_t offset() const { return steps_.empty() ? 0 : steps_.back().offset; }
  /// As in "shot.events[42].time_s".
  std::string text() const;

 private:
  struct Step {
    std::string_view field;  ///< empty: an element
    std::size_t index;
    std::size_t offset;
  };
  std::vector<Step> steps_;
};

}  // namespace breakshot::record
