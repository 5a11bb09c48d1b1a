#include "common/wire/scene.hpp"

#include <variant>

#include "common/wire/models.hpp"

namespace breakshot::wire {
namespace {

// Those of this file hide the room's otherwise.
using wire::read;
using wire::write;

// ---- Writing

void write(physics::Vec2 v, v1::Vec2& message) {
  message.set_x(v.x);
  message.set_y(v.y);
}

void write(const physics::Bed& bed, v1::Bed& message) {
  write(bed.motion, *message.mutable_motion());
  if (bed.length_m) message.set_length(*bed.length_m);
  if (bed.width_m) message.set_width(*bed.width_m);
}

struct CushionsWriter {
  v1::Cushions& message;

  void operator()(const physics::RectangleCushions& rectangle) const {
    write(rectangle.model, *message.mutable_rectangle()->mutable_model());
  }
  void operator()(const physics::FreeCushions& free) const {
    for (const physics::CushionSegment& segment : free.segments) {
      v1::CushionSegment& said = *message.add_segments();
      write(segment.from, *said.mutable_from());
      write(segment.to, *said.mutable_to());
      write(segment.model, *said.mutable_model());
    }
    for (const physics::CushionArc& arc : free.arcs) {
      v1::CushionArc& said = *message.add_arcs();
      write(arc.centre, *said.mutable_centre());
      said.set_radius(arc.radius_m);
      write(arc.from, *said.mutable_from());
      write(arc.to, *said.mutable_to());
      write(arc.model, *said.mutable_model());
    }
  }
};

// ---- Reading

physics::CushionSegment read(const v1::CushionSegment& said, const Where& at) {
  return {read(said.from(), Where(at, "from")), read(said.to(), Where(at, "to")),
          read(said.model(), Where(at, "model"))};
}

physics::CushionArc read(const v1::CushionArc& said, const Where& at) {
  return {read(said.centre(), Where(at, "centre")),
          required(said.has_radius(), said.radius(), Where(at, "radius")),
          read(said.from(), Where(at, "from")), read(said.to(), Where(at, "to")),
          read(said.model(), Where(at, "model"))};
}

physics::Cushions read(const v1::Cushions& message, const Where& at) {
  if (message.has_rectangle()) {
    if (message.segments_size() > 0 || message.arcs_size() > 0) {
      at.refuse("must be a rectangle, or segments and arcs, not both");
    }
    const Where rectangle(at, "rectangle");
    return physics::RectangleCushions{read(message.rectangle().model(), Where(rectangle, "model"))};
  }
  physics::FreeCushions cushions;
  for (int i = 0; i < message.segments_size() && at.good(); ++i) {
    cushions.segments.push_back(read(message.segments(i), Where(at, "segments", i)));
  }
  for (int i = 0; i < message.arcs_size() && at.good(); ++i) {
    cushions.arcs.push_back(read(message.arcs(i), Where(at, "arcs", i)));
  }
  return cushions;
}

}  // namespace

void write(const physics::Scene& scene, v1::Scene& message) {
  if (scene.gravity_m_s2) message.set_gravity(*scene.gravity_m_s2);
  message.mutable_ball()->set_radius(scene.ball.radius_m);
  message.mutable_ball()->set_mass(scene.ball.mass_kg);
  write(scene.bed, *message.mutable_bed());
  if (scene.cushions) std::visit(CushionsWriter{*message.mutable_cushions()}, *scene.cushions);
  if (scene.pockets) write(*scene.pockets, *message.mutable_pockets());
  if (scene.ball_ball) write(*scene.ball_ball, *message.mutable_ball_ball());
  if (scene.perturbation) {
    message.mutable_perturbation()->set_ball(scene.perturbation->ball);
    message.mutable_perturbation()->set_cushion(scene.perturbation->cushion);
  }
}

physics::Vec2 read(const v1::Vec2& message, const Where& at) {
  return {required(message.has_x(), message.x(), Where(at, "x")),
          required(message.has_y(), message.y(), Where(at, "y"))};
}

physics::Scene read(const v1::Scene& message, const Where& at) {
  physics::Scene scene;
  if (message.has_gravity()) scene.gravity_m_s2 = message.gravity();
  if (message.ball().has_radius()) scene.ball.radius_m = message.ball().radius();
  if (message.ball().has_mass()) scene.ball.mass_kg = message.ball().mass();
  const Where bed(at, "bed");
  scene.bed.motion = read(message.bed().motion(), Where(bed, "motion"));
  if (message.bed().has_length()) scene.bed.length_m = message.bed().length();
  if (message.bed().has_width()) scene.bed.width_m = message.bed().width();
  if (message.has_cushions()) scene.cushions = read(message.cushions(), Where(at, "cushions"));
  if (message.has_pockets()) scene.pockets = read(message.pockets(), Where(at, "pockets"));
  if (message.has_ball_ball()) scene.ball_ball = read(message.ball_ball(), Where(at, "ball_ball"));
  if (message.has_perturbation()) {
    const v1::Perturbation& said = message.perturbation();
    scene.perturbation = physics::Perturbation{said.ball(), said.cushion()};
  }
  return scene;
}

}  // namespace breakshot::wire
