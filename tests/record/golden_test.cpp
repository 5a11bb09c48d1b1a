// The format is a promise: records never expire. If a test here fails, the change was a new format
// version, and the old one must still be read.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "common/record/record.hpp"
#include "tests/record/fixed_record.hpp"

namespace breakshot::record {
namespace {

ByteVector contents_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Golden, FilesOfFormat1AreStillRead) {
  const Reading reading = read_file(contents_of(BREAKSHOT_GOLDEN_DIR "/format_1.breakshot"));
  EXPECT_EQ(reading.damage, std::nullopt);
  EXPECT_EQ(reading.record, fixed_record());
}

TEST(Golden, FilesOfFormat1AreStillWritten) {
  EXPECT_EQ(file_of(fixed_record()), contents_of(BREAKSHOT_GOLDEN_DIR "/format_1.breakshot"));
}

TEST(Golden, DigestsOfFormat1Hold) {
  const Record record = fixed_record();
  EXPECT_EQ(hash::hex_of(digest_of(record.header)),
            "815436b1e686bc3678ec74128b4a4a31c8ea1d894ab8fe023e4750b2dde5450b");
  EXPECT_EQ(hash::hex_of(record.entries.back().digest),
            "c109660732afa637966c619c6abf61c43d71c9b46a2510a3f7e7da141c06cd4d");
  EXPECT_EQ(hash::hex_of(hash::sha256(file_of(record))),
            "24ac2de92211f89b8c432d53cfd16801d36ffeaf05f28506357a24ef33c80467");
}

}  // namespace
}  // namespace breakshot::record
