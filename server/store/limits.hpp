// Every limit of keeping, in one place.
#pragma once

#include <cstddef>

namespace breakshot::store {

/// Batches that share one transaction, and so one wait for the medium. Bounds what a failed commit
/// takes along and how long the first one waits for the others.
inline constexpr std::size_t most_batches_at_once = 256;

/// How long one connection waits for another one of this process, ms. The writer never waits for
/// readers in WAL mode; this covers the moments at which the file is opened and recovered.
inline constexpr int busy_timeout_ms = 10'000;

}  // namespace breakshot::store
