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

}  // namespace breakshot::hash
