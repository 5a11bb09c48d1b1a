#include "common/hash/hash.hpp"

#include <openssl/evp.h>

#include <stdexcept>

namespace breakshot::hash {
namespace {

// OpenSSL reads a null pointer as "no value given", even where the length says that it is empty.
const std::uint8_t* pointer_of(Bytes bytes) {
  static constexpr std::uint8_t empty = 0;
  return bytes.empty() ? &empty : bytes.data();
}

}  // namespace

Digest sha256(Bytes bytes) {
  Digest digest;
  if (EVP_Digest(pointer_of(bytes), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) !=
      1) {
    throw std::runtime_error("OpenSSL could not compute a SHA-256 digest");
  }
  return digest;
}

Digest hmac_sha256(Bytes key, Bytes bytes) {
  Digest digest;
  std::size_t written = 0;
  const auto* code =
      EVP_Q_mac(nullptr, "HMAC", nullptr, "SHA256", nullptr, pointer_of(key), key.size(),
                pointer_of(bytes), bytes.size(), digest.data(), digest.size(), &written);
  if (code == nullptr || written != digest.size()) {
    throw std::runtime_error("OpenSSL could not compute an HMAC-SHA-256 code");
  }
  return digest;
}

std::string hex_of(Bytes bytes) {
  static constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const std::uint8_t byte : bytes) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

int detail::hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace breakshot::hash
