#include "common/physics/scene.hpp"

#include "common/physics/angle.hpp"
#include "common/physics/validation.hpp"

namespace breakshot::physics {
namespace {

constexpr double min_radius_m = 1e-4;
constexpr double max_radius_m = 10;
constexpr double min_mass_kg = 1e-6;
constexpr double max_mass_kg = 1e6;
constexpr double min_gravity_m_s2 = 1e-3;
constexpr double max_gravity_m_s2 = 1000;
constexpr double min_friction = 1e-300;
constexpr double max_friction = 10;
constexpr double max_bed_m = 1e4;
/// Of a nose above the bed, in radii: at two it would miss the ball.
constexpr double max_nose_height = 1.99;

void check_friction(Faults& faults, const std::string& field, double value) {
  // Not a number is in no range.
  if (value == 0 || (value >= min_friction && value <= max_friction)) return;
  faults.add(field, "is " + shown(value) + "; it must be 0 or from " + shown(min_friction) +
                        " to " + shown(max_friction));
}

void check(Faults& faults, const std::string& path, const Straight& straight) {
  check_friction(faults, path + ".slidingFriction", straight.sliding_friction);
  check_friction(faults, path + ".rollingFriction", straight.rolling_friction);
  faults.range(path + ".rollingBelow", straight.rolling_below_m_s, 0, max_speed_m_s);
}

void check(Faults& faults, const std::string& path, const Spinning& spinning) {
  check_friction(faults, path + ".slidingFriction", spinning.sliding_friction);
  check_friction(faults, path + ".rollingFriction", spinning.rolling_friction);
  check_friction(faults, path + ".spinFriction", spinning.spin_friction);
}

void check_motion(Faults& faults, const Scene& scene) {
  if (scene.gravity_m_s2) {
    faults.range("scene.gravity", *scene.gravity_m_s2, min_gravity_m_s2, max_gravity_m_s2);
  }
  if (!scene.gravity_m_s2 && !std::holds_alternative<Frictionless>(scene.bed.motion)) {
    faults.add("scene.gravity", "is missing; every motion but frictionless needs it");
  }
  if (const auto* straight = std::get_if<Straight>(&scene.bed.motion)) {
    check(faults, "scene.bed.motion.straight", *straight);
  } else if (const auto* spinning = std::get_if<Spinning>(&scene.bed.motion)) {
    check(faults, "scene.bed.motion.spinning", *spinning);
  }
}

void check_bed(Faults& faults, const Scene& scene) {
  const bool needed = scene.cushions && std::holds_alternative<RectangleCushions>(*scene.cushions);
  for (const auto& [name, value] : {std::pair{"scene.bed.length", scene.bed.length_m},
                                    std::pair{"scene.bed.width", scene.bed.width_m}}) {
    if (value) {
      faults.range(name, *value, 2 * scene.ball.radius_m, max_bed_m);
    } else if (needed) {
      faults.add(name, "is missing; rectangle cushions need it");
    }
  }
}

/// Names the bad fields of a cushion's model below `path`.
struct CushionChecker {
  Faults& faults;
  const std::string& path;
  double radius_m;

  void operator()(const Mirror&) const {}
  void operator()(const CushionRestitution& m) const {
    const std::string at = path + ".restitution";
    faults.range(at + ".normal", m.normal, 0, 1);
    faults.range(at + ".tangential", m.tangential, 0, 1);
    faults.range(at + ".elasticBelow", m.elastic_below_m_s, 0, 1);
  }
  void operator()(const Han2005& m) const { check_nose(path + ".han2005", m); }
  void operator()(const Mathavan2010& m) const { check_nose(path + ".mathavan2010", m); }
  void operator()(const Stronge2000& m) const {
    check_nose(path + ".stronge2000", m);
    faults.range(path + ".stronge2000.frequencyRatio", m.frequency_ratio, 1, 10);
  }

