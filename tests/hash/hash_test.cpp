#include "common/hash/hash.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace breakshot::hash {
namespace {

struct Sha256Vector {
  std::string message;
  std::string digest;
};

// NIST, "Secure Hash Standard" (FIPS 180-4) example values and the long message of its test suite.
TEST(Sha256, MatchesTheVectorsOfFips180) {
  const std::vector<Sha256Vector> vectors{
      {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
      {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
      {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
       "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
      {std::string(1'000'000, 'a'),
       "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"},
  };
  for (const auto& vector : vectors) {
    EXPECT_EQ(hex_of(sha256(bytes_of(vector.message))), vector.digest);
  }
}

struct HmacVector {
  std::string key;
  std::string message;
  std::string code;
};

// RFC 4231, cases 1 to 4, 6 and 7; case 5 tests truncation, which is not offered.
TEST(HmacSha256, MatchesTheVectorsOfRfc4231) {
  std::string counting_key;
  for (char c = 1; c <= 25; ++c) counting_key += c;
  const std::vector<HmacVector> vectors{
      {std::string(20, '\x0b'), "Hi There",
       "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7"},
      {"Jefe", "what do ya want for nothing?",
       "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843"},
      {std::string(20, '\xaa'), std::string(50, '\xdd'),
       "773ea91e36800e46854db8ebd09181a72959098b3ef8c122d9635514ced565fe"},
      {counting_key, std::string(50, '\xcd'),
       "82558a389a443c0ea4cc819899f2083a85f0faa3e578f8077a2e3ff46729665b"},
      {std::string(131, '\xaa'), "Test Using Larger Than Block-Size Key - Hash Key First",
       "60e431591ee0b67f0d8a26aacbf5b77f8e0bc6213728c5140546040f0ee37f54"},
      {std::string(131, '\xaa'),
       "This is a test using a larger than block-size key and a larger than block-size data. "
       "The key needs to be hashed before being used by the HMAC algorithm.",
       "9b09ffa71b942fcb27635fbcd5b0e944bfdc63644f0713938a7f51535c3a35e2"},
  };
  for (const auto& vector : vectors) {
    EXPECT_EQ(hex_of(hmac_sha256(bytes_of(vector.key), bytes_of(vector.message))), vector.code);
  }
}

TEST(HmacSha256, TakesAnEmptyKeyAndAnEmptyMessage) {
  EXPECT_EQ(hex_of(hmac_sha256({}, {})),
            "b613679a0814d9ec772f95d778c35fc5ff1697c493715653c6c712144292c5ad");
}

TEST(Hex, WritesTwoLowerCaseDigitsAByte) {
  const std::array<std::uint8_t, 4> bytes{0x00, 0x0f, 0xa0, 0xff};
  EXPECT_EQ(hex_of(bytes), "000fa0ff");
  EXPECT_EQ(hex_of({}), "");
}

TEST(Hex, ReadsDigitsOfEitherCase) {
  const std::array<std::uint8_t, 3> bytes{0x01, 0xab, 0xef};
  EXPECT_EQ(bytes_of_hex<3>("01abef"), bytes);
  EXPECT_EQ(bytes_of_hex<3>("01ABeF"), bytes);
}

TEST(Hex, RefusesWhatIsNotExactlyTheDigitsAskedFor) {
  for (const std::string text : {"", "01abe", "01abe ", "01abeff", "01abeg", "0x01ab", "01ab-1"}) {
    EXPECT_FALSE(bytes_of_hex<3>(text)) << text;
  }
}

}  // namespace
}  // namespace breakshot::hash
