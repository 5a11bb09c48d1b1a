#include "common/physics/scene.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Scene good() {
  Scene scene = table(Straight{}, CushionRestitution{}, BallRestitution{});
  scene.pockets = StandardPockets{};
  scene.perturbation = Perturbation{1e-3, 1e-3};
  return scene;
}

TEST(SceneFaults, NameEveryBadField) {
  const std::vector<std::pair<std::string, std::function<void(Scene&, double)>>> fields = {
      {"scene.gravity", [](Scene& s, double x) { s.gravity_m_s2 = x; }},
      {"scene.ball.radius", [](Scene& s, double x) { s.ball.radius_m = x; }},
      {"scene.ball.mass", [](Scene& s, double x) { s.ball.mass_kg = x; }},
      {"scene.bed.length", [](Scene& s, double x) { s.bed.length_m = x; }},
      {"scene.bed.width", [](Scene& s, double x) { s.bed.width_m = x; }},
      {"scene.bed.motion.straight.slidingFriction",
       [](Scene& s, double x) { std::get<Straight>(s.bed.motion).sliding_friction = x; }},
      {"scene.bed.motion.straight.rollingFriction",
       [](Scene& s, double x) { std::get<Straight>(s.bed.motion).rolling_friction = x; }},
      {"scene.bed.motion.straight.rollingBelow",
       [](Scene& s, double x) { std::get<Straight>(s.bed.motion).rolling_below_m_s = x; }},
      {"scene.cushions.rectangle.model.restitution.normal",
       [](Scene& s, double x) {
         s.cushions = RectangleCushions{CushionRestitution{x, 1, 0}};
       }},
      {"scene.cushions.rectangle.model.restitution.tangential",
       [](Scene& s, double x) {
         s.cushions = RectangleCushions{CushionRestitution{1, x, 0}};
       }},
      {"scene.cushions.rectangle.model.restitution.elasticBelow",
       [](Scene& s, double x) {
         s.cushions = RectangleCushions{CushionRestitution{1, 1, x}};
       }},
      {"scene.pockets.standard.cornerMouth",
       [](Scene& s, double x) { std::get<StandardPockets>(*s.pockets).corner_mouth_m = x; }},
      {"scene.pockets.standard.sideMouth",
       [](Scene& s, double x) { std::get<StandardPockets>(*s.pockets).side_mouth_m = x; }},
      {"scene.ballBall.restitution.normal",
       [](Scene& s, double x) {
         s.ball_ball = BallRestitution{x, 0};
       }},
      {"scene.ballBall.restitution.elasticBelow",
       [](Scene& s, double x) {
         s.ball_ball = BallRestitution{1, x};
       }},
      {"scene.perturbation.ball", [](Scene& s, double x) { s.perturbation->ball = x; }},
      {"scene.perturbation.cushion", [](Scene& s, double x) { s.perturbation->cushion = x; }},
  };
  EXPECT_TRUE(faults_of(good()).empty());
  for (const auto& [field, set] : fields) {
    for (const double bad : {nan, infinity, -infinity, -1.0, 1e9}) {
      Scene scene = good();
      set(scene, bad);
      const auto faults = faults_of(scene);
      ASSERT_FALSE(faults.empty()) << field << " = " << bad;
      EXPECT_TRUE(std::any_of(faults.begin(), faults.end(),
                              [&, name = field](const Fault& f) { return f.field == name; }))
          << field << " = " << bad;
    }
  }
}

TEST(SceneFaults, NameWhatIsMissing) {
  Scene scene = good();
  scene.gravity_m_s2.reset();
  scene.bed.width_m.reset();
  const auto faults = faults_of(scene);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].field, "scene.gravity");
  EXPECT_EQ(faults[1].field, "scene.bed.width");
  EXPECT_TRUE(faults_of(gas()).empty());
}

TEST(SceneFaults, AllowTheEndsOfTheRanges) {
  Scene scene = good();
  scene.ball.radius_m = 10;
  scene.bed.length_m = 20;
  scene.bed.width_m = 1e4;
  scene.bed.motion = Straight{1e-300, 10, 0};
  scene.gravity_m_s2 = 1000;
  EXPECT_TRUE(faults_of(scene).empty());
}

TEST(SceneFaults, RefusePocketsWithoutARectangle) {
  Scene scene = good();
  scene.cushions = FreeCushions{};
  EXPECT_EQ(faults_of(scene).at(0).field, "scene.pockets.standard");
}

TEST(SceneFaults, RefuseACushionWithoutLength) {
  Scene scene = gas();
  scene.cushions = FreeCushions{{{{0, 0}, {1, 0}, Mirror{}}, {{2, 2}, {2, 2}, Mirror{}}}};
  EXPECT_EQ(faults_of(scene).at(0).field, "scene.cushions.segments[1].to");
}

