#include "common/record/chain.hpp"

namespace breakshot::record {

std::optional<std::string> Chain::place_fault(const Entry& entry) const {
  if (entry.seq != match::Seq{next_}) {
    return "seq: " + std::to_string(static_cast<std::uint32_t>(entry.seq)) + " stored, " +
           std::to_string(next_) + " is the next";
  }
  if (revealed_) return "comes after the entry with the secret, which is the last of a match";
  return fault_of(header_, entry);
}

std::optional<std::string> Chain::append(const Entry& entry) {
  const hash::Digest expected = digest_of(digest_, entry);
  if (entry.digest != expected) {
    return "digest: " + hash::hex_of(entry.digest) + " stored, " + hash::hex_of(expected) +
           " follows from the entry and the digest before it";
  }
  digest_ = expected;
  revealed_ = entry.secret.has_value();
  ++next_;
  return std::nullopt;
}

}  // namespace breakshot::record