  void check_nose(const std::string& at, const auto& m) const {
    faults.range(at + ".restitution", m.restitution, 0, 1);
    faults.range(at + ".friction", m.friction, 0, max_friction);
    faults.range(at + ".height", m.height_m, radius_m, max_nose_height * radius_m);
  }
};

void check_model(Faults& faults, const std::string& path, const CushionModel& model,
                 const Scene& scene) {
  std::visit(CushionChecker{faults, path, scene.ball.radius_m}, model);
}

void check(Faults& faults, const std::string& path, const CushionArc& arc) {
  faults.coordinates(path + ".centre", arc.centre);
  faults.range(path + ".radius", arc.radius_m, min_radius_m, max_radius_m);
  for (const auto& [name, direction] : {std::pair{".from", arc.from}, std::pair{".to", arc.to}}) {
    const double size = length(direction);
    if (!(size >= 1 - 1e-9 && size <= 1 + 1e-9)) {
      faults.add(path + name, "has length " + shown(size) + "; it must be a unit vector");
    }
  }
  if (!(cross(arc.from, arc.to) > 0)) {
    faults.add(path + ".to", "must be less than half a turn, counter-clockwise, after from");
  }
}

void check(Faults& faults, const std::string& path, const CushionSegment& segment) {
  faults.coordinates(path + ".from", segment.from);
  faults.coordinates(path + ".to", segment.to);
  if (segment.from == segment.to) {
    faults.add(path + ".to", "equals from; a cushion needs a length");
  }
}

void check_noses(Faults& faults, const std::string& list, const auto& noses, const Scene& scene) {
  for (std::size_t i = 0; i < noses.size(); ++i) {
    const std::string path = list + "[" + std::to_string(i) + "]";
    check(faults, path, noses[i]);
    check_model(faults, path + ".model", noses[i].model, scene);
  }
}

void check_cushions(Faults& faults, const Scene& scene) {
  if (const auto* rectangle = std::get_if<RectangleCushions>(&*scene.cushions)) {
    check_model(faults, "scene.cushions.rectangle.model", rectangle->model, scene);
    return;
  }
  const auto& free = std::get<FreeCushions>(*scene.cushions);
  check_noses(faults, "scene.cushions.segments", free.segments, scene);
  check_noses(faults, "scene.cushions.arcs", free.arcs, scene);
}

void check(Faults& faults, const StandardPockets& pockets, const Bed& bed) {
  const std::string path = "scene.pockets.standard";
  faults.range(path + ".cornerMouth", pockets.corner_mouth_m, min_radius_m,
               bed.width_m.value_or(max_bed_m));
  faults.range(path + ".sideMouth", pockets.side_mouth_m, min_radius_m,
               bed.length_m.value_or(max_bed_m));
}

/// One kind of pocket of a table with jaws; `axis_rad` is the angle between the line of the noses
/// and the way into the pocket.
struct JawFields {
  std::string name;
  double mouth_m, greatest_mouth_m, cut_rad, shelf_m, nose_m, hole_m, axis_rad;
};

void check_jaws(Faults& faults, const JawFields& jaws, double radius_m) {
  const std::string path = "scene.pockets.jawed." + jaws.name;
  faults.range(path + "Mouth", jaws.mouth_m, 2 * radius_m, jaws.greatest_mouth_m);
  // The facing leads into the pocket and towards the other one, or straight in.
  faults.range(path + "Cut", jaws.cut_rad, pi - jaws.axis_rad, pi - 0.01);
  faults.range(path + "Shelf", jaws.shelf_m, 0, jaws.mouth_m);
  faults.range(path + "Nose", jaws.nose_m, min_radius_m, jaws.mouth_m);
  faults.range(path + "Hole", jaws.hole_m, radius_m, jaws.mouth_m);
  const double turn = jaws.axis_rad - (pi - jaws.cut_rad);
  const Vec2 inwards = direction_of(turn);
  const double depth = jaws.shelf_m + jaws.hole_m;
  if (!(jaws.mouth_m - 2 * depth * inwards.y / inwards.x > 2 * radius_m)) {
    faults.add(path + "Cut",
               "lets the facings close in on less than a ball before the middle of "
               "the hole; it must be smaller, or the mouth wider");
  }
}

void check_jawed(Faults& faults, const JawedPockets& p, const Scene& scene) {
  const double length_m = scene.bed.length_m.value_or(max_bed_m);
  const double width_m = scene.bed.width_m.value_or(max_bed_m);
  check_jaws(faults,
             {"corner", p.corner_mouth_m, width_m / 2, p.corner_cut_rad, p.corner_shelf_m,
              p.corner_nose_m, p.corner_hole_m, pi / 4},
             scene.ball.radius_m);
  check_jaws(faults,
             {"side", p.side_mouth_m, length_m / 4, p.side_cut_rad, p.side_shelf_m, p.side_nose_m,
              p.side_hole_m, pi / 2},
             scene.ball.radius_m);
}

void check_pockets(Faults& faults, const Scene& scene) {
  if (!scene.pockets) return;
  const auto* jawed = std::get_if<JawedPockets>(&*scene.pockets);
  if (!scene.cushions || !std::holds_alternative<RectangleCushions>(*scene.cushions)) {
    faults.add(jawed != nullptr ? "scene.pockets.jawed" : "scene.pockets.standard",
               "needs rectangle cushions");
  } else if (jawed != nullptr) {
    check_jawed(faults, *jawed, scene);
  } else {
    check(faults, std::get<StandardPockets>(*scene.pockets), scene.bed);
  }
}

/// Names the bad fields of what balls do to one another.
struct PairChecker {
  Faults& faults;

