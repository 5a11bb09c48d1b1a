#include "common/physics/perturbation.hpp"

namespace breakshot::physics {
namespace {

constexpr std::uint32_t multiplier_0 = 0xD2511F53;
constexpr std::uint32_t multiplier_1 = 0xCD9E8D57;
constexpr std::uint32_t weyl_0 = 0x9E3779B9;
constexpr std::uint32_t weyl_1 = 0xBB67AE85;
constexpr int rounds = 10;

PhiloxCounter round_of(const PhiloxCounter& c, const PhiloxKey& k) {
  const std::uint64_t product_0 = std::uint64_t{multiplier_0} * c[0];
  const std::uint64_t product_1 = std::uint64_t{multiplier_1} * c[2];
  return {static_cast<std::uint32_t>(product_1 >> 32) ^ c[1] ^ k[0],
          static_cast<std::uint32_t>(product_1),
          static_cast<std::uint32_t>(product_0 >> 32) ^ c[3] ^ k[1],
          static_cast<std::uint32_t>(product_0)};
}

std::uint32_t little_endian_word(const Seed& seed, std::size_t word) {
  std::uint32_t value = 0;
  for (std::size_t byte = 4; byte-- > 0;) value = value << 8 | seed[4 * word + byte];
  return value;
}

}  // namespace

PhiloxCounter philox(PhiloxCounter counter, PhiloxKey key) {
  for (int i = 0; i < rounds; ++i) {
    counter = round_of(counter, key);
    key[0] += weyl_0;
    key[1] += weyl_1;
  }
  return counter;
}

PhiloxKey key_of(const ShotSeed& seed, Stream stream) {
  PhiloxCounter counter{};
  for (std::size_t word = 0; word < counter.size(); ++word) {
    counter[word] = little_endian_word(seed.seed, word);
  }
  const PhiloxCounter block = philox(counter, {seed.shot, static_cast<std::uint32_t>(stream)});
  return {block[0], block[1]};
}

double symmetric(const PhiloxCounter& block) {
  const std::int64_t sum = std::int64_t{block[0]} + block[1] - block[2] - block[3];
  return static_cast<double>(sum) / 8589934592.0;  // 2^33
}

}  // namespace breakshot::physics
