// What the record says of scenes. This is the format (docs/record.md): whatever is changed here but
// added as a new tag is a new format version.
#pragma once

#include "common/physics/scene.hpp"
#include "common/record/codec.hpp"
#include "common/record/limits.hpp"

namespace breakshot::record {

template <>
inline constexpr Choice tag_of<physics::Frictionless>{0, "frictionless"};
template <>
inline constexpr Choice tag_of<physics::Straight>{1, "straight"};
template <>
inline constexpr Choice tag_of<physics::Spinning>{2, "spinning"};
template <>
inline constexpr Choice tag_of<physics::Mirror>{0, "mirror"};
template <>
inline constexpr Choice tag_of<physics::CushionRestitution>{1, "restitution"};
template <>
inline constexpr Choice tag_of<physics::Han2005>{2, "han2005"};
template <>
inline constexpr Choice tag_of<physics::Mathavan2010>{3, "mathavan2010"};
template <>
inline constexpr Choice tag_of<physics::Stronge2000>{4, "stronge2000"};
template <>
inline constexpr Choice tag_of<physics::RectangleCushions>{0, "rectangle"};
template <>
inline constexpr Choice tag_of<physics::FreeCushions>{1, "segments"};
template <>
struct Growth<physics::FreeCushions> {
  static constexpr Choice tag{2, "segments_and_arcs"};
  static bool needed(const physics::FreeCushions& cushions) { return !cushions.arcs.empty(); }
};

/// A scene without pockets: one byte says whether there are any and which.
struct NoPockets {};
template <>
inline constexpr Choice tag_of<NoPockets>{0, "absent"};
template <>
inline constexpr Choice tag_of<physics::StandardPockets>{1, "standard"};
template <>
inline constexpr Choice tag_of<physics::JawedPockets>{2, "jawed"};
template <>
inline constexpr Choice tag_of<physics::Elastic>{0, "elastic"};
template <>
inline constexpr Choice tag_of<physics::BallRestitution>{1, "restitution"};
template <>
inline constexpr Choice tag_of<physics::BallFriction>{2, "frictional"};
template <>
inline constexpr Choice tag_of<physics::Mathavan2014>{3, "mathavan2014"};

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
void describe(Codec& c, Value<Codec, physics::Spinning>& motion) {
  field(c, "sliding_friction", motion.sliding_friction);
  field(c, "rolling_friction", motion.rolling_friction);
  field(c, "spin_friction", motion.spin_friction);
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
void describe(Codec& c, Value<Codec, physics::Han2005>& model) {
  field(c, "restitution", model.restitution);
  field(c, "friction", model.friction);
  field(c, "height_m", model.height_m);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Mathavan2010>& model) {
  field(c, "restitution", model.restitution);
  field(c, "friction", model.friction);
  field(c, "height_m", model.height_m);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Stronge2000>& model) {
  field(c, "restitution", model.restitution);
  field(c, "friction", model.friction);
  field(c, "height_m", model.height_m);
  field(c, "frequency_ratio", model.frequency_ratio);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::CushionSegment>& segment) {
  field(c, "from", segment.from);
  field(c, "to", segment.to);
  field(c, "model", segment.model);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::CushionArc>& arc) {
  field(c, "centre", arc.centre);
  field(c, "radius_m", arc.radius_m);
  field(c, "from", arc.from);
  field(c, "to", arc.to);
  field(c, "model", arc.model);
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
void describe_growth(Codec& c, Value<Codec, physics::FreeCushions>& cushions) {
  field(c, "arcs", cushions.arcs, max_cushions);
}

template <class Codec>
void describe(Codec&, Value<Codec, NoPockets>&) {}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::StandardPockets>& pockets) {
  field(c, "corner_mouth_m", pockets.corner_mouth_m);
  field(c, "side_mouth_m", pockets.side_mouth_m);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::JawedPockets>& pockets) {
  field(c, "corner_mouth_m", pockets.corner_mouth_m);
  field(c, "side_mouth_m", pockets.side_mouth_m);
  field(c, "corner_cut_rad", pockets.corner_cut_rad);
  field(c, "side_cut_rad", pockets.side_cut_rad);
  field(c, "corner_shelf_m", pockets.corner_shelf_m);
  field(c, "side_shelf_m", pockets.side_shelf_m);
  field(c, "corner_nose_m", pockets.corner_nose_m);
  field(c, "side_nose_m", pockets.side_nose_m);
  field(c, "corner_hole_m", pockets.corner_hole_m);
  field(c, "side_hole_m", pockets.side_hole_m);
}

template <class Codec>
void pockets_field(Codec& c, Value<Codec, std::optional<physics::Pockets>>& pockets) {
  std::variant<NoPockets, physics::StandardPockets, physics::JawedPockets> kind;
  if (pockets) std::visit([&](const auto& known) { kind = known; }, *pockets);
  field(c, "pockets", kind);
  if constexpr (!Codec::writing) {
    pockets.reset();
    if (const auto* found = std::get_if<physics::StandardPockets>(&kind)) pockets = *found;
    if (const auto* found = std::get_if<physics::JawedPockets>(&kind)) pockets = *found;
  }
}

template <class Codec>
void describe(Codec&, Value<Codec, physics::Elastic>&) {}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::BallRestitution>& model) {
  field(c, "normal", model.normal);
  field(c, "elastic_below_m_s", model.elastic_below_m_s);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::BallFriction>& model) {
  field(c, "restitution", model.restitution);
  field(c, "a", model.a);
  field(c, "b", model.b);
  field(c, "c_s_m", model.c_s_m);
  field(c, "elastic_below_m_s", model.elastic_below_m_s);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Mathavan2014>& model) {
  field(c, "restitution", model.restitution);
  field(c, "friction", model.friction);
  field(c, "elastic_below_m_s", model.elastic_below_m_s);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Perturbation>& perturbation) {
  field(c, "ball", perturbation.ball);
  field(c, "cushion", perturbation.cushion);
}

// Every ball names its kind, so that scenes with several kinds need no other format.
template <class Codec>
void describe(Codec& c, Value<Codec, physics::Scene>& scene) {
  field(c, "gravity_m_s2", scene.gravity_m_s2);
  fixed(c, "ball_kinds", std::uint32_t{1});
  field(c, "ball", scene.ball);
  field(c, "bed", scene.bed);
  field(c, "cushions", scene.cushions);
  pockets_field(c, scene.pockets);
  field(c, "ball_ball", scene.ball_ball);
  field(c, "perturbation", scene.perturbation);
}

}  // namespace breakshot::record
