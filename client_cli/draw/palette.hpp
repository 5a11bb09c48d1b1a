// Colours of the table and of the balls.
#pragma once

#include <cstdint>

#include "common/physics/ball.hpp"

namespace breakshot::client {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

namespace palette {

inline constexpr Rgb background{0x16, 0x19, 0x1e};
inline constexpr Rgb caption{0xd8, 0xdc, 0xe2};
inline constexpr Rgb cloth{0x17, 0x7a, 0x57};
inline constexpr Rgb cloth_edge{0x0f, 0x5c, 0x41};
inline constexpr Rgb cushion{0x12, 0x66, 0x49};
inline constexpr Rgb nose{0x2b, 0x96, 0x6f};
inline constexpr Rgb wood_light{0x8a, 0x4f, 0x2c};
inline constexpr Rgb wood{0x6b, 0x38, 0x1e};
inline constexpr Rgb wood_dark{0x3e, 0x1e, 0x10};
inline constexpr Rgb pearl{0xf2, 0xea, 0xd8};
inline constexpr Rgb leather{0x2a, 0x1d, 0x16};
inline constexpr Rgb hole{0x05, 0x05, 0x06};
inline constexpr Rgb chalk{0xe6, 0xf2, 0xec};
inline constexpr Rgb ivory{0xf8, 0xf4, 0xe6};
inline constexpr Rgb ink{0x14, 0x12, 0x12};
inline constexpr Rgb cue_vector{0xff, 0x2b, 0x22};
inline constexpr Rgb velocity{0x3a, 0x8c, 0xff};

}  // namespace palette

/// The colour of a ball by its number as pool balls are painted: 9 to 15 have the colours of 1 to
/// 7. A ball beyond 15 takes the colour of its number modulo 15.
Rgb colour_of(physics::BallId ball);

/// 9 to 15.
bool is_striped(physics::BallId ball);

/// Black or white, whichever is easier to read on `ground`.
Rgb readable_on(Rgb ground);

/// a where share is 0, b where it is 1.
Rgb mixed(Rgb a, Rgb b, double share);

}  // namespace breakshot::client
