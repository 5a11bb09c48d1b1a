#include "common/rules/placement.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "common/physics/table.hpp"
#include "common/rules/groups.hpp"

namespace breakshot::rules {
namespace {

using physics::Ball;
using physics::BallId;
using physics::Bed;
using physics::Scene;
using physics::State;
using physics::Vec2;

/// "Small" in WPA 1.4: how far a spotted ball stays away from the cue ball, in radii.
constexpr double separation_radii = 0.01;

/// The shortest decimal that reads back to the same double, whatever the locale.
std::string shown(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string shown_mm(double value_m) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value_m * 1000,
                                 std::chars_format::fixed, 2)
                       .ptr;
  return std::string(text.data(), end) + " mm";
}

std::optional<std::string> range_fault(const char* field, double value, double greatest) {
  if (value >= -greatest && value <= greatest) return std::nullopt;
  return std::string(field) + ": is " + shown(value) + " m; on the bed a ball's centre is from " +
         shown(-greatest) + " to " + shown(greatest) + " m";
}

/// How far apart, between centres, a ball that the rules put back stays from another.
double clearance(const Scene& scene, BallId ball, BallId from) {
  const double touching = 2 * scene.ball.radius_m;
  const bool apart = ball == cue_ball || from == cue_ball;
  return apart ? touching + separation_radii * scene.ball.radius_m : touching;
}

/// The place on the long string for `ball` nearest to `start_x` in the direction `step` (+1 or -1),
/// or nothing if the balls in the way reach to the end of the bed.
std::optional<double> free_x(const Scene& scene, const State& others, BallId ball, double start_x,
                             double step) {
  const double end_x = scene.bed.length_m.value() / 2 - scene.ball.radius_m;
  const double ulp = end_x * std::numeric_limits<double>::epsilon();
  const auto blocks = [&](const Ball& other, double x) {
    return length(Vec2{x, 0} - other.position) < clearance(scene, ball, other.id);
  };
  double x = start_x;
  for (;;) {
    const auto in_the_way = std::find_if(others.balls.begin(), others.balls.end(),
                                         [&](const Ball& other) { return blocks(other, x); });
    if (in_the_way == others.balls.end()) break;
    const double distance = clearance(scene, ball, in_the_way->id);
    const double y = in_the_way->position.y;
    x = in_the_way->position.x + step * std::sqrt((distance - y) * (distance + y));
    while (blocks(*in_the_way, x)) x += step * ulp;
  }
  if (x < -end_x || x > end_x) return std::nullopt;
  return x;
}

/// `ball` on the long string, nearest to `spot` in the direction `step`, else in the other one.
State put_back(const Scene& scene, const State& table, BallId ball, Vec2 spot, double step) {
  State others = table;
  std::erase_if(others.balls, [&](const Ball& b) { return b.id == ball; });
  const auto behind = free_x(scene, others, ball, spot.x, step);
  const auto x = behind ? behind : free_x(scene, others, ball, spot.x, -step);
  return with_ball(others, ball, {x.value(), 0});
}

}  // namespace

bool may_play_from(const Bed& bed, BallInHand hand, Vec2 position) {
  if (hand != BallInHand::behind_head_string) return true;
  return position.x < head_string_x(bed) || position == head_spot(bed);
}

std::optional<std::string> placement_fault(const Scene& scene, const State& table, BallId ball,
                                           Vec2 position, BallInHand hand) {
  const double margin_m = scene.ball.radius_m;
  const double x_max = scene.bed.length_m.value() / 2 - margin_m;
  const double y_max = scene.bed.width_m.value() / 2 - margin_m;
  if (auto fault = range_fault("position.x", position.x, x_max)) return fault;
  if (auto fault = range_fault("position.y", position.y, y_max)) return fault;

  const double diameter_m = 2 * scene.ball.radius_m;
  for (const Ball& other : table.balls) {
    if (other.id == ball) continue;
    if (length(other.position - position) < diameter_m - physics::input_overlap_m) {
      return "position: overlaps ball " + std::to_string(number(other.id)) +
             "; place it at least " + shown_mm(diameter_m) + " from every ball's centre";
    }
  }
  if (!may_play_from(scene.bed, hand, position)) {
    return "position.x: is " + shown(position.x) + " m; behind the head string it is less than " +
           shown(head_string_x(scene.bed)) + " m, or exactly the head spot";
  }
  return std::nullopt;
}

State with_ball(const State& table, BallId ball, Vec2 position) {
  State result = table;
  const auto place = std::lower_bound(result.balls.begin(), result.balls.end(), ball,
                                      [](const Ball& b, BallId id) { return b.id < id; });
  const Ball put{ball, position, {}, {}};
  if (place != result.balls.end() && place->id == ball) {
    *place = put;
  } else {
    result.balls.insert(place, put);
  }
  return result;
}

State with_spotted(const Scene& scene, const State& table, BallId ball) {
  return put_back(scene, table, ball, foot_spot(scene.bed), 1);
}

State with_cue_ball_at_head_spot(const Scene& scene, const State& table) {
  return put_back(scene, table, cue_ball, head_spot(scene.bed), -1);
}

}  // namespace breakshot::rules
