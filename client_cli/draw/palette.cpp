#include "client_cli/draw/palette.hpp"

#include <array>
#include <cmath>

namespace breakshot::client {

Rgb colour_of(physics::BallId ball) {
  static constexpr std::array<Rgb, 8> colours = {{
      {0xf5, 0xbe, 0x14},  // yellow
      {0x1c, 0x44, 0xb4},  // blue
      {0xd6, 0x24, 0x20},  // red
      {0x5e, 0x2a, 0x8c},  // purple
      {0xf0, 0x6c, 0x12},  // orange
      {0x06, 0x4c, 0x22},  // green
      {0x7e, 0x16, 0x22},  // maroon
      {0x16, 0x16, 0x18},  // black
  }};
  const std::uint32_t n = number(ball);
  if (n == 0) return palette::ivory;
  const std::uint32_t painted = (n - 1) % 15;
  return colours[painted < 8 ? painted : painted - 8];
}

bool is_striped(physics::BallId ball) {
  const std::uint32_t n = number(ball);
  return n > 0 && (n - 1) % 15 >= 8;
}

Rgb readable_on(Rgb ground) {
  // Luma by ITU-R BT.601, which is near enough to how bright a colour looks.
  const double luma = 0.299 * ground.red + 0.587 * ground.green + 0.114 * ground.blue;
  return luma > 140 ? palette::ink : palette::ivory;
}

Rgb mixed(Rgb a, Rgb b, double share) {
  const auto mix = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

}  // namespace breakshot::client
