// The text that is stored and said: well-formed UTF-8 in which nothing moves a cursor, changes the
// writing direction or hides what is there, since it ends up on other people's terminals.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace breakshot::record {

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

/// The first thing that keeps a text from being stored or said, to follow "a text": "must be
/// UTF-8", "must not hold control characters".
struct TextFault {
  std::size_t offset = 0;  ///< in bytes
  std::string what;
};
std::optional<TextFault> text_fault(std::string_view text);

}  // namespace breakshot::record
