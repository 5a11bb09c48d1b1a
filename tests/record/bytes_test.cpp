#include "common/record/bytes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace breakshot::record {
namespace {

constexpr std::array two{Choice{0, "mirror"}, Choice{4, "restitution"}};

template <class Number>
ByteVector bytes_of_number(Number number) {
  Writer writer;
  writer.number(number);
  return writer.bytes();
}

/// What a reader says of bytes that `read` reads.
template <class Read>
std::optional<Damage> damage_of(const ByteVector& bytes, Read read) {
  Reader reader(bytes);
  read(reader);
  reader.end();
  return reader.damage();
}

std::optional<Damage> damage_of_double(std::uint64_t bits) {
  return damage_of(bytes_of_number(bits), [](Reader& reader) {
    double value = 1;
    reader.number(value);
    EXPECT_TRUE(!reader.failed() || value == 0);
  });
}

TEST(Writer, PutsTheLowestByteFirst) {
  EXPECT_EQ(bytes_of_number(std::uint8_t{0x01}), (ByteVector{0x01}));
  EXPECT_EQ(bytes_of_number(std::uint32_t{0x01020304}), (ByteVector{0x04, 0x03, 0x02, 0x01}));
  EXPECT_EQ(bytes_of_number(std::int64_t{-2}),
            (ByteVector{0xfe, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff}));
  EXPECT_EQ(bytes_of_number(1.0), (ByteVector{0, 0, 0, 0, 0, 0, 0xf0, 0x3f}));
}

TEST(Writer, TurnsMinusZeroIntoPlusZero) {
  EXPECT_EQ(bytes_of_number(-0.0), ByteVector(8, 0));
}

TEST(Writer, RefusesNumbersThatAreNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    Writer writer;
    writer.enter("speed_m_s");
    writer.number(bad);
    EXPECT_EQ(writer.damage(), (Damage{0, "speed_m_s: not a finite number"}));
    EXPECT_THROW(std::move(writer).taken("the shot"), std::logic_error);
  }
}

TEST(Writer, RefusesAMemberThatTheEnumerationDoesNotHave) {
  Writer writer;
  std::size_t index = 2;
  writer.choice(index, two);
  EXPECT_EQ(writer.damage(), (Damage{0, "2 is no member of the enumeration"}));
}

TEST(Writer, KeepsToTheLimitsOfTheReader) {
  Writer full, beyond;
  full.text("abc", 3);
  EXPECT_FALSE(full.failed());
  beyond.text("abcd", 3);
  EXPECT_EQ(beyond.damage(), (Damage{0, "a count of 4 is beyond the limit of 3"}));
}

TEST(Reader, ReadsWhatTheWriterPuts) {
  Writer writer;
  writer.number(std::uint64_t{0xfedcba9876543210});
  writer.number(std::int64_t{std::numeric_limits<std::int64_t>::min()});
  writer.number(-0.1);
  writer.text("東 é", 16);
  std::size_t index = 1;
  writer.choice(index, two);
  Reader reader(writer.bytes());
  std::uint64_t big = 0;
  std::int64_t small = 0;
  double real = 0;
  std::string text;
  index = 0;
  reader.number(big);
  reader.number(small);
  reader.number(real);
  reader.text(text, 16);
  reader.choice(index, two);
  reader.end();
  EXPECT_EQ(reader.damage(), std::nullopt);
  EXPECT_EQ(big, 0xfedcba9876543210);
  EXPECT_EQ(small, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(real, -0.1);
  EXPECT_EQ(text, "東 é");
  EXPECT_EQ(index, 1u);
}

TEST(Reader, SaysHowManyBytesAreMissing) {
  const auto damage = damage_of({1, 2, 3}, [](Reader& reader) {
    std::uint32_t value = 7;
    reader.enter("rack");
    reader.number(value);
    EXPECT_EQ(value, 0u);
  });
  EXPECT_EQ(damage, (Damage{0, "rack: cut off: 4 bytes belong here, 3 are left"}));
}

TEST(Reader, RefusesNumbersThatAreNotFinite) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  const Damage refused{0, "not a finite number"};
  EXPECT_EQ(damage_of_double(bits(std::numeric_limits<double>::infinity())), refused);
  EXPECT_EQ(damage_of_double(bits(-std::numeric_limits<double>::infinity())), refused);
  EXPECT_EQ(damage_of_double(bits(std::nan(""))), refused);
  EXPECT_EQ(damage_of_double(0x7ff0000000000001), refused);
  EXPECT_EQ(damage_of_double(bits(std::numeric_limits<double>::max())), std::nullopt);
}

TEST(Reader, RefusesMinusZeroSinceTheWriterNeverPutsIt) {
  EXPECT_EQ(damage_of_double(std::bit_cast<std::uint64_t>(-0.0)),
            (Damage{0, "minus zero, which is stored as plus zero"}));
}

TEST(Reader, NamesTheTagsThatItKnows) {
  const auto damage = damage_of({3}, [](Reader& reader) {
    std::size_t index = 1;
    reader.enter("model");
    reader.choice(index, two);
    EXPECT_EQ(index, 0u);
  });
  EXPECT_EQ(damage, (Damage{0, "model: tag 3 is none of 0 mirror, 4 restitution"}));
}

TEST(Reader, RefusesACountBeyondItsLimit) {
  const auto damage = damage_of({3, 0, 0, 0, 0, 0, 0}, [](Reader& reader) {
    std::size_t count = 9;
    reader.count(count, 2);
    EXPECT_EQ(count, 0u);
  });
  EXPECT_EQ(damage, (Damage{0, "a count of 3 is beyond the limit of 2"}));
}

TEST(Reader, RefusesACountThatTheBytesLeftCannotHold) {
  const auto damage = damage_of({0xff, 0xff, 0xff, 0xff, 0, 0}, [](Reader& reader) {
    std::size_t count = 9;
    reader.count(count, unlimited);
    EXPECT_EQ(count, 0u);
  });
  EXPECT_EQ(damage, (Damage{0, "a count of 4294967295 does not fit into the 2 bytes left"}));
}

TEST(Reader, SaysWhereATextIsBad) {
  const auto read = [](Reader& reader) {
    std::string text;
    reader.enter("name");
    reader.text(text, 16);
  };
  EXPECT_EQ(damage_of({2, 0, 0, 0, 'a', 0xff}, read), (Damage{5, "name: a text must be UTF-8"}));
  EXPECT_EQ(damage_of({3, 0, 0, 0, 'a', 'b', 0x1b}, read),
            (Damage{6, "name: a text must not hold control characters"}));
}

TEST(Reader, RefusesBytesThatAreLeftOver) {
  EXPECT_EQ(damage_of({1, 2, 3},
                      [](Reader& reader) {
                        std::uint8_t value = 0;
                        reader.number(value);
                      }),
            (Damage{1, "2 bytes are left over after the end"}));
}

TEST(Reader, KeepsTheFirstDamage) {
  const auto damage = damage_of({9, 9}, [](Reader& reader) {
    std::size_t index = 0;
    std::uint64_t number = 1;
    reader.choice(index, two);
    reader.number(number);
    EXPECT_EQ(number, 0u);
  });
  EXPECT_EQ(damage, (Damage{0, "tag 9 is none of 0 mirror, 4 restitution"}));
}

}  // namespace
}  // namespace breakshot::record
