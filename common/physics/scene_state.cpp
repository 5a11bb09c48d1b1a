// Whether balls and a strike fit a scene: the part of scene.hpp's validation that needs a faultless
// scene.
#include <algorithm>
#include <cmath>

#include "common/physics/rails.hpp"
#include "common/physics/scene.hpp"
#include "common/physics/validation.hpp"

namespace breakshot::physics {
namespace {

std::string ball_path(std::size_t index) {
  return "balls[" + std::to_string(index) + "]";
}

void check_numbers(Faults& faults, const Scene& scene, const Ball& ball, std::size_t index) {
  const std::string path = ball_path(index);
  faults.coordinates(path + ".position", ball.position);
  faults.range(path + ".velocity.x", ball.velocity.x, -max_speed_m_s, max_speed_m_s);
  faults.range(path + ".velocity.y", ball.velocity.y, -max_speed_m_s, max_speed_m_s);
  if (std::holds_alternative<Spinning>(scene.bed.motion)) {
    faults.range(path + ".spin.x", ball.spin.x, -max_spin_rad_s, max_spin_rad_s);
    faults.range(path + ".spin.y", ball.spin.y, -max_spin_rad_s, max_spin_rad_s);
    faults.range(path + ".spin.z", ball.spin.z, -max_spin_rad_s, max_spin_rad_s);
  } else if (!(ball.spin == Vec3{})) {
    faults.add(path + ".spin", "must be zero: the scene's motion has no spin");
  }
}

std::string too_near(double distance_m, const std::string& what, double radius_m) {
  return "is " + shown(distance_m) + " m from " + what +
         "; a ball's centre must be at least its radius " + shown(radius_m) + " m away";
}

bool beyond_noses(Vec2 inside, Vec2 place) {
  return std::abs(place.x) > inside.x || std::abs(place.y) > inside.y;
}

/// Whether a place is in the sector of a rounded nose.
bool in_front(const CushionArc& nose, Vec2 place) {
  const Vec2 offset = place - nose.centre;
  return cross(nose.from, offset) >= 0 && cross(offset, nose.to) >= 0;
}

/// Whether a place is on the open side of a jaw: of its facing's line, or before its rounded nose,
/// which may be larger than a ball.
bool clears(const Rails& rails, CushionId jaw, Vec2 place) {
  const bool beside_facing =
      std::any_of(rails.segments.begin(), rails.segments.end(), [&](const RailSegment& rail) {
        return rail.id == jaw && cross(rail.nose.to - rail.nose.from, place - rail.nose.from) > 0;
      });
  return beside_facing ||
         std::any_of(rails.arcs.begin(), rails.arcs.end(), [&](const RailArc& rail) {
           return rail.id == jaw && in_front(rail.nose, place);
         });
}

/// How far from the middle of its hole a pocket's mouth reaches: to where the noses begin to round.
double reach_of(const Rails& rails, const Hole& hole, CushionId first, CushionId second) {
  double reach = hole.radius_m;
  for (const RailArc& rail : rails.arcs) {
    if (rail.id != first && rail.id != second) continue;
    for (const Vec2 end : {rail.nose.from, rail.nose.to}) {
      reach = std::max(reach, length(rail.nose.centre + end * rail.nose.radius_m - hole.centre));
    }
  }
  return reach;
}

/// Whether a place is between the two jaws of a pocket, no further from the hole than its mouth.
bool in_a_mouth(const Rails& rails, Vec2 place) {
  return std::any_of(rails.holes.begin(), rails.holes.end(), [&](const Hole& hole) {
    const CushionId first{4 + 2 * std::uint32_t{number(hole.pocket)}};
    const CushionId second{number(first) + 1};
    return length(place - hole.centre) <= reach_of(rails, hole, first, second) &&
           clears(rails, first, place) && clears(rails, second, place);
  });
}

/// A ball may not stand in a cushion: in front of its nose, within its extent, nearer than a
/// radius. Inside a rectangle it may not be beyond the line of the noses either, and over a hole it
/// would fall.
std::optional<std::string> place_fault(const Scene& scene, const Rails& rails, Vec2 place) {
  const double radius = scene.ball.radius_m;
  const double nearest = radius - input_overlap_m;
  if (rails.inside && beyond_noses(*rails.inside, place) && !in_a_mouth(rails, place)) {
    return "is beyond the line of the cushions; |x| must be at most " + shown(rails.inside->x) +
           ", |y| at most " + shown(rails.inside->y);
  }
  for (const RailSegment& rail : rails.segments) {
    const Vec2 along = rail.nose.to - rail.nose.from;
    const double extent = length(along);
    const Vec2 offset = place - rail.nose.from;
    const double distance = cross(along, offset) / extent;
    const double foot = dot(along, offset) / extent;
    if (foot >= 0 && foot <= extent && distance >= 0 && distance < nearest) {
      return too_near(distance, "cushion " + std::to_string(number(rail.id)), radius);
    }
  }
  for (const RailArc& rail : rails.arcs) {
    const double distance = length(place - rail.nose.centre) - rail.nose.radius_m;
    if (in_front(rail.nose, place) && distance < nearest) {
      return too_near(distance, "cushion " + std::to_string(number(rail.id)), radius);
    }
  }
  for (const Hole& hole : rails.holes) {
    if (length(place - hole.centre) < hole.radius_m) {
      return "is over pocket " + std::to_string(number(hole.pocket)) + "; a ball there would fall";
    }
  }
  return std::nullopt;
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

std::vector<Fault> faults_of(const Scene& scene, const State& state) {
  Faults faults;
  const std::vector<Ball>& balls = state.balls;
  if (balls.empty()) faults.add("balls", "is empty; a scene needs at least one ball");
  if (balls.size() > max_balls) {
    faults.add("balls", "has " + std::to_string(balls.size()) + " balls; at most " +
                            std::to_string(max_balls) + " are possible");
    return faults.take();
  }
  const Rails rails = rails_of(scene);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    check_numbers(faults, scene, balls[i], i);
    if (const auto fault = place_fault(scene, rails, balls[i].position)) {
      faults.add(ball_path(i) + ".position", *fault);
    }
  }
  check_identities(faults, balls);
  if (scene.ball_ball) check_overlaps(faults, balls, scene.ball.radius_m);
  return faults.take();
}

std::vector<Fault> faults_of(const Scene& scene, const State& state, const Strike& strike) {
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
  const double offset = length(Vec2{strike.tip.side, strike.tip.height});
  if (!(offset <= miscue_offset)) {
    faults.add("strike.tip", "is " + shown(offset) + " radii from the centre; beyond " +
                                 shown(miscue_offset) + " the cue slips off the ball");
  } else if (offset > 0 && !std::holds_alternative<Spinning>(scene.bed.motion)) {
    faults.add("strike.tip", "must be the centre of the ball: the scene's motion has no spin");
  }
  return faults.take();
}

}  // namespace breakshot::physics
