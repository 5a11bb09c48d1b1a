#include "common/wire/models.hpp"

#include <variant>

namespace breakshot::wire {
namespace {

// ---- Writing

struct MotionWriter {
  v1::Motion& message;

  void operator()(const physics::Frictionless&) const { message.mutable_frictionless(); }
  void operator()(const physics::Straight& motion) const {
    v1::Straight& said = *message.mutable_straight();
    said.set_sliding_friction(motion.sliding_friction);
    said.set_rolling_friction(motion.rolling_friction);
    said.set_rolling_below(motion.rolling_below_m_s);
  }
  void operator()(const physics::Spinning& motion) const {
    v1::Spinning& said = *message.mutable_spinning();
    said.set_sliding_friction(motion.sliding_friction);
    said.set_rolling_friction(motion.rolling_friction);
    said.set_spin_friction(motion.spin_friction);
  }
};

/// What all models of spinning balls at a nose have.
template <class Model, class Message>
void write_nose(const Model& model, Message& message) {
  message.set_restitution(model.restitution);
  message.set_friction(model.friction);
  message.set_height(model.height_m);
}

struct CushionWriter {
  v1::CushionModel& message;

  void operator()(const physics::Mirror&) const { message.mutable_mirror(); }
  void operator()(const physics::CushionRestitution& model) const {
    v1::CushionRestitution& said = *message.mutable_restitution();
    said.set_normal(model.normal);
    said.set_tangential(model.tangential);
    said.set_elastic_below(model.elastic_below_m_s);
  }
  void operator()(const physics::Han2005& model) const {
    write_nose(model, *message.mutable_han2005());
  }
  void operator()(const physics::Mathavan2010& model) const {
    write_nose(model, *message.mutable_mathavan2010());
  }
  void operator()(const physics::Stronge2000& model) const {
    write_nose(model, *message.mutable_stronge2000());
    message.mutable_stronge2000()->set_frequency_ratio(model.frequency_ratio);
  }
};

struct PocketsWriter {
  v1::Pockets& message;

  void operator()(const physics::StandardPockets& pockets) const {
    v1::StandardPockets& said = *message.mutable_standard();
    said.set_corner_mouth(pockets.corner_mouth_m);
    said.set_side_mouth(pockets.side_mouth_m);
  }
  void operator()(const physics::JawedPockets& pockets) const {
    v1::JawedPockets& said = *message.mutable_jawed();
    said.set_corner_mouth(pockets.corner_mouth_m);
    said.set_side_mouth(pockets.side_mouth_m);
    said.set_corner_cut(pockets.corner_cut_rad);
    said.set_side_cut(pockets.side_cut_rad);
    said.set_corner_shelf(pockets.corner_shelf_m);
    said.set_side_shelf(pockets.side_shelf_m);
    said.set_corner_nose(pockets.corner_nose_m);
    said.set_side_nose(pockets.side_nose_m);
    said.set_corner_hole(pockets.corner_hole_m);
    said.set_side_hole(pockets.side_hole_m);
  }
};

struct BallBallWriter {
  v1::BallBallModel& message;

