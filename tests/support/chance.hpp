// A small generator of our own (splitmix64): std:: distributions differ between libraries, and a
// seed that is printed must mean the same everywhere.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace breakshot::support {

class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::uint32_t u32() { return static_cast<std::uint32_t>(bits()); }
  /// In [0, n).
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits() % n); }
  bool coin() { return bits() % 2 == 0; }
  /// In [low, high].
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  /// Any finite double: of any size, denormal and minus zero included.
  double real() {
    switch (below(4)) {
      case 0:
        return coin() ? 0.0 : -0.0;
      case 1:
        return between(-10, 10);
      default: {
        const double any = std::bit_cast<double>(bits());
        return std::isfinite(any) ? any : 0x1p-1074;
      }
    }
  }
  std::array<std::uint8_t, 32> bytes32() {
    std::array<std::uint8_t, 32> bytes{};
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(bits());
    return bytes;
  }
  /// One of the first `count` values of an enumeration.
  template <class Enum>
  Enum one_of(std::size_t count) {
    return static_cast<Enum>(below(count));
  }
  /// Half of the time a value, half of the time none.
  template <class Make>
  auto maybe(Make make) -> std::optional<decltype(make(*this))> {
    if (coin()) return std::nullopt;
    return make(*this);
  }
  /// At most `most` values.
  template <class Make>
  auto some(std::size_t most, Make make) {
    std::vector<decltype(make(*this))> values;
    for (std::size_t n = below(most + 1); n > 0; --n) values.push_back(make(*this));
    return values;
  }

 private:
  std::uint64_t state_;
};

}  // namespace breakshot::support
