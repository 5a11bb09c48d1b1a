#include "common/physics/table.hpp"

namespace breakshot::physics {
namespace {

/// The paper's bed with the friction that its section 3.4 asks for; the coefficients are usual ones
/// for a clean cloth (Alciatore, "Pool and billiards physics principles", table 1).
Bed eight_foot_bed() {
  return {Straight{0.2, 0.01, 1.0}, eight_foot_length_m, eight_foot_width_m};
}

Scene plain_table() {
  Scene scene;
  scene.gravity_m_s2 = 9.81;
  scene.bed = eight_foot_bed();
  scene.cushions = RectangleCushions{CushionRestitution{0.85, 1.0, default_elastic_below_m_s}};
  scene.pockets = StandardPockets{};
  scene.ball_ball = BallRestitution{0.95, default_elastic_below_m_s};
  scene.perturbation = Perturbation{0.0005, 0.0005};
  return scene;
}

Scene paper_table() {
  Scene scene = plain_table();
  scene.cushions = RectangleCushions{Mirror{}};
  scene.ball_ball = Elastic{};
  scene.perturbation = Perturbation{0.001, 0.001};
  return scene;
}

/// A nose at 63.5 % of the diameter: the WPA's equipment specifications, section 9.
double nose_height_m(const BallKind& ball) {
  return 0.635 * 2 * ball.radius_m;
}

/// A table on which everything that is modelled happens.
Scene full_table(double length_m, double width_m, const BallKind& ball, const Spinning& cloth) {
  Scene scene;
  scene.gravity_m_s2 = 9.81;
  scene.ball = ball;
  scene.bed = {cloth, length_m, width_m};
  scene.cushions = RectangleCushions{Han2005{0.85, 0.2, nose_height_m(ball)}};
  scene.ball_ball = BallFriction{};
  scene.perturbation = Perturbation{0.0005, 0.0005};
  return scene;
}

Scene pool_table(double length_m, double width_m) {
  Scene scene = full_table(length_m, width_m, pool_ball, Spinning{0.2, 0.01, 0.0127});
  scene.pockets = JawedPockets{};
  return scene;
}

/// UMB's match table: heated cloth is fast.
Scene carom_table() {
  return full_table(2.84, 1.42, carom_ball, Spinning{0.17, 0.006, 0.01});
}

/// WPBSA's full-size table. Its jaws are curves; rounded noses of this size come near them.
Scene snooker_table() {
  Scene scene = full_table(3.569, 1.778, snooker_ball, Spinning{0.2, 0.009, 0.0117});
  JawedPockets jaws;
  jaws.corner_mouth_m = 0.1080;
  jaws.side_mouth_m = 0.1180;
  jaws.corner_cut_rad = 2.4;
  jaws.side_cut_rad = 1.9;
  jaws.corner_shelf_m = 0.03;
  jaws.side_shelf_m = 0.01;
  jaws.corner_nose_m = 0.06;
  jaws.side_nose_m = 0.03;
  jaws.corner_hole_m = 0.05;
  jaws.side_hole_m = 0.05;
  scene.pockets = jaws;
  return scene;
}

}  // namespace

Vec2 head_spot(const Bed& bed) {
  return {-bed.length_m.value() / 4, 0};
}
Vec2 foot_spot(const Bed& bed) {
  return {bed.length_m.value() / 4, 0};
}
double head_string_x(const Bed& bed) {
  return head_spot(bed).x;
}

std::array<Vec2, 15> triangle_rack(const Bed& bed, const BallKind& ball, double gap_m) {
  constexpr double half_sqrt_3 = 0.8660254037844386;
  const double spacing = 2 * ball.radius_m + gap_m;
  const Vec2 apex = foot_spot(bed);
  std::array<Vec2, 15> places;
  std::size_t next = 0;
  for (int row = 0; row < 5; ++row) {
    for (int place = 0; place <= row; ++place) {
      places[next++] = {apex.x + row * (spacing * half_sqrt_3),
                        apex.y + (place - row / 2.0) * spacing};
    }
  }
  return places;
}

std::array<Vec2, 6> pocket_targets(const Bed& bed) {
  const double x = bed.length_m.value() / 2;
  const double y = bed.width_m.value() / 2;
  return {{{-x, -y}, {0, -y}, {x, -y}, {x, y}, {0, y}, {-x, y}}};
}

const std::vector<Preset>& tables() {
  static const std::vector<Preset> all = {
      {"bar", "7-foot pool table", pool_table(1.9812, 0.9906)},
      {"club", "8-foot pool table", pool_table(eight_foot_length_m, eight_foot_width_m)},
      {"tournament", "9-foot pool table", pool_table(2.54, 1.27)},
      {"carom", "10-foot carom table: no pockets, larger balls", carom_table()},
      {"snooker", "12-foot snooker table, smaller balls", snooker_table()},
  };
  return all;
}

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = {
      {"club", "8-foot table with everything: spin, throw, jaws, slight imperfections",
       tables()[1].scene},
      {"bar", "7-foot table, otherwise like club", tables()[0].scene},
      {"tournament", "9-foot table, otherwise like club", tables()[2].scene},
      {"plain", "8-foot table, straight paths, restitution at balls and cushions", plain_table()},
      {"paper", "the paper's 8-foot table: elastic balls, mirror cushions, perturbed normals",
       paper_table()},
  };
  return all;
}

}  // namespace breakshot::physics
