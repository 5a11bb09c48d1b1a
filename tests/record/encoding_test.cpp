#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "common/record/record.hpp"
#include "tests/record/small_record.hpp"
#include "tests/support/arbitrary_record.hpp"

namespace breakshot::record {
namespace {

using support::Arbitrary;

/// Which alternatives the random values went through: a round trip proves nothing of what was
/// never drawn.
struct Coverage {
  std::set<std::size_t> motions, cushions, cushion_models, pockets, ball_balls, commands, events;
  std::size_t arcs = 0, tips = 0, spinning_segments = 0;

  void add(const physics::CushionModel& model) { cushion_models.insert(model.index()); }
  void add(const physics::Scene& scene) {
    motions.insert(scene.bed.motion.index());
    if (scene.ball_ball) ball_balls.insert(scene.ball_ball->index());
    if (scene.pockets) pockets.insert(scene.pockets->index());
    if (!scene.cushions) return;
    cushions.insert(scene.cushions->index());
    if (const auto* free = std::get_if<physics::FreeCushions>(&*scene.cushions)) {
      for (const auto& segment : free->segments) add(segment.model);
      arcs += free->arcs.size();
    }
  }
  void add(const Entry& entry) {
    commands.insert(entry.command.index());
    const auto* shoot = std::get_if<match::Shoot>(&entry.command);
    if (shoot != nullptr && shoot->tip != physics::Tip{}) ++tips;
    if (!entry.outcome.shot) return;
    for (const physics::Event& event : entry.outcome.shot->events) events.insert(event.index());
    for (const physics::Segment& segment : entry.outcome.shot->segments) {
      if (segment.spin != physics::Vec3{}) ++spinning_segments;
    }
  }
};

TEST(Encoding, GivesBackEveryHeader) {
  Coverage coverage;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Header header = Arbitrary(seed).header();
    coverage.add(header.settings.scene);
    ASSERT_EQ(fault_of(header), std::nullopt);
    const ByteVector bytes = encode(header);
    const auto decoded = decode_header(bytes);
    ASSERT_TRUE(std::holds_alternative<Header>(decoded)) << std::get<Damage>(decoded).what;
    EXPECT_EQ(std::get<Header>(decoded), header);
    EXPECT_EQ(encode(std::get<Header>(decoded)), bytes);
    EXPECT_EQ(digest_of(header), hash::sha256(bytes));
    const ByteVector settings = encode(header.settings);
    EXPECT_EQ(decode_settings(settings), (std::variant<match::Settings, Damage>(header.settings)));
    EXPECT_EQ(
        std::search(bytes.begin(), bytes.end(), settings.begin(), settings.end()) - bytes.begin(),
        24)
        << "as they stand in the header";
  }
  EXPECT_EQ(coverage.motions.size(), std::variant_size_v<physics::Motion>);
  EXPECT_EQ(coverage.cushions.size(), std::variant_size_v<physics::Cushions>);
  EXPECT_EQ(coverage.cushion_models.size(), std::variant_size_v<physics::CushionModel>);
  EXPECT_EQ(coverage.ball_balls.size(), std::variant_size_v<physics::BallBallModel>);
  EXPECT_EQ(coverage.pockets.size(), std::variant_size_v<physics::Pockets>);
  EXPECT_GT(coverage.arcs, 0u);
}

TEST(Encoding, GivesBackEveryEntry) {
  Coverage coverage;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const Entry entry = Arbitrary(seed).entry(2);
    coverage.add(entry);
    const ByteVector bytes = encode(entry);
    const auto decoded = decode_entry(bytes);
    ASSERT_TRUE(std::holds_alternative<Entry>(decoded)) << std::get<Damage>(decoded).what;
    EXPECT_EQ(std::get<Entry>(decoded), entry);
    EXPECT_EQ(encode(std::get<Entry>(decoded)), bytes);
  }
  EXPECT_EQ(coverage.commands.size(), std::variant_size_v<match::Command>);
  EXPECT_EQ(coverage.events.size(), std::variant_size_v<physics::Event>);
  EXPECT_GT(coverage.tips, 0u);
  EXPECT_GT(coverage.spinning_segments, 0u);
}

// The digest before, then the entry's bytes, of which the last 32 are its own digest.
TEST(Encoding, ChainsDigestsOverTheBytes) {
  const Entry entry = Arbitrary(1).entry(2);
  const hash::Digest before = hash::sha256(hash::bytes_of("before"));
  ByteVector bytes(before.begin(), before.end());
  const ByteVector encoded = encode(entry);
  bytes.insert(bytes.end(), encoded.begin(), encoded.end() - 32);
  EXPECT_EQ(digest_of(before, entry), hash::sha256(bytes));
  EXPECT_TRUE(std::equal(entry.digest.begin(), entry.digest.end(), encoded.end() - 32));
}

