#include "common/physics/validation.hpp"

#include <array>
#include <charconv>

namespace breakshot::physics {

std::string shown(double value) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value + 0.0);
  return {text.data(), result.ptr};
}

void Faults::range(const std::string& field, double value, double least, double greatest) {
  if (value >= least && value <= greatest) return;
  add(field, "is " + shown(value) + "; it must be from " + shown(least) + " to " + shown(greatest));
}

void Faults::coordinates(const std::string& field, Vec2 position) {
  range(field + ".x", position.x, -max_coordinate_m, max_coordinate_m);
  range(field + ".y", position.y, -max_coordinate_m, max_coordinate_m);
}

}  // namespace breakshot::physics
