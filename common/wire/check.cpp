#include "common/wire/check.hpp"

#include <algorithm>
#include <cmath>

#include "common/lobby/lobby.hpp"
#include "common/lobby/text.hpp"
#include "common/match/match.hpp"

namespace breakshot::wire {
namespace {

template <std::size_t size>
std::array<std::uint8_t, size> sized_bytes(const std::string& value, const Where& at) {
  std::array<std::uint8_t, size> bytes{};
  if (value.size() == size) {
    std::copy(value.begin(), value.end(), bytes.begin());
  } else {
    at.refuse("has " + std::to_string(value.size()) + " bytes; it must have " +
              std::to_string(size));
  }
  return bytes;
}

}  // namespace

void Where::refuse(std::string what) const {
  if (!fault_) fault_ = physics::Fault{path(), std::move(what)};
}

std::string Where::path() const {
  if (name_ == nullptr) return {};
  std::string path = around_->path();
  if (!path.empty()) path += '.';
  path += name_;
  if (index_ >= 0) path += '[' + std::to_string(index_) + ']';
  return path;
}

double finite(double value, const Where& at) {
  if (std::isfinite(value)) return value;
  at.refuse("is NaN or infinite; it must be a finite number");
  return 0;
}

double required(bool present, double value, const Where& at) {
  if (!present) at.refuse("is missing; it must be given");
  return finite(value, at);
}

rules::Seat seat(std::uint32_t value, const Where& at) {
  if (value < match::max_practice_seats) return rules::Seat{static_cast<std::uint8_t>(value)};
  at.refuse("is " + std::to_string(value) + "; a seat is a number from 0 to 7");
  return {};
}

physics::PocketId pocket(std::uint32_t value, const Where& at) {
  if (value < 6) return physics::PocketId{static_cast<std::uint8_t>(value)};
  at.refuse("is " + std::to_string(value) + "; a pocket is a number from 0 to 5");
  return {};
}

std::array<std::uint8_t, 32> bytes32(const std::string& value, const Where& at) {
  return sized_bytes<32>(value, at);
}

std::optional<std::array<std::uint8_t, 32>> optional_bytes32(const std::string& value,
                                                             const Where& at) {
  if (value.empty()) return std::nullopt;
  return bytes32(value, at);
}

std::optional<std::array<std::uint8_t, 16>> optional_bytes16(const std::string& value,
                                                             const Where& at) {
  if (value.empty()) return std::nullopt;
  return sized_bytes<16>(value, at);
}

std::string text(const std::string& value, const Where& at) {
  if (const auto fault = lobby::text_fault(value)) {
    at.refuse(*fault);
    return {};
  }
  return value;
}

std::string preset(const std::string& value, const Where& at) {
  if (value.size() > lobby::max_preset_bytes) {
    at.refuse("has " + std::to_string(value.size()) + " bytes; it may have at most " +
              std::to_string(lobby::max_preset_bytes));
    return {};
  }
  return text(value, at);
}

std::uint8_t seat_count(std::uint32_t value, const Where& at) {
  if (value >= 1 && value <= match::max_practice_seats) return static_cast<std::uint8_t>(value);
  at.refuse("is " + std::to_string(value) + "; a match has 1 to 8 seats");
  return 1;
}

void check_per_seat(int size, const Where& at) {
  if (size <= static_cast<int>(match::max_practice_seats)) return;
  at.refuse("has " + std::to_string(size) + " values; it may have at most 8, one a seat");
}

bool known_enum(int value, int last, const Where& at) {
  if (value >= 1 && value <= last) return true;
  if (value == 0) {
    at.refuse("is missing; it must be given");
  } else {
    at.refuse("is " + std::to_string(value) + "; it must be one of 1 to " + std::to_string(last));
  }
  return false;
}

}  // namespace breakshot::wire
