// Reading what others wrote: every value is checked before the domain sees it, and the first that
// is wrong is remembered with the path of its field.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "common/physics/scene.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::wire {

/// A field of a message that is being read. It refers to the fields around it, which must outlive
/// it; the path is spelt out only when something is wrong, since shots have thousands of fields.
class Where {
 public:
  /// The message itself, which the paths of its fields do not name.
  explicit Where(std::optional<physics::Fault>& fault) : fault_(fault) {}
  Where(const Where& around, const char* name) : Where(around, name, -1) {}
  Where(const Where& around, const char* name, int index)
      : around_(&around), name_(name), index_(index), fault_(around.fault_) {}

  /// `what` says what is wrong and what would be right. Only the first fault is kept.
  void refuse(std::string what) const;
  bool good() const { return !fault_; }

 private:
  std::string path() const;

  const Where* around_ = nullptr;
  const char* name_ = nullptr;
  int index_ = -1;
  std::optional<physics::Fault>& fault_;
};

// Each returns the value, or a harmless one and a fault.

double finite(double value, const Where& at);
/// A number that has no default must be there: missing is not 0.
double required(bool present, double value, const Where& at);
rules::Seat seat(std::uint32_t value, const Where& at);
physics::PocketId pocket(std::uint32_t value, const Where& at);
std::array<std::uint8_t, 32> bytes32(const std::string& value, const Where& at);
/// Empty is missing.
std::optional<std::array<std::uint8_t, 32>> optional_bytes32(const std::string& value,
                                                             const Where& at);
std::optional<std::array<std::uint8_t, 16>> optional_bytes16(const std::string& value,
                                                             const Where& at);
/// A text for people.
std::string text(const std::string& value, const Where& at);
/// The name of a scene.
std::string preset(const std::string& value, const Where& at);
/// How many seats a match has.
std::uint8_t seat_count(std::uint32_t value, const Where& at);
/// A list with one value a seat.
void check_per_seat(int size, const Where& at);

/// Checks that `value` is in [1, last]; says so otherwise.
bool known_enum(int value, int last, const Where& at);

/// Our enumerations only grow and their wire form is one more, so that 0 can mean "missing". `last`
/// is the greatest wire form.
template <class Domain>
Domain enumerated(int value, int last, const Where& at) {
  if (!known_enum(value, last, at)) return Domain{};
  return static_cast<Domain>(value - 1);
}

template <class Wire, class Domain>
Wire enum_of(Domain value) {
  return static_cast<Wire>(static_cast<int>(value) + 1);
}

}  // namespace breakshot::wire
