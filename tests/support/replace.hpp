// Texts that differ in one place.
#pragma once

#include <stdexcept>
#include <string>

namespace breakshot::support {

/// `text` with the first `from` replaced by `to`; it must be there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == text.npos) throw std::logic_error("not in the text: " + from);
  return text.replace(at, from.size(), to);
}

}  // namespace breakshot::support
