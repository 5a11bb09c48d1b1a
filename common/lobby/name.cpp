#include "common/lobby/name.hpp"

#include <cstdint>

namespace breakshot::lobby {
namespace {

struct Decoded {
  char32_t code_point = 0;
  std::size_t bytes = 0;  ///< 0: not well-formed
};

/// The first code point of `text`, which is not empty. Overlong forms, surrogates and values beyond
/// U+10FFFF are not well-formed.
Decoded first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc0 ? 2 : 0;
  if (bytes == 0 || lead >= 0xf8 || text.size() < bytes) return {};
  char32_t code_point = lead & (0x7fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code_point = (code_point << 6) | (byte(i) & 0x3fu);
  }
  constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code_point >= 0xd800 && code_point <= 0xdfff;
  if (code_point < smallest[bytes] || surrogate || code_point > 0x10ffff) return {};
  return {code_point, bytes};
}

bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0);
}

bool hides_or_reorders(char32_t c) {
  return c == 0x061c || (c >= 0x200b && c <= 0x200f) || (c >= 0x2028 && c <= 0x202e) ||
         (c >= 0x2060 && c <= 0x206f) || c == 0xfeff;
}

bool is_space(char32_t c) {
  return c == ' ' || c == 0xa0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200a) || c == 0x202f ||
         c == 0x205f || c == 0x3000;
}

}  // namespace

std::optional<std::string> name_fault(std::string_view name) {
  if (name.empty()) return "a name must not be empty";
  std::size_t length = 0;
  bool ends_in_space = false;
  while (!name.empty()) {
    const Decoded next = first_of(name);
    if (next.bytes == 0) return "a name must be UTF-8 text";
    if (is_control(next.code_point)) return "a name must not hold control characters";
    if (hides_or_reorders(next.code_point)) return "a name must not hold invisible characters";
    ends_in_space = is_space(next.code_point);
    if (length == 0 && ends_in_space) return "a name must not begin with a space";
    if (++length > max_name_length) {
      return "a name must have at most " + std::to_string(max_name_length) + " characters";
    }
    name.remove_prefix(next.bytes);
  }
  if (ends_in_space) return "a name must not end with a space";
  return std::nullopt;
}

}  // namespace breakshot::lobby