  void operator()(const Elastic&) const {}
  void operator()(const BallRestitution& m) const {
    faults.range("scene.ballBall.restitution.normal", m.normal, 0, 1);
    faults.range("scene.ballBall.restitution.elasticBelow", m.elastic_below_m_s, 0, 1);
  }
  void operator()(const BallFriction& m) const {
    const std::string at = "scene.ballBall.frictional";
    faults.range(at + ".restitution", m.restitution, 0, 1);
    faults.range(at + ".a", m.a, 0, 1);
    faults.range(at + ".b", m.b, 0, 1);
    faults.range(at + ".c", m.c_s_m, 0, 1000);
    faults.range(at + ".elasticBelow", m.elastic_below_m_s, 0, 1);
  }
  void operator()(const Mathavan2014& m) const {
    const std::string at = "scene.ballBall.mathavan2014";
    faults.range(at + ".restitution", m.restitution, 0, 1);
    faults.range(at + ".friction", m.friction, 0, 1);
    faults.range(at + ".elasticBelow", m.elastic_below_m_s, 0, 1);
  }
};

void check_contacts(Faults& faults, const Scene& scene) {
  if (scene.ball_ball) std::visit(PairChecker{faults}, *scene.ball_ball);
  if (scene.perturbation) {
    faults.range("scene.perturbation.ball", scene.perturbation->ball, 0, 1);
    faults.range("scene.perturbation.cushion", scene.perturbation->cushion, 0, 1);
  }
}

}  // namespace

std::vector<Fault> faults_of(const Scene& scene) {
  Faults faults;
  check_motion(faults, scene);
  faults.range("scene.ball.radius", scene.ball.radius_m, min_radius_m, max_radius_m);
  faults.range("scene.ball.mass", scene.ball.mass_kg, min_mass_kg, max_mass_kg);
  check_bed(faults, scene);
  if (scene.cushions) check_cushions(faults, scene);
  check_pockets(faults, scene);
  check_contacts(faults, scene);
  return faults.take();
}

std::vector<CushionSegment> segments_of(const Scene& scene) {
  if (!scene.cushions) return {};
  if (const auto* free = std::get_if<FreeCushions>(&*scene.cushions)) return free->segments;
  const CushionModel& model = std::get<RectangleCushions>(*scene.cushions).model;
  const double x = scene.bed.length_m.value() / 2;
  const double y = scene.bed.width_m.value() / 2;
  return {{{x, -y}, {x, y}, model},
          {{x, y}, {-x, y}, model},
          {{-x, y}, {-x, -y}, model},
          {{-x, -y}, {x, -y}, model}};
}

}  // namespace breakshot::physics
