// The alphabet of the canonical encoding, once for writing and once for reading: little-endian
// numbers of fixed width, counts, counted text, raw bytes and choices by tag. What values are made
// of these is said once for both, in describe_*.hpp.
//
// Both remember only the first thing that is wrong and go on without effect: a description needs no
// checks of its own. Each accepted value has exactly one encoding, so that decoding and encoding
// again gives the same bytes.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/hash/hash.hpp"
#include "common/record/path.hpp"
#include "common/record/record.hpp"

namespace breakshot::record {

/// A member of a closed set: its byte, which never changes, and its name.
struct Choice {
  std::uint8_t tag = 0;
  std::string_view name;
};

/// A limit for what is hashed but never decoded.
inline constexpr std::size_t unlimited = std::numeric_limits<std::uint32_t>::max();

/// What all codecs share: the path, and the first thing that was wrong.
class Codec {
 public:
  bool failed() const { return damage_.has_value(); }
  const std::optional<Damage>& damage() const { return damage_; }
  void leave() { path_.leave(); }

  /// Checks a rule that spans several fields; `fault` says what is wrong with the innermost value.
  template <class Fault>
  void rule(Fault fault) {
    if (failed()) return;
    if (const std::optional<std::string> what = fault()) fail(path_.offset(), *what);
  }

 protected:
  void fail(std::size_t offset, const std::string& what);

  Path path_;

 private:
  std::optional<Damage> damage_;
};

class Writer : public Codec {
 public:
  static constexpr bool writing = true;

  void enter(std::string_view field) { path_.enter(field, bytes_.size()); }
  void enter(std::size_t index) { path_.enter(index, bytes_.size()); }

  template <std::integral Number>
  void number(Number value) {
    put(static_cast<std::uint64_t>(value), sizeof value);
  }
  /// The bits of a finite number; minus zero becomes plus zero.
  void number(double value);
  /// Writes the tag of choices[index].
  void choice(std::size_t& index, std::span<const Choice> choices);
  void count(std::size_t& value, std::size_t limit);
  void end_of_list(std::size_t) {}
  void text(const std::string& value, std::size_t limit);
  void raw(hash::Bytes bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  const ByteVector& bytes() const { return bytes_; }
  /// The bytes; `what` names the value. std::logic_error if anything was wrong with it.
  ByteVector taken(std::string_view what) &&;

 private:
  void put(std::uint64_t value, std::size_t width);

  ByteVector bytes_;
};

class Reader : public Codec {
 public:
  static constexpr bool writing = false;

  explicit Reader(hash::Bytes bytes) : bytes_(bytes) {}

  void enter(std::string_view field) { path_.enter(field, offset_); }
  void enter(std::size_t index) { path_.enter(index, offset_); }

  template <std::integral Number>
  void number(Number& value) {
    value = static_cast<Number>(get(sizeof value));
  }
  /// Refuses NaN, infinity and minus zero.
  void number(double& value);
  /// The index of the choice whose tag is read.
  void choice(std::size_t& index, std::span<const Choice> choices);
  /// A number of elements: within `limit` and, at a byte each, within the bytes left.
  void count(std::size_t& value, std::size_t limit);
  void end_of_list(std::size_t) {}
  void text(std::string& value, std::size_t limit);
  void raw(std::span<std::uint8_t> bytes);

  std::size_t offset() const { return offset_; }
  /// The next `width` bytes; none if there are fewer.
  hash::Bytes take(std::size_t width);
  /// Refuses bytes that are left over.
  void end();

 private:
  std::uint64_t get(std::size_t width);

  hash::Bytes bytes_;
  std::size_t offset_ = 0;
};

}  // namespace breakshot::record
