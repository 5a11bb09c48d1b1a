// How messages are cut out of a stream of bytes: each is preceded by its length in four bytes, the
// most significant first. The length is the only size limit of the wire, and it is checked before
// anything is allocated.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace breakshot::wire {

using ByteVector = std::vector<std::uint8_t>;

inline constexpr std::size_t frame_header_bytes = 4;

// Limits are those of the body, in bytes without the header.

/// What a server accepts from a connection that has not said hello.
inline constexpr std::size_t max_hello_frame = 512;
/// What a server accepts from a client that has.
inline constexpr std::size_t max_request_frame = 16 * 1024;
/// What a client must accept from a server: a shot of physics::max_match_events events fits.
inline constexpr std::size_t max_answer_frame = 6 * 1024 * 1024;

/// A frame was announced that is longer than the limit. The stream cannot be read any further.
struct TooLong {
  std::uint32_t announced = 0;
  std::size_t limit = 0;

  friend bool operator==(const TooLong&, const TooLong&) = default;
};
/// All input was taken and the frame is not whole yet.
struct Unfinished {
  friend bool operator==(const Unfinished&, const Unfinished&) = default;
};

/// Cuts frames out of input that arrives in pieces of any size.
class FrameDecoder {
 public:
  explicit FrameDecoder(std::size_t limit) : limit_(limit) {}

  /// Applies to headers that have not been read yet.
  void set_limit(std::size_t limit) { limit_ = limit; }

  /// Takes bytes from the front of `input` up to the end of the frame and returns its body. Memory
  /// follows the bytes that have arrived, not those that were announced. After TooLong every
  /// further call says the same.
  std::variant<ByteVector, Unfinished, TooLong> take(std::span<const std::uint8_t>& input);

 private:
  std::uint32_t announced() const;

  std::size_t limit_;
  std::array<std::uint8_t, frame_header_bytes> header_{};
  std::size_t header_size_ = 0;
  bool too_long_ = false;
  ByteVector body_;
};

/// The four bytes that go before a body of `size` bytes.
std::array<std::uint8_t, frame_header_bytes> frame_header(std::uint32_t size);

}  // namespace breakshot::wire
