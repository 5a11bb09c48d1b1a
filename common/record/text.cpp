#include "common/record/text.hpp"

#include <cstdint>

namespace breakshot::record {
namespace {

bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0);
}

bool hides_or_reorders(char32_t c) {
  return c == 0x061c || (c >= 0x200b && c <= 0x200f) || (c >= 0x2028 && c <= 0x202e) ||
         (c >= 0x2060 && c <= 0x206f) || c == 0xfeff;
}

}  // namespace

Character first_of(std::string_view text) {
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

std::optional<std::string> unprintable(char32_t code_point) {
  if (is_control(code_point)) return "control characters";
  if (hides_or_reorders(code_point)) return "invisible characters";
  return std::nullopt;
}

std::optional<TextFault> text_fault(std::string_view text) {
  std::size_t offset = 0;
  while (offset < text.size()) {
    const Character next = first_of(text.substr(offset));
    if (next.bytes == 0) return TextFault{offset, "must be UTF-8"};
    if (const auto what = unprintable(next.code_point))
      return TextFault{offset, "must not hold " + *what};
    offset += next.bytes;
  }
  return std::nullopt;
}

}  // namespace breakshot::record
