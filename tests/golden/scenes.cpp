#include "tests/golden/scenes.hpp"

namespace breakshot::golden {
namespace {

using namespace physics;

constexpr double elastic_below_m_s = 1e-3;

struct Table {
  const char* name;
  double length_m;
  double width_m;
  BallKind ball;
};

constexpr Table tables[] = {
    {"7ft", 1.9812, 0.9906, {0.028575, 0.155922}},
    {"8ft", 2.3368, 1.1684, {0.028575, 0.155922}},
    {"9ft", 2.54, 1.27, {0.028575, 0.155922}},
    {"10ft", 2.84, 1.42, {0.03075, 0.21}},
    {"12ft", 3.569, 1.778, {0.02625, 0.142}},
    {"toy", 0.6, 0.3, {0.0125, 0.02}},
    {"hall", 40, 20, {0.25, 90}},
};
constexpr std::size_t roomy_tables = 5;

constexpr const char* motions[] = {"frictionless", "straight", "spinning"};
constexpr const char* contacts[] = {"through", "elastic", "restitution", "frictional",
                                    "mathavan2014"};
constexpr const char* cushion_models[] = {"mirror", "restitution", "han2005", "mathavan2010",
                                          "stronge2000"};

Motion motion(std::size_t which, Draws& draws) {
  if (which == 0) return Frictionless{};
  const double sliding = draws.between(0.05, 0.5);
  const double rolling = draws.between(0.005, 0.05);
  if (which == 1) return Straight{sliding, rolling, draws.between(0, 2)};
  return Spinning{sliding, rolling, draws.between(0.002, 0.05)};
}

BallBallModel contact(std::size_t which, Draws& draws) {
  const double e = draws.one_of({0.0, 0.5, 0.9, 0.95, 0.97, 1.0});
  switch (which) {
    case 1:
      return Elastic{};
    case 2:
      return BallRestitution{e, elastic_below_m_s};
    case 3:
      return BallFriction{e, 0.009951, 0.108, 1.088, elastic_below_m_s};
    default:
      return Mathavan2014{e, draws.between(0, 0.2), elastic_below_m_s};
  }
}

CushionModel cushion(std::size_t which, const BallKind& ball, Draws& draws) {
  const double e = draws.one_of({0.0, 0.5, 0.75, 0.85, 0.98, 1.0});
  const double friction = draws.one_of({0.0, 0.14, 0.2, 0.6});
  const double height_m = ball.radius_m * draws.one_of({1.0, 1.27, 1.27, 1.4});
  switch (which) {
    case 0:
      return Mirror{};
    case 1:
      return CushionRestitution{e, draws.between(0.5, 1), elastic_below_m_s};
    case 2:
      return Han2005{e, friction, height_m};
    case 3:
      return Mathavan2010{e, friction, height_m};
    default:
      return Stronge2000{e, friction, height_m, draws.between(1, 3)};
  }
}

/// A box whose sides are aslant, and a round post on either side of its middle.
FreeCushions slanted_box(const Table& table, const CushionModel& model) {
  const double x = table.length_m / 2;
  const double y = table.width_m / 2;
  const Vec2 corners[] = {{-x, -y}, {0.95 * x, -0.9 * y}, {x, y}, {-0.9 * x, 0.95 * y}};
  FreeCushions cushions;
  for (std::size_t i = 0; i < 4; ++i) {
    cushions.segments.push_back({corners[i], corners[(i + 1) % 4], model});
  }
  const Vec2 quarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (const double side : {-0.45, 0.45}) {
    for (std::size_t i = 0; i < 4; ++i) {
      cushions.arcs.push_back(
          {{side * x, 0.3 * y}, 0.1 * y, quarters[i], quarters[(i + 1) % 4], model});
    }
  }
  return cushions;
}

/// The WPA's jaws, in proportion to the ball.
JawedPockets jaws(const BallKind& ball) {
  const double k = ball.radius_m / 0.028575;
  return {0.1158875 * k, 0.1285875 * k, 2.478367538,   1.815142422, 0.041275 * k,
          0.0047625 * k, 0.020955 * k,  0.0079375 * k, 0.062 * k,   0.0645 * k};
}

const char* add_pockets(Scene& scene, Draws& draws) {
  const double k = scene.ball.radius_m / 0.028575;
  switch (draws.below(3)) {
    case 0:
      return "-";
    case 1:
      scene.pockets = StandardPockets{0.1158875 * k, 0.1285875 * k};
      return "-standard-";
    default:
      scene.pockets = jaws(scene.ball);
      return "-jawed-";
  }
}

const char* add_perturbation(Scene& scene, Draws& draws) {
  const double scale = draws.one_of({0.0, 0.0, 0.0005, 0.01, 1.0});
  if (scale == 0) return "";
  scene.perturbation = Perturbation{scale, scale / 2};
  return "-perturbed";
}

}  // namespace

NamedScene scene_of(const Models& models, bool roomy, Draws& draws) {
  const Table& table = tables[draws.below(roomy ? roomy_tables : std::size(tables))];
  Scene scene;
  scene.gravity_m_s2 = 9.81;
  scene.ball = table.ball;
  scene.bed = {motion(models.motion, draws), table.length_m, table.width_m};
  std::string name = std::string(motions[models.motion]) + "-" + contacts[models.contact];
  if (models.contact > 0) scene.ball_ball = contact(models.contact, draws);
  if (models.cushions == 0) {
    name += "-open-";
  } else {
    const std::size_t which = (models.cushions - 1) % 5;
    const CushionModel model = cushion(which, table.ball, draws);
    name += std::string("-") + cushion_models[which];
    if (models.cushions > 5) {
      scene.cushions = slanted_box(table, model);
      name += "-box-";
    } else {
      scene.cushions = RectangleCushions{model};
      name += add_pockets(scene, draws);
    }
  }
  name += table.name;
  name += add_perturbation(scene, draws);
  return {name, scene};
}

}  // namespace breakshot::golden
