// What can happen in a shot, each with its time; and the shot that is made of it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/physics/ball.hpp"
#include "common/physics/segment.hpp"

namespace breakshot::physics {

// Events. Times are seconds since the start of the shot. `pass` is the pass within the set of
// simultaneous contacts in which a contact was resolved, 0 for nearly all.

template <class Real>
struct BasicStruck {
  Real time_s{};
  BallId ball{};
  friend bool operator==(const BasicStruck&, const BasicStruck&) = default;
};

template <class Real>
struct BasicBallBall {
  Real time_s{};
  std::uint32_t pass = 0;
  BallId lower{};
  BallId higher{};
  friend bool operator==(const BasicBallBall&, const BasicBallBall&) = default;
};

template <class Real>
struct BasicBallCushion {
  Real time_s{};
  std::uint32_t pass = 0;
  BallId ball{};
  CushionId cushion{};
  friend bool operator==(const BasicBallCushion&, const BasicBallCushion&) = default;
};

template <class Real>
struct BasicBallPocket {
  Real time_s{};
  std::uint32_t pass = 0;
  BallId ball{};
  PocketId pocket{};
  friend bool operator==(const BasicBallPocket&, const BasicBallPocket&) = default;
};

template <class Real>
struct BasicRolls {
  Real time_s{};
  BallId ball{};
  friend bool operator==(const BasicRolls&, const BasicRolls&) = default;
};

/// A ball that spins in place from here on.
template <class Real>
struct BasicSpins {
  Real time_s{};
  BallId ball{};
  friend bool operator==(const BasicSpins&, const BasicSpins&) = default;
};

template <class Real>
struct BasicRests {
  Real time_s{};
  BallId ball{};
  friend bool operator==(const BasicRests&, const BasicRests&) = default;
};

/// The alternatives stand in the order of their rank, which orders events of one instant and pass.
template <class Real>
using BasicEvent =
    std::variant<BasicStruck<Real>, BasicBallBall<Real>, BasicBallCushion<Real>,
                 BasicBallPocket<Real>, BasicRolls<Real>, BasicSpins<Real>, BasicRests<Real>>;

using Struck = BasicStruck<double>;
using BallBall = BasicBallBall<double>;
using BallCushion = BasicBallCushion<double>;
using BallPocket = BasicBallPocket<double>;
using Rolls = BasicRolls<double>;
using Spins = BasicSpins<double>;
using Rests = BasicRests<double>;
using Event = BasicEvent<double>;

template <class Real>
Real time_of(const BasicEvent<Real>& event) {
  return std::visit([](const auto& e) { return e.time_s; }, event);
}

/// The balls of an event, ascending; the second is missing where there is but one.
struct BallsOf {
  BallId first{};
  std::optional<BallId> second;
};

template <class Real>
BallsOf balls_of(const BasicEvent<Real>& event) {
  return std::visit(
      [](const auto& e) -> BallsOf {
        if constexpr (requires { e.ball; })
          return {e.ball, std::nullopt};
        else
          return {e.lower, e.higher};
      },
      event);
}

/// The pass of a contact; phase ends and strikes belong to the first.
template <class Real>
std::uint32_t pass_of(const BasicEvent<Real>& event) {
  return std::visit(
      [](const auto& e) -> std::uint32_t {
        if constexpr (requires { e.pass; })
          return e.pass;
        else
          return 0;
      },
      event);
}

/// The order of events: time, pass, rank of the kind, ids.
template <class Real>
bool comes_before(const BasicEvent<Real>& a, const BasicEvent<Real>& b) {
  if (time_of(a) != time_of(b)) return time_of(a) < time_of(b);
  if (pass_of(a) != pass_of(b)) return pass_of(a) < pass_of(b);
  if (a.index() != b.index()) return a.index() < b.index();
  const BallsOf p = balls_of(a);
  const BallsOf q = balls_of(b);
  if (p.first != q.first) return p.first < q.first;
  if (p.second != q.second) return p.second < q.second;
  const auto* cushion_a = std::get_if<BasicBallCushion<Real>>(&a);
  const auto* cushion_b = std::get_if<BasicBallCushion<Real>>(&b);
  return cushion_a != nullptr && cushion_b != nullptr && cushion_a->cushion < cushion_b->cushion;
}

/// Why a simulation ended.
enum class Stop : std::uint8_t {
  rest,     ///< every ball is at rest or pocketed
  horizon,  ///< the time limit was reached
};

/// Everything that happened: enough to draw it, judge it and store it.
template <class Real>
struct BasicShot {
  /// Ordered by (time, pass, rank of the kind, ids).
  std::vector<BasicEvent<Real>> events;
  /// The motion of every ball: first one segment a ball with start 0, in order of id, then one for
  /// every ball that an instant's events changed, ordered by (start, id). A segment lasts until the
  /// next one of its ball.
  std::vector<BasicSegment<Real>> segments;
  /// The last instant: that of the last event at rest, else the horizon, s.
  Real end_s{};
  Stop stop = Stop::rest;

  friend bool operator==(const BasicShot&, const BasicShot&) = default;
};

using Shot = BasicShot<double>;

/// Why a simulation could not go on.
enum class StallCause : std::uint8_t {
  passes,   ///< a set of contacts was not at peace within the pass limit
  instant,  ///< sets followed one another without time passing
  events,   ///< the event limit was reached
};

/// A shot that could not be brought to an end within its limits, with all that had happened.
template <class Real>
struct BasicStalled {
  StallCause cause = StallCause::events;
  std::vector<BallId> balls;  ///< those of the last set, ascending
  BasicShot<Real> so_far;
};

using Stalled = BasicStalled<double>;

}  // namespace breakshot::physics
