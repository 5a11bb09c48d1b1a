#include "tests/source_text.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>

namespace breakshot {
namespace {

constexpr std::string_view blanks = " \t\n";

bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool includes_at(std::string_view text, std::size_t at) {
  if (text[at] != '#') return false;
  const auto word = text.find_first_not_of(" \t", at + 1);
  return word != std::string_view::npos && text.substr(word).starts_with("include");
}

/// The end of the literal or comment that begins at `at`, or `at` where none does. The apostrophe
/// inside a number separates digits and begins nothing.
std::size_t skip_from(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  const auto past = [&](std::string_view mark, std::size_t from) {
    const auto found = text.find(mark, from);
    return found == std::string_view::npos ? text.size() : found + mark.size();
  };
  if (rest.starts_with("//")) return std::min(text.find('\n', at), text.size());
  if (rest.starts_with("/*")) return past("*/", at + 2);
  const bool after_word = at > 0 && in_word(text[at - 1]);
  if (rest.starts_with("R\"") && !after_word) {
    const auto open = text.find('(', at);
    if (open == std::string_view::npos) return text.size();
    std::string mark(1, ')');
    mark.append(text.substr(at + 2, open - at - 2)).push_back('"');
    return past(mark, open);
  }
  if (rest.empty() || (rest[0] != '"' && (rest[0] != '\'' || after_word))) return at;
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != rest[0]) end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

/// Counts lines as it goes, so that a source is read once and not again for every mention.
class LineCounter {
 public:
  explicit LineCounter(std::string_view code) : code_(code) {}

  std::size_t line_at(std::size_t at) {
    const std::string_view passed = code_.substr(at_, at - at_);
    line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
    at_ = at;
    return line_;
  }

 private:
  std::string_view code_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// Whether `before`, the code ahead of a name and its parenthesis, ends in a type: then the name is
/// declared there, not called.
bool declares(std::string_view before) {
  static const std::set<std::string_view> other_words = {
      "return", "co_return", "co_yield", "co_await", "throw", "else", "do", "case"};
  std::size_t begin = before.size();
  while (begin > 0 && in_word(before[begin - 1])) --begin;
  return begin < before.size() && !other_words.contains(before.substr(begin));
}

bool may_be_standard(std::string_view code, std::size_t begin, std::size_t end) {
  const auto last = code.substr(0, begin).find_last_not_of(blanks);
  const std::string_view before = last == std::string_view::npos ? "" : code.substr(0, last + 1);
  if (before.ends_with("::")) {
    const auto scope_end = before.substr(0, before.size() - 2).find_last_not_of(blanks);
    const std::string_view scope =
        scope_end == std::string_view::npos ? "" : before.substr(0, scope_end + 1);
    if (scope.empty() || !in_word(scope.back())) return true;
    return scope.ends_with("std") && (scope.size() == 3 || !in_word(scope[scope.size() - 4]));
  }
  if (before.ends_with(".") || before.ends_with("->") || declares(before)) return false;
  const auto next = code.find_first_not_of(blanks, end);
  return next != std::string_view::npos && code[next] == '(';
}

}  // namespace

std::vector<Source> sources_below(const std::filesystem::path& root) {
  static const std::set<std::string> endings = {".cpp", ".hpp", ".h", ".hh",
                                                ".cc",  ".cxx", ".c", ".ipp"};
  std::vector<Source> sources;
  for (std::filesystem::recursive_directory_iterator entry(root), end; entry != end; ++entry) {
    const std::string path = entry->path().lexically_relative(root).generic_string();
    if (entry->is_directory() && (path == "build" || path == "var" || path.starts_with('.'))) {
      entry.disable_recursion_pending();
    }
    if (!entry->is_regular_file() || !endings.contains(entry->path().extension().string()))
      continue;
    std::ifstream file(entry->path(), std::ios::binary);
    sources.push_back({path, std::string(std::istreambuf_iterator<char>(file), {})});
  }
  return sources;
}

std::string code_of(std::string_view text) {
  std::string code(text);
  bool including = false;
  for (std::size_t at = 0; at < text.size();) {
    including = text[at] != '\n' && (including || includes_at(text, at));
    const std::size_t end = skip_from(text, at);
    const bool comment = end > at && text[at] == '/';
    if (end > at && (comment || !including)) {
      std::replace_if(
          code.begin() + static_cast<std::ptrdiff_t>(at),
          code.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; }, ' ');
    }
    at = std::max(end, at + 1);
  }
  return code;
}

std::vector<Mention> includes_of(std::string_view code) {
  std::vector<Mention> mentions;
  LineCounter lines(code);
  for (auto at = code.find('#'); at != std::string_view::npos; at = code.find('#', at + 1)) {
    if (!includes_at(code, at)) continue;
    const auto open = std::min(code.find_first_of("<\"\n", at), code.size() - 1);
    const auto close = std::min(code.find_first_of(">\"\n", open + 1), code.size());
    mentions.push_back({lines.line_at(at), std::string(code.substr(open + 1, close - open - 1))});
  }
  return mentions;
}

std::vector<Mention> standard_names_of(std::string_view code) {
  std::vector<Mention> mentions;
  LineCounter lines(code);
  for (std::size_t at = 0; at < code.size();) {
    std::size_t end = at;
    while (end < code.size() && in_word(code[end])) ++end;
    if (end > at && may_be_standard(code, at, end)) {
      mentions.push_back({lines.line_at(at), std::string(code.substr(at, end - at))});
    }
    at = std::max(end, at + 1);
  }
  return mentions;
}

}  // namespace breakshot
