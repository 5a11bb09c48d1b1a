// The shots that methods and numbers are compared on: sets of scenes, each shot a pure function of
// its number.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/wire/scenario.hpp"

namespace breakshot::bench {

struct Set {
  std::string_view name;
  std::string_view what;  ///< for readers
  std::uint32_t quick;    ///< shots of a quick study
  std::uint32_t full;     ///< of one for publication
  wire::Scenario (*shot)(std::uint32_t number);
};

const std::vector<Set>& sets();

/// The set of that name; throws if there is none.
const Set& set_of(std::string_view name);

}  // namespace breakshot::bench