TEST(StateFaults, NameTooManyBallsAsOneFault) {
  const auto faults = faults_of(good(), State{std::vector<Ball>(max_balls + 1)});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults.front().field, "balls");
}

TEST(StateFaults, NameTheBallAndTheField) {
  const Scene scene = good();
  const auto fault = [&](std::initializer_list<Ball> list) {
    const auto faults = faults_of(scene, balls(list));
    return faults.empty() ? std::string() : faults.front().field;
  };
  EXPECT_EQ(fault({}), "balls");
  EXPECT_EQ(fault({ball(0, {0, 0}), ball(0, {0.5, 0})}), "balls[1].id");
  EXPECT_EQ(fault({ball(0, {0, nan})}), "balls[0].position.y");
  EXPECT_EQ(fault({ball(0, {0, 0}), ball(1, {0.5, 0}, {1e5, 0})}), "balls[1].velocity.x");
  EXPECT_EQ(fault({ball(0, {0, 0}), ball(1, {0.05, 0})}), "balls[1].position");
  EXPECT_EQ(fault({ball(0, {0, 0}), ball(1, {0, 0})}), "balls[1].position");
  EXPECT_EQ(fault({ball(0, {1.16, 0})}), "balls[0].position");
  EXPECT_EQ(fault({ball(0, {3, 0})}), "balls[0].position");
  EXPECT_EQ(fault({{BallId{0}, {0, 0}, {}, {0, 0, 1}}}), "balls[0].spin");
}

TEST(StateFaults, AllowOverlapUpToDecimalNotation) {
  const auto faults = [](double distance) {
    return faults_of(gas(), balls({ball(0, {0, 0}), ball(1, {distance, 0})}));
  };
  EXPECT_TRUE(faults(0.05715).empty());
  EXPECT_TRUE(faults(0.05715 - 0.9e-12).empty());
  EXPECT_FALSE(faults(0.05715 - 1.1e-12).empty());
}

TEST(StateFaults, AllowOverlapWhereBallsPassThroughOneAnother) {
  Scene scene = gas();
  scene.ball_ball.reset();
  EXPECT_TRUE(faults_of(scene, balls({ball(0, {0, 0}), ball(1, {0, 0})})).empty());
}

TEST(StrikeFaults, NameTheField) {
  const State state = balls({ball(0, {0, 0}), ball(1, {0.5, 0}, {1, 0})});
  const auto fault = [&](const Strike& strike) {
    const auto faults = faults_of(good(), state, strike);
    return faults.empty() ? std::string() : faults.front().field;
  };
  EXPECT_EQ(fault({BallId{0}, {1, 0}, 3}), "");
  EXPECT_EQ(fault({BallId{9}, {1, 0}, 3}), "strike.ball");
  EXPECT_EQ(fault({BallId{1}, {1, 0}, 3}), "strike.ball");
  EXPECT_EQ(fault({BallId{0}, {1, 1}, 3}), "strike.direction");
  EXPECT_EQ(fault({BallId{0}, {0, 0}, 3}), "strike.direction");
  EXPECT_EQ(fault({BallId{0}, {1, 0}, -1}), "strike.speed");
  EXPECT_EQ(fault({BallId{0}, {1, 0}, nan}), "strike.speed");
}

TEST(Presets, AreFreeOfFaultsAndNamedOnce) {
  for (const Preset& preset : presets()) {
    EXPECT_TRUE(faults_of(preset.scene).empty()) << preset.name;
    EXPECT_TRUE(faults_of(preset.scene, racked(preset.scene, rack_gap_m)).empty()) << preset.name;
    EXPECT_EQ(std::count_if(presets().begin(), presets().end(),
                            [&](const Preset& other) { return other.name == preset.name; }),
              1);
  }
}

TEST(Rack, StandsOnTheFootSpotWithItsGaps) {
  const Scene scene = presets().front().scene;
  const auto places = triangle_rack(scene.bed, scene.ball, rack_gap_m);
  EXPECT_EQ(places[0], foot_spot(scene.bed));
  EXPECT_EQ(places[0], (Vec2{0.5842, 0}));
  EXPECT_EQ(head_spot(scene.bed), (Vec2{-0.5842, 0}));
  int neighbours = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      const double distance = length(places[j] - places[i]);
      EXPECT_GT(distance, 0.05715 + 0.00254 - 1e-15);
      if (distance < 0.0597) ++neighbours;
    }
  }
  EXPECT_EQ(neighbours, 30);
}

}  // namespace
}  // namespace breakshot::physics
