#include <gtest/gtest.h>

#include "common/record/record.hpp"
#include "tests/record/fixed_record.hpp"
#include "tests/support/arbitrary_record.hpp"

namespace breakshot::record {
namespace {

constexpr std::size_t magic_size = 14;
constexpr std::size_t count_size = 4;
constexpr std::size_t digest_size = 32;

/// Where each part of a file ends: magic, header with its digest, entries, end mark.
std::vector<std::size_t> ends_of_parts(const Record& record) {
  std::vector<std::size_t> ends{magic_size};
  ends.push_back(ends.back() + count_size + encode(record.header).size() + digest_size);
  for (const Entry& entry : record.entries) {
    ends.push_back(ends.back() + count_size + encode(entry).size());
  }
  ends.push_back(ends.back() + count_size);
  return ends;
}

/// A small record of three entries, so that every byte of it can be damaged.
Record small() {
  Record record = fixed_record();
  record.entries.resize(3);
  return record;
}

/// Damaged within the part that begins at `begin` and ends at `end`; `parts` were whole before it.
void expect_prefix(const Reading& reading, const Record& record, std::size_t parts,
                   std::size_t begin, std::size_t end) {
  ASSERT_TRUE(reading.damage);
  EXPECT_GE(reading.damage->offset, begin) << reading.damage->what;
  EXPECT_LE(reading.damage->offset, end) << reading.damage->what;
  EXPECT_FALSE(reading.damage->what.empty());
  ASSERT_EQ(reading.record.has_value(), parts >= 2);
  if (!reading.record) return;
  EXPECT_EQ(reading.record->header, record.header);
  ASSERT_EQ(reading.record->entries.size(), parts - 2);
  EXPECT_TRUE(std::equal(reading.record->entries.begin(), reading.record->entries.end(),
                         record.entries.begin()));
}

TEST(File, GivesBackEveryRecord) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    support::Arbitrary arbitrary(seed);
    const Record record = arbitrary.record(arbitrary.below(6));
    const Reading reading = read_file(file_of(record));
    ASSERT_EQ(reading.damage, std::nullopt);
    EXPECT_EQ(reading.record, record);
  }
}

TEST(File, HasTheLengthsThatTheFormatSays) {
  EXPECT_EQ(file_of(small()).size(), ends_of_parts(small()).back());
}

TEST(File, YieldsItsPrefixWhereverItIsCutOff) {
  const Record record = small();
  const ByteVector file = file_of(record);
  const auto ends = ends_of_parts(record);
  std::size_t part = 0;
  for (std::size_t cut = 0; cut < file.size(); ++cut) {
    SCOPED_TRACE(cut);
    while (ends[part] <= cut) ++part;
    const hash::Bytes left = hash::Bytes(file).first(cut);
    expect_prefix(read_file(left), record, part, part == 0 ? 0 : ends[part - 1], cut);
  }
}

TEST(File, YieldsItsPrefixWhicheverBitIsFlipped) {
  const Record record = small();
  const ByteVector file = file_of(record);
  const auto ends = ends_of_parts(record);
  std::size_t part = 0;
  for (std::size_t at = 0; at < file.size(); ++at) {
    SCOPED_TRACE(at);
    while (ends[part] <= at) ++part;
    ByteVector flipped = file;
    flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ (1u << (at % 8)));
    expect_prefix(read_file(flipped), record, part, part == 0 ? 0 : ends[part - 1], ends[part]);
  }
}

TEST(File, SurvivesRandomBytesBehindItsMagic) {
  const ByteVector file = file_of(small());
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    support::Arbitrary arbitrary(seed);
    ByteVector bytes(file.begin(), file.begin() + magic_size);
    for (std::uint64_t i = arbitrary.below(300); i > 0; --i) {
      bytes.push_back(static_cast<std::uint8_t>(arbitrary.below(3)));
    }
    const Reading reading = read_file(bytes);
    EXPECT_TRUE(reading.damage);
    EXPECT_FALSE(reading.record);
  }
}

TEST(File, SaysThatItIsNotOne) {
  const Reading reading = read_file(hash::bytes_of("{\"scene\": {}}"));
  EXPECT_FALSE(reading.record);
  ASSERT_TRUE(reading.damage);
  EXPECT_EQ(reading.damage->offset, 0u);
  EXPECT_EQ(reading.damage->what.rfind("not a breakshot file", 0), 0u) << reading.damage->what;
}

TEST(File, SaysThatLineEndsWereRewritten) {
  ByteVector file = file_of(small());
  file.erase(file.begin() + 10);  // "\r\n" became "\n"
  EXPECT_EQ(read_file(file).damage->offset, 10u);
}

TEST(File, SaysThatItsFormatIsNotKnown) {
  ByteVector file = file_of(small());
  file[magic_size + count_size] = 2;
  const Reading reading = read_file(file);
  EXPECT_FALSE(reading.record);
  EXPECT_EQ(reading.damage,
            (Damage{magic_size + count_size, "header: format: 2 found, only 1 is known"}));
}

TEST(File, SaysThatBytesAreLeftOver) {
  const Record record = small();
  ByteVector file = file_of(record);
  const std::size_t size = file.size();
  file.push_back(0);
  const Reading reading = read_file(file);
  EXPECT_EQ(reading.record, record);
  EXPECT_EQ(reading.damage, (Damage{size, "1 bytes are left over after the end"}));
}

// ---- What the bytes of one entry do not show

/// The file of a record whose digests hold, whatever else does not.
Reading read_rechained(Record record) {
  hash::Digest before = digest_of(record.header);
  for (Entry& entry : record.entries) entry.digest = before = digest_of(before, entry);
  return read_file(file_of(record));
}

void expect_damage(const Reading& reading, std::size_t entries, const std::string& what) {
  ASSERT_TRUE(reading.record);
  EXPECT_EQ(reading.record->entries.size(), entries);
  ASSERT_TRUE(reading.damage);
  EXPECT_EQ(reading.damage->what, what);
}

TEST(File, RefusesAnEntryOutOfSequence) {
  Record record = small();
  record.entries[1].seq = match::Seq{5};
  expect_damage(read_rechained(record), 1, "entry 1: seq: 5 stored, 1 is the next");
}

TEST(File, RefusesABrokenChain) {
  Record record = small();
  record.entries[1].id = match::CommandId{1};
  const Reading reading = read_file(file_of(record));
  ASSERT_TRUE(reading.damage);
  EXPECT_EQ(reading.record->entries.size(), 1u);
  EXPECT_EQ(reading.damage->offset, ends_of_parts(record)[2] + count_size);
  EXPECT_EQ(reading.damage->what.rfind("entry 1: digest: ", 0), 0u) << reading.damage->what;
}

TEST(File, RefusesAnEntryAfterTheSecret) {
  Record record = small();
  record.entries[0].secret.emplace();
  expect_damage(read_rechained(record), 1,
                "entry 1: comes after the entry with the secret, which is the last of a match");
}

TEST(File, RefusesSeatsThatTheMatchDoesNotHave) {
  Record record = small();
  record.entries[2].author.seat = match::Seat{2};
  expect_damage(read_rechained(record), 2, "entry 2: author.seat: seat 2 of a match with 2");
}

}  // namespace
}  // namespace breakshot::record
