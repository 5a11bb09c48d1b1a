// What benchmarks share: scenario files beside them, seeds, and time that other processes do not
// add to.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "common/wire/scenario.hpp"

namespace breakshot::bench {

inline wire::Scenario scenario(const std::string& name) {
  const std::string file = std::string(BREAKSHOT_BENCH_DIR "/scenes/") + name;
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  auto reading = wire::read_scenario(text);
  if (auto* found = std::get_if<wire::Scenario>(&reading)) return std::move(*found);
  const auto& fault = std::get<std::vector<physics::Fault>>(reading).front();
  throw std::runtime_error(file + ": " + fault.field + ": " + fault.what);
}

inline physics::ShotSeed seed(std::uint32_t number) {
  physics::ShotSeed seed;
  for (std::size_t i = 0; i < 4; ++i) seed.seed[i] = static_cast<std::uint8_t>(number >> 8 * i);
  return seed;
}

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
