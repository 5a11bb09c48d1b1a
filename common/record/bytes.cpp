#include "common/record/bytes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "common/record/text.hpp"

namespace breakshot::record {
namespace {

constexpr std::size_t count_width = sizeof(std::uint32_t);

std::string beyond(std::size_t count, std::size_t limit) {
  return "a count of " + std::to_string(count) + " is beyond the limit of " + std::to_string(limit);
}

constexpr std::string_view not_finite = "not a finite number";

std::string held(const TextFault& fault) {
  return "a text " + fault.what;
}

}  // namespace

void Codec::fail(std::size_t offset, const std::string& what) {
  if (failed()) return;
  const std::string where = path_.text();
  damage_ = {offset, where.empty() ? what : where + ": " + what};
}

// ---- Writer

void Writer::put(std::uint64_t value, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) {
    bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

void Writer::number(double value) {
  if (!std::isfinite(value)) fail(bytes_.size(), std::string(not_finite));
  put(std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value), sizeof value);
}

void Writer::choice(std::size_t& index, std::span<const Choice> choices) {
  if (index >= choices.size()) {
    return fail(bytes_.size(), std::to_string(index) + " is no member of the enumeration");
  }
  put(choices[index].tag, 1);
}

void Writer::count(std::size_t& value, std::size_t limit) {
  if (value > limit) fail(bytes_.size(), beyond(value, limit));
  put(value, count_width);
}

void Writer::text(const std::string& value, std::size_t limit) {
  std::size_t size = value.size();
  count(size, limit);
  if (const auto fault = text_fault(value)) fail(bytes_.size() + fault->offset, held(*fault));
  raw(hash::bytes_of(value));
}

ByteVector Writer::taken(std::string_view what) && {
  if (failed()) {
    throw std::logic_error(std::string(what) + " cannot be recorded: " + damage()->what);
  }
  return std::move(bytes_);
}

// ---- Reader

hash::Bytes Reader::take(std::size_t width) {
  if (failed()) return {};
  const std::size_t left = bytes_.size() - offset_;
  if (width > left) {
    fail(offset_, "cut off: " + std::to_string(width) + " bytes belong here, " +
                      std::to_string(left) + " are left");
    return {};
  }
  const hash::Bytes taken = bytes_.subspan(offset_, width);
  offset_ += width;
  return taken;
}

std::uint64_t Reader::get(std::size_t width) {
  std::uint64_t value = 0;
  std::size_t shift = 0;
  for (const std::uint8_t byte : take(width)) {
    value |= std::uint64_t{byte} << shift;
    shift += 8;
  }
  return value;
}

void Reader::number(double& value) {
  const std::size_t begin = offset_;
  value = std::bit_cast<double>(get(sizeof value));
  if (!std::isfinite(value)) fail(begin, std::string(not_finite));
  if (value == 0 && std::signbit(value)) fail(begin, "minus zero, which is stored as plus zero");
  if (failed()) value = 0;
}

void Reader::choice(std::size_t& index, std::span<const Choice> choices) {
  const std::size_t begin = offset_;
  const auto tag = static_cast<std::uint8_t>(get(1));
  index = 0;
  if (failed()) return;
  const auto found =
      std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.tag == tag; });
  if (found != choices.end()) {
    index = static_cast<std::size_t>(found - choices.begin());
    return;
  }
  std::string known;
  for (const Choice& c : choices) {
    known += (known.empty() ? "" : ", ") + std::to_string(c.tag) + ' ' + std::string(c.name);
  }
  fail(begin, "tag " + std::to_string(tag) + " is none of " + known);
}

void Reader::count(std::size_t& value, std::size_t limit) {
  const std::size_t begin = offset_;
  value = static_cast<std::size_t>(get(count_width));
  const std::size_t left = bytes_.size() - offset_;
  if (value > limit) {
    fail(begin, beyond(value, limit));
  } else if (value > left) {
    fail(begin, "a count of " + std::to_string(value) + " does not fit into the " +
                    std::to_string(left) + " bytes left");
  }
  if (failed()) value = 0;
}

void Reader::text(std::string& value, std::size_t limit) {
  std::size_t size = 0;
  count(size, limit);
  const std::size_t begin = offset_;
  const hash::Bytes bytes = take(size);
  value.assign(bytes.begin(), bytes.end());
  if (const auto fault = text_fault(value)) fail(begin + fault->offset, held(*fault));
}

void Reader::raw(std::span<std::uint8_t> bytes) {
  const hash::Bytes taken = take(bytes.size());
  std::copy(taken.begin(), taken.end(), bytes.begin());
}

void Reader::end() {
  if (!failed() && offset_ != bytes_.size()) {
    fail(offset_, std::to_string(bytes_.size() - offset_) + " bytes are left over after the end");
  }
}

}  // namespace breakshot::record
