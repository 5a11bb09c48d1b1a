// What benchmarks share: scenario files beside them, and seeds.
#pragma once

#include <cstdint>
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

}  // namespace breakshot::bench
