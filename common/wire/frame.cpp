#include "common/wire/frame.hpp"

#include <algorithm>
#include <utility>

namespace breakshot::wire {

std::variant<ByteVector, Unfinished, TooLong> FrameDecoder::take(
    std::span<const std::uint8_t>& input) {
  while (header_size_ < frame_header_bytes && !input.empty()) {
    header_[header_size_++] = input.front();
    input = input.subspan(1);
    if (header_size_ == frame_header_bytes) too_long_ = announced() > limit_;
  }
  if (header_size_ < frame_header_bytes) return Unfinished{};
  if (too_long_) return TooLong{announced(), limit_};

  const std::size_t missing = announced() - body_.size();
  const auto piece = input.first(std::min(missing, input.size()));
  body_.insert(body_.end(), piece.begin(), piece.end());
  input = input.subspan(piece.size());
  if (piece.size() < missing) return Unfinished{};

  header_size_ = 0;
  return std::exchange(body_, {});
}

std::uint32_t FrameDecoder::announced() const {
  std::uint32_t length = 0;
  for (const std::uint8_t byte : header_) length = length << 8 | byte;
  return length;
}

std::array<std::uint8_t, frame_header_bytes> frame_header(std::uint32_t size) {
  return {static_cast<std::uint8_t>(size >> 24), static_cast<std::uint8_t>(size >> 16),
          static_cast<std::uint8_t>(size >> 8), static_cast<std::uint8_t>(size)};
}

}  // namespace breakshot::wire
