// What the record says of scenes, balls and shots. This is the format (docs/record.md): whatever is
// changed here but added as a new tag is a new format version.
#pragma once

#include "common/physics/event.hpp"
#include "common/physics/scene.hpp"
#include "common/physics/timeline.hpp"
#include "common/record/codec.hpp"
#include "common/record/limits.hpp"
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

template <>
inline constexpr Choice tag_of<physics::Frictionless>{0, "frictionless"};
template <>
inline constexpr Choice tag_of<physics::Straight>{1, "straight"};
template <>
inline constexpr Choice tag_of<physics::Mirror>{0, "mirror"};
template <>
inline constexpr Choice tag_of<physics::CushionRestitution>{1, "restitution"};
template <>
inline constexpr Choice tag_of<physics::RectangleCushions>{0, "rectangle"};
template <>
inline constexpr Choice tag_of<physics::FreeCushions>{1, "segments"};
template <>
inline constexpr Choice tag_of<physics::Elastic>{0, "elastic"};
template <>
inline constexpr Choice tag_of<physics::BallRestitution>{1, "restitution"};

// The rank of an event's kind; 5 is that of the end of spinning.
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
inline constexpr Choice tag_of<physics::Rests>{6, "rests"};

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Vec2>& v) {
  field(c, "x", v.x);
  field(c, "y", v.y);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Vec3>& v) {
  field(c, "x", v.x);
  field(c, "y", v.y);
  field(c, "z", v.z);
}

// ---- Scenes

template <class Codec>
void describe(Codec& c, Value<Codec, physics::BallKind>& kind) {
  field(c, "radius_m", kind.radius_m);
  field(c, "mass_kg", kind.mass_kg);
}

template <class Codec>
void describe(Codec&, Value<Codec, physics::Frictionless>&) {}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Straight>& motion) {
  field(c, "sliding_friction", motion.sliding_friction);
  field(c, "rolling_friction", motion.rolling_friction);
  field(c, "rolling_below_m_s", motion.rolling_below_m_s);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Bed>& bed) {
  field(c, "motion", bed.motion);
  field(c, "length_m", bed.length_m);
  field(c, "width_m", bed.width_m);
}

template <class Codec>
void describe(Codec&, Value<Codec, physics::Mirror>&) {}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::CushionRestitution>& model) {
  field(c, "normal", model.normal);
  field(c, "tangential", model.tangential);
  field(c, "elastic_below_m_s", model.elastic_below_m_s);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::CushionSegment>& segment) {
  field(c, "from", segment.from);
  field(c, "to", segment.to);
  field(c, "model", segment.model);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::RectangleCushions>& cushions) {
  field(c, "model", cushions.model);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::FreeCushions>& cushions) {
  field(c, "segments", cushions.segments, max_cushions);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::StandardPockets>& pockets) {
  field(c, "corner_mouth_m", pockets.corner_mouth_m);
  field(c, "side_mouth_m", pockets.side_mouth_m);
}

template <class Codec>
void describe(Codec&, Value<Codec, physics::Elastic>&) {}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::BallRestitution>& model) {
  field(c, "normal", model.normal);
  field(c, "elastic_below_m_s", model.elastic_below_m_s);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Perturbation>& perturbation) {
  field(c, "ball", perturbation.ball);
  field(c, "cushion", perturbation.cushion);
}

// Every ball names its kind, so that scenes with several kinds need no other format. The byte
// before the pockets says absent or standard: other pockets are further tags of it.
template <class Codec>
void describe(Codec& c, Value<Codec, physics::Scene>& scene) {
  field(c, "gravity_m_s2", scene.gravity_m_s2);
  fixed(c, "ball_kinds", std::uint32_t{1});
  field(c, "ball", scene.ball);
  field(c, "bed", scene.bed);
  field(c, "cushions", scene.cushions);
  field(c, "pockets", scene.pockets);
  field(c, "ball_ball", scene.ball_ball);
  field(c, "perturbation", scene.perturbation);
}

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
void describe(Codec& c, Value<Codec, physics::Rests>& event) {
  field(c, "time_s", event.time_s);
  field(c, "ball", event.ball);
}

// The form of a path is its tag: 0 is a constant acceleration without spin.
template <class Codec>
void describe(Codec& c, Value<Codec, physics::Segment>& segment) {
  fixed(c, "form", std::uint8_t{0});
  field(c, "ball", segment.ball);
  field(c, "phase", segment.phase);
  field(c, "start_s", segment.start_s);
  field(c, "position", segment.position);
  field(c, "velocity", segment.velocity);
  field(c, "acceleration", segment.acceleration);
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
