#include "common/physics/scene.hpp"

#include <algorithm>

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

void check(Faults& faults, const std::string& path, const Straight& straight) {
  for (const auto& [name, value] : {std::pair{".slidingFriction", straight.sliding_friction},
                                    std::pair{".rollingFriction", straight.rolling_friction}}) {
    if (value != 0) faults.range(path + name, value, min_friction, max_friction);
  }
  faults.range(path + ".rollingBelow", straight.rolling_below_m_s, 0, max_speed_m_s);
}

void check_motion(Faults& faults, const Scene& scene) {
  if (scene.gravity_m_s2) {
    faults.range("scene.gravity", *scene.gravity_m_s2, min_gravity_m_s2, max_gravity_m_s2);
  }
  if (const auto* straight = std::get_if<Straight>(&scene.bed.motion)) {
    if (!scene.gravity_m_s2) {
      faults.add("scene.gravity", "is missing; every motion but frictionless needs it");
    }
    check(faults, "scene.bed.motion.straight", *straight);
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

void check(Faults& faults, const std::string& path, const CushionModel& model) {
  const auto* restitution = std::get_if<CushionRestitution>(&model);
  if (restitution == nullptr) return;
  const std::string at = path + ".restitution";
  faults.range(at + ".normal", restitution->normal, 0, 1);
  faults.range(at + ".tangential", restitution->tangential, 0, 1);
  faults.range(at + ".elasticBelow", restitution->elastic_below_m_s, 0, 1);
}

void check(Faults& faults, const std::string& path, const CushionSegment& segment) {
  faults.coordinates(path + ".from", segment.from);
  faults.coordinates(path + ".to", segment.to);
  if (segment.from == segment.to) {
    faults.add(path + ".to", "equals from; a cushion needs a length");
  }
  check(faults, path + ".model", segment.model);
}

void check_cushions(Faults& faults, const Cushions& cushions) {
  if (const auto* rectangle = std::get_if<RectangleCushions>(&cushions)) {
    check(faults, "scene.cushions.rectangle.model", rectangle->model);
    return;
  }
  const auto& segments = std::get<FreeCushions>(cushions).segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    check(faults, "scene.cushions.segments[" + std::to_string(i) + "]", segments[i]);
  }
}

void check_pockets(Faults& faults, const Scene& scene) {
  if (!scene.pockets) return;
  const std::string path = "scene.pockets.standard";
  if (!scene.cushions || !std::holds_alternative<RectangleCushions>(*scene.cushions)) {
    faults.add(path, "needs rectangle cushions");
    return;
  }
  faults.range(path + ".cornerMouth", scene.pockets->corner_mouth_m, min_radius_m,
               scene.bed.width_m.value_or(max_bed_m));
  faults.range(path + ".sideMouth", scene.pockets->side_mouth_m, min_radius_m,
               scene.bed.length_m.value_or(max_bed_m));
}

void check_contacts(Faults& faults, const Scene& scene) {
  if (scene.ball_ball) {
    if (const auto* model = std::get_if<BallRestitution>(&*scene.ball_ball)) {
      faults.range("scene.ballBall.restitution.normal", model->normal, 0, 1);
      faults.range("scene.ballBall.restitution.elasticBelow", model->elastic_below_m_s, 0, 1);
    }
  }
  if (scene.perturbation) {
    faults.range("scene.perturbation.ball", scene.perturbation->ball, 0, 1);
    faults.range("scene.perturbation.cushion", scene.perturbation->cushion, 0, 1);
  }
}

std::string ball_path(std::size_t index) {
  return "balls[" + std::to_string(index) + "]";
}

void check_numbers(Faults& faults, const Ball& ball, std::size_t index) {
  const std::string path = ball_path(index);
  faults.coordinates(path + ".position", ball.position);
  faults.range(path + ".velocity.x", ball.velocity.x, -max_speed_m_s, max_speed_m_s);
  faults.range(path + ".velocity.y", ball.velocity.y, -max_speed_m_s, max_speed_m_s);
  if (!(ball.spin == Vec3{})) {
    faults.add(path + ".spin", "must be zero: the scene's motion has no spin");
  }
}

/// A ball may not stand in a cushion: in front of its nose line, within its extent, nearer than a
/// radius. Inside a rectangle it may not be beyond the line either.
void check_against(Faults& faults, const Scene& scene, const std::vector<CushionSegment>& cushions,
                   const Ball& ball, std::size_t index) {
  const bool enclosed =
      scene.cushions && std::holds_alternative<RectangleCushions>(*scene.cushions);
  for (std::size_t c = 0; c < cushions.size(); ++c) {
    const Vec2 along = cushions[c].to - cushions[c].from;
    const double extent = length(along);
    const Vec2 offset = ball.position - cushions[c].from;
    const double distance = cross(along, offset) / extent;
    const double foot = dot(along, offset) / extent;
    const bool in_front = foot >= 0 && foot <= extent && distance >= 0;
    if ((enclosed || in_front) && distance < scene.ball.radius_m - input_overlap_m) {
      faults.add(ball_path(index) + ".position",
                 "is " + shown(distance) + " m from cushion " + std::to_string(c) +
                     "; a ball's centre must be at least its radius " + shown(scene.ball.radius_m) +
                     " m away");
      return;
    }
  }
}

std::vector<std::size_t> order_by(const std::vector<Ball>& balls, auto key) {
  std::vector<std::size_t> order(balls.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return key(balls[a]) != key(balls[b]) ? key(balls[a]) < key(balls[b]) : a < b;
  });
  return order;
}

