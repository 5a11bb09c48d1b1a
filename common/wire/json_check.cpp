#include "common/wire/json_check.hpp"

#include <algorithm>
#include <boost/json/basic_parser_impl.hpp>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace breakshot::wire {
namespace {

/// Follows a parse and remembers where it is: the events are those of Boost.JSON's push parser.
class DuplicateFinder {
 public:
  static constexpr std::size_t max_object_size = static_cast<std::size_t>(-1);
  static constexpr std::size_t max_array_size = static_cast<std::size_t>(-1);
  static constexpr std::size_t max_key_size = static_cast<std::size_t>(-1);
  static constexpr std::size_t max_string_size = static_cast<std::size_t>(-1);

  using Code = boost::json::error_code;
  using Text = boost::json::string_view;

  bool on_document_begin(Code&) { return true; }
  bool on_document_end(Code&) { return true; }
  bool on_object_begin(Code&) { return open(false); }
  bool on_object_end(std::size_t, Code&) { return close(); }
  bool on_array_begin(Code&) { return open(true); }
  bool on_array_end(std::size_t, Code&) { return close(); }
  bool on_key_part(Text part, std::size_t, Code&) {
    key_.append(part.data(), part.size());
    return true;
  }
  bool on_key(Text part, std::size_t, Code& code) {
    key_.append(part.data(), part.size());
    levels_.back().key = std::exchange(key_, {});
    if (levels_.back().keys.insert(levels_.back().key).second) return true;
    return refuse("is given twice; a field may stand once in an object", code);
  }
  bool on_string_part(Text, std::size_t, Code&) { return true; }
  bool on_string(Text, std::size_t, Code&) { return value(); }
  bool on_number_part(Text, Code&) { return true; }
  bool on_int64(std::int64_t, Text, Code&) { return value(); }
  bool on_uint64(std::uint64_t, Text, Code&) { return value(); }
  bool on_double(double number, Text, Code& code) {
    if (!std::isfinite(number)) return refuse("is too large for a double", code);
    return value();
  }
  bool on_bool(bool, Code&) { return value(); }
  bool on_null(Code&) { return value(); }
  bool on_comment_part(Text, Code&) { return true; }
  bool on_comment(Text, Code&) { return true; }

  const std::optional<physics::Fault>& fault() const { return fault_; }

 private:
  struct Level {
    bool array = false;
    std::size_t index = 0;
    std::string key;
    std::set<std::string> keys;
  };

  bool open(bool array) {
    levels_.push_back({array, 0, {}, {}});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return value();
  }
  /// A value is complete: the next one of an array has the next index.
  bool value() {
    if (!levels_.empty()) ++levels_.back().index;
    return true;
  }

  bool refuse(const char* what, Code& code) {
    std::string path;
    for (const Level& level : levels_) {
      if (level.array) {
        path += "[" + std::to_string(level.index) + "]";
      } else {
        path += (path.empty() ? "" : ".") + level.key;
      }
    }
    fault_ = physics::Fault{path, what};
    code = boost::json::error::syntax;
    return false;
  }

  std::vector<Level> levels_;
  std::string key_;
  std::optional<physics::Fault> fault_;
};

physics::Fault syntax_fault(std::string_view text, std::size_t offset, const std::string& what) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
  return {"", "is not JSON at line " + std::to_string(line) + ", column " +
                  std::to_string(before.size() - line_start + 1) + ": " + what};
}

}  // namespace

std::optional<physics::Fault> json_fault(std::string_view text) {
  boost::json::basic_parser<DuplicateFinder> parser{boost::json::parse_options{}};
  boost::json::error_code code;
  const std::size_t read = parser.write_some(false, text.data(), text.size(), code);
  if (parser.handler().fault()) return parser.handler().fault();
  if (code) return syntax_fault(text, read, code.message());
  const auto rest = text.find_first_not_of(" \t\r\n", read);
  if (rest != text.npos) return syntax_fault(text, rest, "text after the end of the object");
  return std::nullopt;
}

}  // namespace breakshot::wire
