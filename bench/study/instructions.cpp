#include "bench/study/instructions.hpp"

#include <algorithm>

#include "tests/support/subprocess.hpp"

namespace breakshot::bench {
namespace {

/// A shot that takes longer is not counted: callgrind is fifty times slower, s.
constexpr double longest_s = 0.2;
/// As many shots are counted as take this long without callgrind, s.
constexpr double enough_s = 0.02;
constexpr std::size_t most_shots = 20;

std::optional<double> counted(std::vector<std::string> simulate, std::size_t shots) {
  simulate.insert(simulate.begin(), {"/usr/bin/env", "valgrind", "--tool=callgrind",
                                     "--callgrind-out-file=/dev/null"});
  simulate.push_back(std::to_string(shots));
  const support::Finished ran = support::run(simulate);
  const std::string label = "Collected : ";
  const auto at = ran.err.find(label);
  if (ran.status != 0 || at == std::string::npos) return std::nullopt;
  return std::stod(ran.err.substr(at + label.size()));
}

}  // namespace

std::optional<double> instructions_a_shot(const std::vector<std::string>& simulate, double one_s,
                                          std::size_t shots) {
  if (one_s > longest_s) return std::nullopt;
  const auto fit = static_cast<std::size_t>(enough_s / one_s);
  const std::size_t count = std::clamp<std::size_t>(fit, 1, std::min(most_shots, shots));
  static const auto none = counted(simulate, 0);  // the same for all: nothing is simulated
  const auto all = counted(simulate, count);
  if (!none || !all) return std::nullopt;
  return (*all - *none) / static_cast<double>(count);
}

std::optional<double> instructions_a_shot_between(const std::vector<std::string>& simulate,
                                                  std::size_t few, std::size_t many) {
  const auto less = counted(simulate, few);
  const auto more = counted(simulate, many);
  if (!less || !more) return std::nullopt;
  return (*more - *less) / static_cast<double>(many - few);
}

}  // namespace breakshot::bench
