#include "client_cli/paragraph.hpp"

#include <utility>

namespace breakshot::client {

std::vector<std::string> wrapped(std::string text, std::size_t width, const std::string& indent) {
  std::vector<std::string> lines;
  while (text.size() > width) {
    const std::size_t first_word = text.find_first_not_of(' ');
    if (first_word == std::string::npos) break;
    std::size_t gap = text.rfind(' ', width);
    // A line without a word before its gap would be followed by the same text again.
    if (gap == std::string::npos || gap < first_word) gap = text.find(' ', first_word);
    if (gap == std::string::npos) break;
    lines.push_back(text.substr(0, gap));
    text = indent + text.substr(gap + 1);
  }
  lines.push_back(std::move(text));
  return lines;
}

}  // namespace breakshot::client
