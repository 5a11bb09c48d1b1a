#include "common/wire/translate.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>
#include <variant>

#include "common/physics/simulate.hpp"
#include "tests/wire/samples.hpp"

namespace breakshot::wire {
namespace {

using samples::Chance;

/// The body of a frame, whose header must be right.
hash::Bytes body_of(const ByteVector& frame) {
  const hash::Bytes body = hash::Bytes(frame).subspan(frame_header_bytes);
  const auto header = frame_header(static_cast<std::uint32_t>(body.size()));
  EXPECT_TRUE(std::equal(header.begin(), header.end(), frame.begin()));
  return body;
}

template <class Value>
std::string fault_text(const std::variant<Value, Malformed>& read) {
  const auto* malformed = std::get_if<Malformed>(&read);
  return malformed == nullptr ? "" : malformed->fault.field + ": " + malformed->fault.what;
}

/// Reads back what was asked: the same value, and from it the same bytes.
void expect_round_trip(const lobby::Asked& asked) {
  const ByteVector frame = frame_of(asked);
  const auto read = read_asked(body_of(frame));
  ASSERT_TRUE(std::holds_alternative<lobby::Asked>(read)) << fault_text(read);
  EXPECT_TRUE(std::get<lobby::Asked>(read) == asked);
  EXPECT_EQ(frame_of(std::get<lobby::Asked>(read)), frame);
}

void expect_round_trip(const lobby::Told& told) {
  const ByteVector frame = frame_of(told);
  const auto read = read_told(body_of(frame));
  ASSERT_TRUE(std::holds_alternative<lobby::Told>(read)) << fault_text(read);
  EXPECT_TRUE(std::get<lobby::Told>(read) == told);
  EXPECT_EQ(frame_of(std::get<lobby::Told>(read)), frame);
}

TEST(Translate, BringsEveryRequestOverAsItIs) {
  for (std::size_t kind = 0; kind < samples::request_kinds; ++kind) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      SCOPED_TRACE("request " + std::to_string(kind) + ", seed " + std::to_string(seed));
      Chance chance(seed);
      const lobby::RequestId id{chance.u32() | 1};
      expect_round_trip(lobby::Asked{id, samples::random_request(chance, kind)});
      if (HasFailure()) return;
    }
  }
}

TEST(Translate, BringsEveryAnswerOverAsItIs) {
  for (std::size_t kind = 0; kind < samples::answer_kinds; ++kind) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      SCOPED_TRACE("answer " + std::to_string(kind) + ", seed " + std::to_string(seed));
      Chance chance(seed);
      const lobby::RequestId id{chance.u32()};
      expect_round_trip(lobby::Told{id, samples::random_answer(chance, kind)});
      if (HasFailure()) return;
    }
  }
}

TEST(Translate, BringsEveryBitOfAShotOver) {
  // Equality of doubles takes -0 for 0; the bits must be the same too.
  Chance chance(7);
  record::Entry entry = samples::random_entry(chance);
  entry.outcome.shot = samples::random_shot(chance, 40);
  entry.outcome.shot->segments.front().velocity = {-0.0, 0x1p-1074};
  entry.outcome.shot->segments.front().spin = {0, -0.0, 0x1p-1074};
  const auto shared = std::make_shared<const record::Entry>(entry);
  const ByteVector frame = frame_of(lobby::Told{{}, lobby::EntryNews{match::MatchId{1}, shared}});
  const auto read = read_told(body_of(frame));
  ASSERT_TRUE(std::holds_alternative<lobby::Told>(read)) << fault_text(read);
  const auto& news = std::get<lobby::EntryNews>(std::get<lobby::Told>(read).answer);
  const physics::Segment& segment = news.entry->outcome.shot->segments.front();
  EXPECT_TRUE(std::signbit(segment.velocity.x));
  EXPECT_EQ(segment.velocity.y, 0x1p-1074);
  EXPECT_TRUE(std::signbit(segment.spin.y));
  EXPECT_EQ(segment.spin.z, 0x1p-1074);
}

/// As many bytes as events can take: each changes two balls, and no number is 0.
physics::Shot longest_shot() {
  physics::Shot shot;
  const auto segment = [&](std::uint32_t ball, double t) {
    shot.segments.push_back({physics::BallId{ball},
                             physics::Phase::slide,
                             t,
                             {0.1, 0.2},
                             {0.3, 0.4},
                             {0.5, 0.6},
                             {0.7, 0.8, 0.9},
                             {1.1, 1.2, 1.3}});
  };
  for (std::uint32_t ball = 0; ball < 16; ++ball) segment(ball, 0);
  for (std::size_t i = 0; i < physics::max_match_events; ++i) {
    const double t = 0.1 * static_cast<double>(i + 1);
    shot.events.push_back(physics::BallBall{t, 200, physics::BallId{14}, physics::BallId{15}});
    segment(14, t);
    segment(15, t);
  }
  shot.end_s = physics::time_of(shot.events.back());
  return shot;
}

TEST(Translate, FitsTheLongestShotOfAMatchIntoAFrame) {
  Chance chance(3);
  record::Entry entry = samples::random_entry(chance);
  entry.outcome.shot = longest_shot();
  const auto shared = std::make_shared<const record::Entry>(entry);
  const lobby::Told told{{}, lobby::EntryNews{match::MatchId{1}, shared}};
  expect_round_trip(told);
  const std::size_t size = frame_of(told).size() - frame_header_bytes;
  EXPECT_LE(size, max_answer_frame);
  EXPECT_GT(size, max_answer_frame / 2) << "the limit need not be so large";
}

TEST(Translate, FitsTheLongestHelloIntoTheSmallestFrame) {
  std::string name;
  for (int i = 0; i < 32; ++i) name += "😀";
  Chance chance(1);
  const lobby::Hello hello{0xffffffff, name, chance.bytes32()};
  const ByteVector frame = frame_of(lobby::Asked{lobby::RequestId{0xffffffff}, hello});
  EXPECT_LE(frame.size() - frame_header_bytes, max_hello_frame);
}

TEST(Translate, SaysHelloAsTheProtocolDescribesIt) {
  const lobby::Asked asked{lobby::RequestId{1}, lobby::Hello{2, "Ada", std::nullopt}};
  const ByteVector documented = {0x00, 0x00, 0x00, 0x0b, 0x08, 0x01, 0x12, 0x07,
                                 0x08, 0x02, 0x12, 0x03, 0x41, 0x64, 0x61};
  EXPECT_EQ(frame_of(asked), documented) << "as in docs/protocol.md";
}

TEST(Translate, ReadsACodeAsItWasMeant) {
  const lobby::Join join{std::nullopt, "o123456789", {}};
  const ByteVector frame = frame_of(lobby::Asked{lobby::RequestId{1}, join});
  const auto read = read_asked(body_of(frame));
  const auto& asked = std::get<lobby::Asked>(read);
  EXPECT_EQ(std::get<lobby::Join>(asked.request).code, "0123456789");
}

}  // namespace
}  // namespace breakshot::wire