  void operator()(const physics::Elastic&) const { message.mutable_elastic(); }
  void operator()(const physics::BallRestitution& model) const {
    v1::BallRestitution& said = *message.mutable_restitution();
    said.set_normal(model.normal);
    said.set_elastic_below(model.elastic_below_m_s);
  }
  void operator()(const physics::BallFriction& model) const {
    v1::BallFriction& said = *message.mutable_frictional();
    said.set_restitution(model.restitution);
    said.set_a(model.a);
    said.set_b(model.b);
    said.set_c(model.c_s_m);
    said.set_elastic_below(model.elastic_below_m_s);
  }
  void operator()(const physics::Mathavan2014& model) const {
    v1::Mathavan2014& said = *message.mutable_mathavan2014();
    said.set_restitution(model.restitution);
    said.set_friction(model.friction);
    said.set_elastic_below(model.elastic_below_m_s);
  }
};

// ---- Reading

/// A number that has a default.
void take(bool present, double value, double& into) {
  if (present) into = value;
}

physics::Straight read(const v1::Straight& said, const Where& at) {
  return {
      required(said.has_sliding_friction(), said.sliding_friction(), Where(at, "sliding_friction")),
      required(said.has_rolling_friction(), said.rolling_friction(), Where(at, "rolling_friction")),
      required(said.has_rolling_below(), said.rolling_below(), Where(at, "rolling_below"))};
}

physics::Spinning read(const v1::Spinning& said, const Where& at) {
  return {
      required(said.has_sliding_friction(), said.sliding_friction(), Where(at, "sliding_friction")),
      required(said.has_rolling_friction(), said.rolling_friction(), Where(at, "rolling_friction")),
      required(said.has_spin_friction(), said.spin_friction(), Where(at, "spin_friction"))};
}

physics::CushionRestitution read(const v1::CushionRestitution& said, const Where& at) {
  physics::CushionRestitution model;
  model.normal = required(said.has_normal(), said.normal(), Where(at, "normal"));
  model.tangential = required(said.has_tangential(), said.tangential(), Where(at, "tangential"));
  take(said.has_elastic_below(), said.elastic_below(), model.elastic_below_m_s);
  return model;
}

template <class Model, class Message>
Model read_nose(const Message& said, const Where& at) {
  Model model;
  model.restitution =
      required(said.has_restitution(), said.restitution(), Where(at, "restitution"));
  model.friction = required(said.has_friction(), said.friction(), Where(at, "friction"));
  model.height_m = required(said.has_height(), said.height(), Where(at, "height"));
  return model;
}

physics::StandardPockets read(const v1::StandardPockets& said) {
  physics::StandardPockets pockets;
  take(said.has_corner_mouth(), said.corner_mouth(), pockets.corner_mouth_m);
  take(said.has_side_mouth(), said.side_mouth(), pockets.side_mouth_m);
  return pockets;
}

physics::JawedPockets read(const v1::JawedPockets& said) {
  physics::JawedPockets pockets;
  take(said.has_corner_mouth(), said.corner_mouth(), pockets.corner_mouth_m);
  take(said.has_side_mouth(), said.side_mouth(), pockets.side_mouth_m);
  take(said.has_corner_cut(), said.corner_cut(), pockets.corner_cut_rad);
  take(said.has_side_cut(), said.side_cut(), pockets.side_cut_rad);
  take(said.has_corner_shelf(), said.corner_shelf(), pockets.corner_shelf_m);
  take(said.has_side_shelf(), said.side_shelf(), pockets.side_shelf_m);
  take(said.has_corner_nose(), said.corner_nose(), pockets.corner_nose_m);
  take(said.has_side_nose(), said.side_nose(), pockets.side_nose_m);
  take(said.has_corner_hole(), said.corner_hole(), pockets.corner_hole_m);
  take(said.has_side_hole(), said.side_hole(), pockets.side_hole_m);
  return pockets;
}

physics::BallRestitution read(const v1::BallRestitution& said, const Where& at) {
  physics::BallRestitution model;
  model.normal = required(said.has_normal(), said.normal(), Where(at, "normal"));
  take(said.has_elastic_below(), said.elastic_below(), model.elastic_below_m_s);
  return model;
}

physics::BallFriction read(const v1::BallFriction& said, const Where& at) {
  physics::BallFriction model;
  model.restitution =
      required(said.has_restitution(), said.restitution(), Where(at, "restitution"));
  take(said.has_a(), said.a(), model.a);
  take(said.has_b(), said.b(), model.b);
  take(said.has_c(), said.c(), model.c_s_m);
  take(said.has_elastic_below(), said.elastic_below(), model.elastic_below_m_s);
  return model;
}

physics::Mathavan2014 read(const v1::Mathavan2014& said, const Where& at) {
  physics::Mathavan2014 model;
  model.restitution =
      required(said.has_restitution(), said.restitution(), Where(at, "restitution"));
  model.friction = required(said.has_friction(), said.friction(), Where(at, "friction"));
  take(said.has_elastic_below(), said.elastic_below(), model.elastic_below_m_s);
  return model;
}

}  // namespace

void write(const physics::Motion& motion, v1::Motion& message) {
  std::visit(MotionWriter{message}, motion);
}

void write(const physics::CushionModel& model, v1::CushionModel& message) {
  std::visit(CushionWriter{message}, model);
}

void write(const physics::Pockets& pockets, v1::Pockets& message) {
  std::visit(PocketsWriter{message}, pockets);
}

void write(const physics::BallBallModel& model, v1::BallBallModel& message) {
  std::visit(BallBallWriter{message}, model);
}

physics::Motion read(const v1::Motion& message, const Where& at) {
  switch (message.kind_case()) {
    case v1::Motion::kFrictionless:
      return physics::Frictionless{};
    case v1::Motion::kStraight:
      return read(message.straight(), Where(at, "straight"));
    case v1::Motion::kSpinning:
      return read(message.spinning(), Where(at, "spinning"));
    case v1::Motion::KIND_NOT_SET:
      break;
  }
  at.refuse("must be frictionless, straight or spinning");
  return physics::Frictionless{};
}

physics::CushionModel read(const v1::CushionModel& message, const Where& at) {
  switch (message.kind_case()) {
    case v1::CushionModel::kMirror:
      return physics::Mirror{};
    case v1::CushionModel::kRestitution:
      return read(message.restitution(), Where(at, "restitution"));
    case v1::CushionModel::kHan2005:
      return read_nose<physics::Han2005>(message.han2005(), Where(at, "han2005"));
    case v1::CushionModel::kMathavan2010:
      return read_nose<physics::Mathavan2010>(message.mathavan2010(), Where(at, "mathavan2010"));
    case v1::CushionModel::kStronge2000: {
      const v1::Stronge2000& said = message.stronge2000();
      auto model = read_nose<physics::Stronge2000>(said, Where(at, "stronge2000"));
      take(said.has_frequency_ratio(), said.frequency_ratio(), model.frequency_ratio);
      return model;
    }
    case v1::CushionModel::KIND_NOT_SET:
      break;
  }
  at.refuse("must be mirror, restitution, han2005, mathavan2010 or stronge2000");
  return physics::Mirror{};
}

physics::Pockets read(const v1::Pockets& message, const Where& at) {
  switch (message.kind_case()) {
    case v1::Pockets::kStandard:
      return read(message.standard());
    case v1::Pockets::kJawed:
      return read(message.jawed());
    case v1::Pockets::KIND_NOT_SET:
      break;
  }
  at.refuse("must be standard or jawed");
  return physics::StandardPockets{};
}

physics::BallBallModel read(const v1::BallBallModel& message, const Where& at) {
  switch (message.kind_case()) {
    case v1::BallBallModel::kElastic:
      return physics::Elastic{};
    case v1::BallBallModel::kRestitution:
      return read(message.restitution(), Where(at, "restitution"));
    case v1::BallBallModel::kFrictional:
      return read(message.frictional(), Where(at, "frictional"));
    case v1::BallBallModel::kMathavan2014:
      return read(message.mathavan2014(), Where(at, "mathavan2014"));
    case v1::BallBallModel::KIND_NOT_SET:
      break;
  }
  at.refuse("must be elastic, restitution, frictional or mathavan2014");
  return physics::Elastic{};
}

}  // namespace breakshot::wire
