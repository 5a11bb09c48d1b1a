#include "common/lobby/code.hpp"

namespace breakshot::lobby {

std::optional<InviteCode> code_of(std::string_view text) {
  if (text.size() != invite_code_length) return std::nullopt;
  InviteCode code;
  for (char c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (c == 'O') c = '0';
    if (c == 'I' || c == 'L') c = '1';
    const bool digit = c >= '0' && c <= '9';
    const bool letter = c >= 'A' && c <= 'Z' && c != 'U';  // Crockford leaves out U
    if (!digit && !letter) return std::nullopt;
    code += c;
  }
  return code;
}

}  // namespace breakshot::lobby
