// The shell's own limit.
#pragma once

#include <chrono>

namespace breakshot::shell {

/// How often the hub is told that time has passed.
inline constexpr std::chrono::milliseconds tick_interval = std::chrono::seconds(1);

}  // namespace breakshot::shell
