// What a command is given to read.
#pragma once

#include <string>

namespace breakshot::client {

/// All bytes of a file, or of standard input where it is named "-". Throws CommandError, which says
/// why it cannot be read.
std::string read_input(const std::string& name);

}  // namespace breakshot::client
