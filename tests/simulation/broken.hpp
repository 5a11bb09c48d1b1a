// What a simulated world throws when something has happened that must never happen.
#pragma once

#include <stdexcept>
#include <string>

namespace breakshot::simulation {

class Broken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& otherwise) {
  if (!holds) throw Broken(otherwise);
}

}  // namespace breakshot::simulation
