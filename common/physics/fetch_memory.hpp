// Memory that will be asked for soon.
#pragma once

namespace breakshot::physics {

/// Has the cache line at `place` fetched. The statement after it does nothing, but compilers must
/// keep it: a function that did nothing but fetch would be taken for one that does nothing at all,
/// and its calls left out.
inline void fetch_memory(const void* place) {
  __builtin_prefetch(place);
  asm volatile("");
}

}  // namespace breakshot::physics
