#include "common/wire/scene.hpp"

#include <type_traits>
#include <variant>

namespace breakshot::wire {
namespace {

// ---- Writing

void write(physics::Vec2 v, v1::Vec2& message) {
  message.set_x(v.x);
  message.set_y(v.y);
}

void write(const physics::Bed& bed, v1::Bed& message) {
  if (const auto* straight = std::get_if<physics::Straight>(&bed.motion)) {
    v1::Straight& said = *message.mutable_motion()->mutable_straight();
    said.set_sliding_friction(straight->sliding_friction);
    said.set_rolling_friction(straight->rolling_friction);
    said.set_rolling_below(straight->rolling_below_m_s);
  } else {
    message.mutable_motion()->mutable_frictionless();
  }
  if (bed.length_m) message.set_length(*bed.length_m);
  if (bed.width_m) message.set_width(*bed.width_m);
}

void write(const physics::CushionModel& model, v1::CushionModel& message) {
  if (const auto* restitution = std::get_if<physics::CushionRestitution>(&model)) {
    v1::CushionRestitution& said = *message.mutable_restitution();
    said.set_normal(restitution->normal);
    said.set_tangential(restitution->tangential);
    said.set_elastic_below(restitution->elastic_below_m_s);
  } else {
    message.mutable_mirror();
  }
}

void write(const physics::Cushions& cushions, v1::Cushions& message) {
  if (const auto* rectangle = std::get_if<physics::RectangleCushions>(&cushions)) {
    write(rectangle->model, *message.mutable_rectangle()->mutable_model());
    return;
  }
  for (const auto& segment : std::get<physics::FreeCushions>(cushions).segments) {
    v1::CushionSegment& said = *message.add_segments();
    write(segment.from, *said.mutable_from());
    write(segment.to, *said.mutable_to());
    write(segment.model, *said.mutable_model());
  }
}

void write(const physics::BallBallModel& model, v1::BallBallModel& message) {
  if (const auto* restitution = std::get_if<physics::BallRestitution>(&model)) {
    message.mutable_restitution()->set_normal(restitution->normal);
    message.mutable_restitution()->set_elastic_below(restitution->elastic_below_m_s);
  } else {
    message.mutable_elastic();
  }
}

// ---- Reading

physics::Motion read(const v1::Motion& message, const Where& at) {
  switch (message.kind_case()) {
    case v1::Motion::kFrictionless:
      return physics::Frictionless{};
    case v1::Motion::kStraight: {
      const v1::Straight& said = message.straight();
      const Where here(at, "straight");
      return physics::Straight{
          required(said.has_sliding_friction(), said.sliding_friction(),
                   Where(here, "sliding_friction")),
          required(said.has_rolling_friction(), said.rolling_friction(),
                   Where(here, "rolling_friction")),
          required(said.has_rolling_below(), said.rolling_below(), Where(here, "rolling_below"))};
    }
    case v1::Motion::KIND_NOT_SET:
      break;
  }
  at.refuse("must be frictionless or straight");
  return physics::Frictionless{};
}

physics::CushionModel read(const v1::CushionModel& message, const Where& at) {
  switch (message.kind_case()) {
    case v1::CushionModel::kMirror:
      return physics::Mirror{};
    case v1::CushionModel::kRestitution: {
      physics::CushionRestitution model;
      const v1::CushionRestitution& said = message.restitution();
      const Where here(at, "restitution");
      model.normal = required(said.has_normal(), said.normal(), Where(here, "normal"));
      model.tangential =
          required(said.has_tangential(), said.tangential(), Where(here, "tangential"));
      if (said.has_elastic_below()) model.elastic_below_m_s = said.elastic_below();
      return model;
    }
    case v1::CushionModel::KIND_NOT_SET:
      break;
  }
  at.refuse("must be mirror or restitution");
  return physics::Mirror{};
}

physics::Cushions read(const v1::Cushions& message, const Where& at) {
  if (message.has_rectangle() && message.segments_size() > 0) {
    at.refuse("must be a rectangle or segments, not both");
  }
  if (message.has_rectangle()) {
    const Where rectangle(at, "rectangle");
    return physics::RectangleCushions{read(message.rectangle().model(), Where(rectangle, "model"))};
  }
  physics::FreeCushions cushions;
  for (int i = 0; i < message.segments_size() && at.good(); ++i) {
    const v1::CushionSegment& said = message.segments(i);
    const Where here(at, "segments", i);
    cushions.segments.push_back({read(said.from(), Where(here, "from")),
                                 read(said.to(), Where(here, "to")),
                                 read(said.model(), Where(here, "model"))});
  }
  return cushions;
}

physics::BallBallModel read(const v1::BallBallModel& message, const Where& at) {
  switch (message.kind_case()) {
    case v1::BallBallModel::kElastic:
      return physics::Elastic{};
    case v1::BallBallModel::kRestitution: {
      physics::BallRestitution model;
      const v1::BallRestitution& said = message.restitution();
      model.normal =
          required(said.has_normal(), said.normal(), Where(Where(at, "restitution"), "normal"));
      if (said.has_elastic_below()) model.elastic_below_m_s = said.elastic_below();
      return model;
    }
    case v1::BallBallModel::KIND_NOT_SET:
      break;
  }
  at.refuse("must be elastic or restitution");
  return physics::Elastic{};
}

physics::StandardPockets read(const v1::Pockets& message, const Where& at) {
  physics::StandardPockets pockets;
  if (!message.has_standard()) at.refuse("must be standard");
  const v1::StandardPockets& said = message.standard();
  if (said.has_corner_mouth()) pockets.corner_mouth_m = said.corner_mouth();
  if (said.has_side_mouth()) pockets.side_mouth_m = said.side_mouth();
  return pockets;
}

}  // namespace

void write(const physics::Scene& scene, v1::Scene& message) {
  if (scene.gravity_m_s2) message.set_gravity(*scene.gravity_m_s2);
  message.mutable_ball()->set_radius(scene.ball.radius_m);
  message.mutable_ball()->set_mass(scene.ball.mass_kg);
  write(scene.bed, *message.mutable_bed());
  if (scene.cushions) write(*scene.cushions, *message.mutable_cushions());
  if (scene.pockets) {
    v1::StandardPockets& said = *message.mutable_pockets()->mutable_standard();
    said.set_corner_mouth(scene.pockets->corner_mouth_m);
    said.set_side_mouth(scene.pockets->side_mouth_m);
  }
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
