// Texts that end up on other people's terminals: nothing that moves a cursor, changes the writing
// direction or hides what is there may pass.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace breakshot::lobby {

struct Character {
  char32_t code_point = 0;
  std::size_t bytes = 0;  ///< 0: not well-formed UTF-8
};

/// The first character of `text`, which is not empty. Overlong forms, surrogates and values beyond
/// U+10FFFF are not well-formed (RFC 3629).
Character first_of(std::string_view text);

/// What keeps a character from printing as what it is ("control characters"), or nothing. Those are
/// the control characters (C0, DEL, C1) and the marks that reorder or hide text (bidirectional
/// controls, zero-width characters, line and paragraph separators, byte order mark).
std::optional<std::string> unprintable(char32_t code_point);

/// Bytes of a text for people: why a request was refused, why a connection ends.
inline constexpr std::size_t max_text_bytes = 1024;

/// What is wrong with a text for people, or nothing: too long, no UTF-8, or not printable on one
/// line as what it is. It may be empty.
std::optional<std::string> text_fault(std::string_view text);

}  // namespace breakshot::lobby
