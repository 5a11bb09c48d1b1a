#include "common/physics/table.hpp"

namespace breakshot::physics {
namespace {

/// The paper's bed with the friction that its section 3.4 asks for; the coefficients are usual ones
/// for a clean cloth (Alciatore, "Pool and billiards physics principles", table 1).
Bed eight_foot_bed() {
  return {Straight{0.2, 0.01, 1.0}, eight_foot_length_m, eight_foot_width_m};
}

Scene club_table() {
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
  Scene scene = club_table();
  scene.cushions = RectangleCushions{Mirror{}};
  scene.ball_ball = Elastic{};
  scene.perturbation = Perturbation{0.001, 0.001};
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

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = {
      {"club", "8-foot table, restitution at balls and cushions, slight imperfections",
       club_table()},
      {"paper", "the paper's 8-foot table: elastic balls, mirror cushions, perturbed normals",
       paper_table()},
  };
  return all;
}

}  // namespace breakshot::physics
