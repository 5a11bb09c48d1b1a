// Texts for people: what they are made of is the record's (common/record/text.hpp), how long they
// may be is said here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "common/record/text.hpp"

namespace breakshot::lobby {

/// Bytes of a text for people: why a request was refused, why a connection ends.
inline constexpr std::size_t max_text_bytes = 1024;

/// What is wrong with a text for people, or nothing: too long, no UTF-8, or not printable on one
/// line as what it is. It may be empty.
std::optional<std::string> text_fault(std::string_view text);

}  // namespace breakshot::lobby
