// A sentence broken into lines.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace breakshot::client {

/// Breaks `text` at spaces into lines of at most `width` bytes; each but the first begins with
/// `indent`. A word that is longer than a line has one of its own.
std::vector<std::string> wrapped(std::string text, std::size_t width, const std::string& indent);

}  // namespace breakshot::client
