#include "common/lobby/text.hpp"

namespace breakshot::lobby {

std::optional<std::string> text_fault(std::string_view text) {
  if (text.size() > max_text_bytes) {
    return "a text must have at most " + std::to_string(max_text_bytes) + " bytes";
  }
  if (const auto fault = record::text_fault(text)) return "a text " + fault->what;
  return std::nullopt;
}

}  // namespace breakshot::lobby
