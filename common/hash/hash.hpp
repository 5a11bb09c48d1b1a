// SHA-256 and HMAC-SHA-256 over bytes (OpenSSL), nothing else.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace breakshot::hash {

using Digest = std::array<std::uint8_t, 32>;
using Bytes = std::span<const std::uint8_t>;

/// SHA-256 of `bytes` (FIPS 180-4).
Digest sha256(Bytes bytes);

/// HMAC-SHA-256 (RFC 2104).
Digest hmac_sha256(Bytes key, Bytes bytes);

/// Lower-case hexadecimal, two digits a byte.
std::string hex_of(Bytes bytes);

/// The bytes of a hexadecimal text in either case; nothing unless it has exactly 2 * N digits.
template <std::size_t N>
std::optional<std::array<std::uint8_t, N>> bytes_of_hex(std::string_view text);

inline Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

namespace detail {
/// The value of one hexadecimal digit, or -1.
int hex_digit(char c);
}  // namespace detail

template <std::size_t N>
std::optional<std::array<std::uint8_t, N>> bytes_of_hex(std::string_view text) {
  if (text.size() != 2 * N) return std::nullopt;
  std::array<std::uint8_t, N> bytes{};
  for (std::size_t i = 0; i < N; ++i) {
    const int high = detail::hex_digit(text[2 * i]);
    const int low = detail::hex_digit(text[2 * i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    bytes[i] = static_cast<std::uint8_t>(high * 16 + low);
  }
  return bytes;
}

}  // namespace breakshot::hash