void check_identities(Faults& faults, const std::vector<Ball>& balls) {
  const auto order = order_by(balls, [](const Ball& b) { return number(b.id); });
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (balls[order[k]].id == balls[order[k - 1]].id) {
      faults.add(ball_path(order[k]) + ".id", std::to_string(number(balls[order[k]].id)) +
                                                  " is also the id of " + ball_path(order[k - 1]) +
                                                  "; ids are unique");
    }
  }
}

void check_overlaps(Faults& faults, const std::vector<Ball>& balls, double radius_m) {
  const double diameter = 2 * radius_m;
  const auto order = order_by(balls, [](const Ball& b) { return b.position.x; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Ball& a = balls[order[k]];
    for (std::size_t l = k + 1; l < order.size(); ++l) {
      const Ball& b = balls[order[l]];
      if (b.position.x - a.position.x >= diameter) break;
      const double distance = length(b.position - a.position);
      if (distance < diameter - input_overlap_m) {
        const auto [first, second] = std::minmax(order[k], order[l]);
        faults.add(ball_path(second) + ".position",
                   "overlaps " + ball_path(first) + ": their centres are " + shown(distance) +
                       " m apart and must be at least " + shown(diameter) + " m");
      }
    }
  }
}

}  // namespace

std::vector<Fault> faults_of(const Scene& scene) {
  Faults faults;
  check_motion(faults, scene);
  faults.range("scene.ball.radius", scene.ball.radius_m, min_radius_m, max_radius_m);
  faults.range("scene.ball.mass", scene.ball.mass_kg, min_mass_kg, max_mass_kg);
  check_bed(faults, scene);
  if (scene.cushions) check_cushions(faults, *scene.cushions);
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

std::vector<Fault> faults_of(const Scene& scene, const State& state) {
  Faults faults;
  const std::vector<Ball>& balls = state.balls;
  if (balls.empty()) faults.add("balls", "is empty; a scene needs at least one ball");
  if (balls.size() > max_balls) {
    faults.add("balls", "has " + std::to_string(balls.size()) + " balls; at most " +
                            std::to_string(max_balls) + " are possible");
    return faults.take();
  }
  const auto cushions = segments_of(scene);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    check_numbers(faults, balls[i], i);
    check_against(faults, scene, cushions, balls[i], i);
  }
  check_identities(faults, balls);
  if (scene.ball_ball) check_overlaps(faults, balls, scene.ball.radius_m);
  return faults.take();
}

std::vector<Fault> faults_of(const Scene&, const State& state, const Strike& strike) {
  Faults faults;
  const auto ball = std::find_if(state.balls.begin(), state.balls.end(),
                                 [&](const Ball& b) { return b.id == strike.ball; });
  if (ball == state.balls.end()) {
    faults.add("strike.ball", std::to_string(number(strike.ball)) + " is not the id of a ball");
  } else if (!(ball->velocity == Vec2{})) {
    faults.add("strike.ball",
               std::to_string(number(strike.ball)) + " moves; a strike needs a ball at rest");
  }
  const double size = length(strike.direction);
  if (!(size >= 1 - 1e-9 && size <= 1 + 1e-9)) {
    faults.add("strike.direction", "has length " + shown(size) + "; it must be a unit vector");
  }
  faults.range("strike.speed", strike.speed_m_s, 0, max_speed_m_s);
  return faults.take();
}

}  // namespace breakshot::physics
