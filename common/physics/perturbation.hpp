// The counter-based random stream of one shot (Philox4x32-10; Salmon et al. 2011, "Parallel random
// numbers: as easy as 1, 2, 3"). A draw depends on which collision it is for, not on the order of
// evaluation.
#pragma once

#include <array>
#include <cstdint>

namespace breakshot::physics {

/// 16 bytes of a seed. The words of the generator are read from it in little-endian order.
using Seed = std::array<std::uint8_t, 16>;

/// The seed of a match or scenario and the number of the shot in it.
struct ShotSeed {
  Seed seed{};
  std::uint32_t shot = 0;

  friend bool operator==(const ShotSeed&, const ShotSeed&) = default;
};

/// Separate uses of one seed never share a draw.
enum class Stream : std::uint32_t { collisions = 1, rack = 2 };

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// One block of Philox4x32-10.
PhiloxCounter philox(PhiloxCounter counter, PhiloxKey key);

/// The key of one stream of one shot: the first two words of philox(seed, {shot, stream}).
PhiloxKey key_of(const ShotSeed& seed, Stream stream);

/// (u0 + u1 - u2 - u3) / 2^33 of a block: within [-1, 1], mean zero, exact in a double.
double symmetric(const PhiloxCounter& block);

}  // namespace breakshot::physics
