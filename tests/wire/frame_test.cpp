#include "common/wire/frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "tests/support/chance.hpp"

namespace breakshot::wire {
namespace {

using Input = std::span<const std::uint8_t>;

ByteVector framed(const ByteVector& body) {
  const auto header = frame_header(static_cast<std::uint32_t>(body.size()));
  ByteVector frame(header.begin(), header.end());
  frame.insert(frame.end(), body.begin(), body.end());
  return frame;
}

/// All frames that are whole after `pieces`; each piece must be taken to its end.
std::vector<ByteVector> frames_of(FrameDecoder& decoder, const std::vector<Input>& pieces) {
  std::vector<ByteVector> frames;
  for (Input piece : pieces) {
    while (true) {
      auto taken = decoder.take(piece);
      if (auto* body = std::get_if<ByteVector>(&taken)) {
        frames.push_back(std::move(*body));
        continue;
      }
      EXPECT_EQ(std::get<Unfinished>(taken), Unfinished{});
      EXPECT_TRUE(piece.empty());
      break;
    }
  }
  return frames;
}

TEST(Frame, HasItsLengthBeforeItMostSignificantByteFirst) {
  EXPECT_EQ(framed({7, 8, 9}), (ByteVector{0, 0, 0, 3, 7, 8, 9}));
  EXPECT_EQ(frame_header(0x01020304), (std::array<std::uint8_t, 4>{1, 2, 3, 4}));
}

TEST(Frame, IsWholeHoweverItIsSplit) {
  const std::vector<ByteVector> bodies = {{1, 2, 3, 4, 5}, {}, {6}, ByteVector(300, 7)};
  ByteVector stream;
  for (const ByteVector& body : bodies) {
    const ByteVector frame = framed(body);
    stream.insert(stream.end(), frame.begin(), frame.end());
  }
  const Input all(stream);
  for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
    FrameDecoder decoder(300);
    EXPECT_EQ(frames_of(decoder, {all.first(cut), all.subspan(cut)}), bodies) << "cut at " << cut;
  }
  FrameDecoder decoder(300);
  std::vector<Input> bytes;
  for (std::size_t i = 0; i < stream.size(); ++i) bytes.push_back(all.subspan(i, 1));
  EXPECT_EQ(frames_of(decoder, bytes), bodies) << "byte by byte";
}

TEST(Frame, IsWholeInPiecesOfAnySize) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    support::Chance chance(seed);
    std::vector<ByteVector> bodies;
    ByteVector stream;
    for (int i = 0; i < 20; ++i) {
      bodies.emplace_back(chance.below(200), static_cast<std::uint8_t>(i));
      const ByteVector frame = framed(bodies.back());
      stream.insert(stream.end(), frame.begin(), frame.end());
    }
    std::vector<Input> pieces;
    for (Input rest(stream); !rest.empty();) {
      const std::size_t size = std::min(rest.size(), 1 + chance.below(100));
      pieces.push_back(rest.first(size));
      rest = rest.subspan(size);
    }
    FrameDecoder decoder(200);
    EXPECT_EQ(frames_of(decoder, pieces), bodies);
  }
}

TEST(Frame, MayBeAsLongAsTheLimitAndNoLonger) {
  const ByteVector longest = framed(ByteVector(max_hello_frame, 1));
  FrameDecoder decoder(max_hello_frame);
  EXPECT_EQ(frames_of(decoder, {longest}).size(), 1u);

  const ByteVector longer = framed(ByteVector(max_hello_frame + 1, 1));
  Input input(longer);
  const TooLong expected{max_hello_frame + 1, max_hello_frame};
  EXPECT_EQ(std::get<TooLong>(decoder.take(input)), expected);
  EXPECT_EQ(input.size(), max_hello_frame + 1) << "the body is not touched";
  EXPECT_EQ(std::get<TooLong>(decoder.take(input)), expected) << "and never will be";
}

TEST(Frame, IsRefusedAtItsHeaderBeforeAnyOfItsBody) {
  for (const std::uint32_t announced : {16'385u, 0x7fffffffu, 0xffffffffu}) {
    const auto header = frame_header(announced);
    Input input(header);
    FrameDecoder decoder(max_request_frame);
    EXPECT_EQ(std::get<TooLong>(decoder.take(input)), (TooLong{announced, max_request_frame}));
  }
}

TEST(Frame, TakesNoMemoryForWhatWasOnlyAnnounced) {
  // A thousand connections that announce 4 GiB each and send one byte: this would not fit.
  const auto header = frame_header(0xffffffff);
  std::vector<FrameDecoder> decoders(1000, FrameDecoder(0xffffffff));
  const ByteVector byte = {1};
  for (FrameDecoder& decoder : decoders) {
    EXPECT_TRUE(frames_of(decoder, {Input(header), Input(byte)}).empty());
  }
}

TEST(Frame, LimitGrowsWithTrust) {
  FrameDecoder decoder(1);
  decoder.set_limit(2);
  const ByteVector frame = framed({1, 2});
  EXPECT_EQ(frames_of(decoder, {frame}), (std::vector<ByteVector>{{1, 2}}));
}

}  // namespace
}  // namespace breakshot::wire
