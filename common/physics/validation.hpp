// Collects faults of inputs in one wording: what is wrong, where, and what would be right.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "common/physics/scene.hpp"

namespace breakshot::physics {

/// The shortest decimal that reads back to the same double.
std::string shown(double value);

class Faults {
 public:
  void add(std::string field, std::string what) {
    faults_.push_back({std::move(field), std::move(what)});
  }
  /// A fault unless `least` <= value <= `greatest`; NaN and infinity are out of every range.
  void range(const std::string& field, double value, double least, double greatest);
  /// A fault for each coordinate beyond max_coordinate_m.
  void coordinates(const std::string& field, Vec2 position);

  std::vector<Fault> take() { return std::move(faults_); }

 private:
  std::vector<Fault> faults_;
};

}  // namespace breakshot::physics
