#include <algorithm>

#include "common/match/match.hpp"

namespace breakshot::match {

hash::Digest commitment_of(const Secret& secret) {
  return hash::sha256(secret);
}

physics::Seed seed_of(const Secret& secret, const std::vector<Contribution>& contributions) {
  std::vector<std::uint8_t> bytes;
  for (const Contribution& contribution : contributions) {
    bytes.insert(bytes.end(), contribution.begin(), contribution.end());
  }
  const hash::Digest digest = hash::hmac_sha256(secret, bytes);
  physics::Seed seed{};
  std::copy_n(digest.begin(), seed.size(), seed.begin());
  return seed;
}

}  // namespace breakshot::match
