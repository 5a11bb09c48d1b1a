// Time that other processes do not add to.
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace breakshot::bench {

/// Processor time of this thread, s: a shared machine takes the processor away at any time.
inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace breakshot::bench
