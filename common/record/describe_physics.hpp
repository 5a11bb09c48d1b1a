// What the record says of balls and shots. This is the format (docs/record.md): whatever is changed
// here but added as a new tag is a new format version.
#pragma once

#include "common/physics/event.hpp"
#include "common/physics/timeline.hpp"
#include "common/record/describe_scene.hpp"
#include "common/record/shape.hpp"

namespace breakshot::record {

template <>
inline constexpr bool is_id<physics::BallId> = true;
template <>
inline constexpr bool is_id<physics::CushionId> = true;
template <>
inline constexpr bool is_id<physics::PocketId> = true;

template <>
struct Names<physics::Phase> {
  static constexpr std::array<std::string_view, 5> all{"rest", "slide", "roll", "spin", "pocketed"};
};
template <>
struct Names<physics::Stop> {
  static constexpr std::array<std::string_view, 2> all{"rest", "horizon"};
};

// The rank of an event's kind.
template <>
inline constexpr Choice tag_of<physics::Struck>{0, "strike"};
template <>
inline constexpr Choice tag_of<physics::BallBall>{1, "ball_ball"};
template <>
inline constexpr Choice tag_of<physics::BallCushion>{2, "ball_cushion"};
template <>
inline constexpr Choice tag_of<physics::BallPocket>{3, "ball_pocket"};
template <>
inline constexpr Choice tag_of<physics::Rolls>{4, "rolls"};
template <>
inline constexpr Choice tag_of<physics::Spins>{5, "spins"};
template <>
inline constexpr Choice tag_of<physics::Rests>{6, "rests"};

template <>
struct Growth<physics::Segment> {
  static constexpr Choice tag{1, "spinning"};
  static bool needed(const physics::Segment& segment) {
    return !(segment.spin == physics::Vec3{} && segment.spin_change == physics::Vec3{});
  }
};

// ---- Balls before a shot

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Ball>& ball) {
  field(c, "id", ball.id);
  fixed(c, "kind", std::uint32_t{0});
  field(c, "position", ball.position);
  field(c, "velocity", ball.velocity);
  field(c, "spin", ball.spin);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::State>& state) {
  field(c, "balls", state.balls, max_balls);
  c.rule([&] { return shape_fault(state); });
}

// ---- Shots

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Struck>& event) {
  field(c, "time_s", event.time_s);
  field(c, "ball", event.ball);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::BallBall>& event) {
  field(c, "time_s", event.time_s);
  field(c, "pass", event.pass);
  field(c, "lower", event.lower);
  field(c, "higher", event.higher);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::BallCushion>& event) {
  field(c, "time_s", event.time_s);
  field(c, "pass", event.pass);
  field(c, "ball", event.ball);
  field(c, "cushion", event.cushion);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::BallPocket>& event) {
  field(c, "time_s", event.time_s);
  field(c, "pass", event.pass);
  field(c, "ball", event.ball);
  field(c, "pocket", event.pocket);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Rolls>& event) {
  field(c, "time_s", event.time_s);
  field(c, "ball", event.ball);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Spins>& event) {
  field(c, "time_s", event.time_s);
  field(c, "ball", event.ball);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Rests>& event) {
  field(c, "time_s", event.time_s);
  field(c, "ball", event.ball);
}

template <class Codec>
void describe_growth(Codec& c, Value<Codec, physics::Segment>& segment) {
  field(c, "spin", segment.spin);
  field(c, "spin_change", segment.spin_change);
}

// The form of a path is its tag: constant accelerations, without spin or with it.
template <class Codec>
void describe(Codec& c, Value<Codec, physics::Segment>& segment) {
  const bool spinning = form(c, "form", segment);
  field(c, "ball", segment.ball);
  field(c, "phase", segment.phase);
  field(c, "start_s", segment.start_s);
  field(c, "position", segment.position);
  field(c, "velocity", segment.velocity);
  field(c, "acceleration", segment.acceleration);
  if (spinning) growth(c, segment);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Shot>& shot) {
  field(c, "events", shot.events, max_events);
  field(c, "segments", shot.segments, max_segments);
  field(c, "end_s", shot.end_s);
  field(c, "stop", shot.stop);
  c.rule([&] { return shape_fault(shot); });
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::BallState>& ball) {
  field(c, "id", ball.id);
  field(c, "phase", ball.phase);
  field(c, "position", ball.position);
  field(c, "velocity", ball.velocity);
}

}  // namespace breakshot::record