TEST(Encoding, HashesMinusZeroLikePlusZero) {
  Entry plus = Arbitrary(1).entry(2), minus = plus;
  plus.command = match::Place{physics::BallId{0}, {0.0, 0.0}};
  minus.command = match::Place{physics::BallId{0}, {-0.0, -0.0}};
  EXPECT_EQ(digest_of({}, minus), digest_of({}, plus));
}

// Whatever is not refused must be what the encoder would have written.
template <class Value, class Decode>
void expect_survives(const ByteVector& bytes, Decode decode) {
  const auto decoded = decode(bytes);
  if (const auto* value = std::get_if<Value>(&decoded)) {
    EXPECT_EQ(encode(*value), bytes);
  } else {
    EXPECT_LE(std::get<Damage>(decoded).offset, bytes.size());
    EXPECT_FALSE(std::get<Damage>(decoded).what.empty());
  }
}

template <class Decode>
void expect_survives_cuts_and_flips(const ByteVector& good, Decode decode) {
  using Value = std::variant_alternative_t<0, decltype(decode(good))>;
  for (std::size_t i = 0; i < good.size(); ++i) {
    SCOPED_TRACE(i);
    const ByteVector cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_TRUE(std::holds_alternative<Damage>(decode(cut)));
    expect_survives<Value>(cut, decode);
    for (const unsigned flip : {0x01u, 0x80u, 0xffu}) {
      ByteVector flipped = good;
      flipped[i] = static_cast<std::uint8_t>(flipped[i] ^ flip);
      expect_survives<Value>(flipped, decode);
    }
  }
  ByteVector longer = good;
  longer.push_back(0);
  EXPECT_TRUE(std::holds_alternative<Damage>(decode(longer)));
}

TEST(Decoding, SurvivesEveryCutAndFlip) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    Arbitrary arbitrary(seed);
    expect_survives_cuts_and_flips(encode(arbitrary.header()),
                                   [](const ByteVector& b) { return decode_header(b); });
    expect_survives_cuts_and_flips(encode(arbitrary.entry(2)),
                                   [](const ByteVector& b) { return decode_entry(b); });
  }
}

TEST(Decoding, SurvivesRandomBytes) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Arbitrary arbitrary(seed);
    ByteVector bytes(arbitrary.below(400));
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(arbitrary.below(4));
    expect_survives<Header>(bytes, [](const ByteVector& b) { return decode_header(b); });
    expect_survives<Entry>(bytes, [](const ByteVector& b) { return decode_entry(b); });
  }
}

TEST(Decoding, NamesTheFieldThatIsDamaged) {
  Entry entry = Arbitrary(2).entry(2);
  entry.author.seat.reset();
  entry.command = match::Choose{rules::Option::spot_eight};
  ByteVector bytes = encode(entry);
  // seq, no author, id, the command's tag, and then the option.
  const std::size_t option = 4 + 1 + 8 + 1;
  bytes[option] = 77;
  const Damage damage = std::get<Damage>(decode_entry(bytes));
  EXPECT_EQ(damage.offset, option);
  EXPECT_EQ(damage.what.rfind("command.option: tag 77 is none of 0 accept_table, ", 0), 0u)
      << damage.what;
}

TEST(Decoding, RefusesAFormatThatIsNotKnown) {
  ByteVector bytes = encode(Arbitrary(3).header());
  bytes[0] = 2;
  EXPECT_EQ(std::get<Damage>(decode_header(bytes)),
            (Damage{0, "format: 2 found, only 1 is known"}));
}

// ---- What may not be recorded

TEST(Encoding, RefusesWhatTheDecoderWouldNotReadBack) {
  Header header = small_header();
  header.players[0].name = "\x1b[2J";
  EXPECT_EQ(fault_of(header), "players[0].name: a text must not hold control characters");
  EXPECT_THROW(encode(header), std::logic_error);
  EXPECT_THROW(digest_of(header), std::logic_error);
  Entry entry = small_entry();
  entry.command = match::Shoot{{1, 0}, std::numeric_limits<double>::infinity(), {}};
  EXPECT_EQ(fault_of(small_header(), entry), "command.speed_m_s: not a finite number");
  EXPECT_THROW(encode(entry), std::logic_error);
  EXPECT_THROW(digest_of({}, entry), std::logic_error);
}

}  // namespace
}  // namespace breakshot::record
