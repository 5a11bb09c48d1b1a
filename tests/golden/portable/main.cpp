// golden_bits [RECORD...]: prints a line "NAME DIGEST" for each of the golden shots and versions of
// the physics, and one for each stored match that verifies, with the digest of its last entry. It
// needs nothing but the standard library, so that it can be built for any processor; what it prints
// is tests/golden/set.digests.
#include <iostream>

#include "tests/golden/set.hpp"
#include "tests/golden/stored_match.hpp"

int main(int count, char** arguments) {
  using namespace breakshot;
  for (const std::uint32_t physics : golden::golden_physics) {
    for (std::size_t number = 0; number < golden::golden_shots; ++number) {
      const golden::GoldenShot shot = golden::golden_shot(number);
      std::cout << golden::name_of(shot, physics) << ' ' << golden::digest_of(shot, physics)
                << std::endl;
    }
  }
  for (int i = 1; i < count; ++i) {
    std::cout << golden::name_of(arguments[i]) << ' ' << golden::digest_of_match(arguments[i])
              << std::endl;
  }
}
