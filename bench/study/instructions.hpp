// Instructions a shot, counted by callgrind: a program that simulates n shots and nothing else is
// run twice, and the difference is that of the shots.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace breakshot::bench {

/// `simulate` is the command line, without the number of shots; `one_s` is what a shot takes. None
/// where there is no valgrind, or where counting would take long.
std::optional<double> instructions_a_shot(const std::vector<std::string>& simulate, double one_s,
                                          std::size_t shots);

/// The same from two runs of so many shots.
std::optional<double> instructions_a_shot_between(const std::vector<std::string>& simulate,
                                                  std::size_t few, std::size_t many);

}  // namespace breakshot::bench
