// What a player may be called.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace breakshot::lobby {

/// Code points of a name.
inline constexpr std::size_t max_name_length = 32;
/// Bytes of the longest name: four bytes a code point.
inline constexpr std::size_t max_name_bytes = 4 * max_name_length;

/// What is wrong with a name, or nothing. A name is 1 to 32 code points of well-formed UTF-8 (RFC
/// 3629) without control characters (C0, DEL, C1), without the marks that reorder or hide text
/// (bidirectional controls, zero-width characters, line and paragraph separators, byte order mark),
/// and without leading or trailing space. So a name always prints on one line as what it is.
std::optional<std::string> name_fault(std::string_view name);

}  // namespace breakshot::lobby
