// Numbers at the ends of their ranges and beyond them. Which field a fault names:
// tests/physics/scene_test.cpp.
#include <functional>
#include <limits>
#include <utility>

#include "common/physics/simulation.hpp"
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double denormal = 5e-324;

/// A field of a full scene and its range.
struct Range {
  const char* field;
  double least;
  double greatest;
  std::function<void(Scene&, double)> set;
};

Scene full() {
  Scene scene = table(Spinning{}, Stronge2000{}, BallFriction{});
  scene.perturbation = Perturbation{};
  return scene;
}

template <class Model>
Model& cushion(Scene& scene) {
  auto& model = std::get<RectangleCushions>(*scene.cushions).model;
  if (!std::holds_alternative<Model>(model)) model = Model{};
  return std::get<Model>(model);
}

template <class Model>
Model& pair(Scene& scene) {
  if (!std::holds_alternative<Model>(*scene.ball_ball)) scene.ball_ball = Model{};
  return std::get<Model>(*scene.ball_ball);
}

Spinning& spinning(Scene& scene) {
  return std::get<Spinning>(scene.bed.motion);
}

/// Bed and balls are scaled along with the radius, so that the balls have room.
void set_radius(Scene& scene, double radius) {
  scene.ball.radius_m = radius;
  scene.bed.length_m = 80 * radius;
  scene.bed.width_m = 40 * radius;
  cushion<Stronge2000>(scene).height_m = 1.25 * radius;
}

const std::vector<Range>& ranges() {
  static const std::vector<Range> all{
      {"scene.gravity", 1e-3, 1000, [](Scene& s, double x) { s.gravity_m_s2 = x; }},
      {"scene.ball.radius", 1e-4, 10, set_radius},
      {"scene.ball.mass", 1e-6, 1e6, [](Scene& s, double x) { s.ball.mass_kg = x; }},
      {"scene.bed.length", 2 * radius_m, 1e4, [](Scene& s, double x) { s.bed.length_m = x; }},
      {"scene.bed.width", 2 * radius_m, 1e4, [](Scene& s, double x) { s.bed.width_m = x; }},
      {"scene.bed.motion.spinning.slidingFriction", 1e-300, 10,
       [](Scene& s, double x) { spinning(s).sliding_friction = x; }},
      {"scene.bed.motion.spinning.rollingFriction", 1e-300, 10,
       [](Scene& s, double x) { spinning(s).rolling_friction = x; }},
      {"scene.bed.motion.spinning.spinFriction", 1e-300, 10,
       [](Scene& s, double x) { spinning(s).spin_friction = x; }},
      {"scene.cushions.rectangle.model.restitution.normal", 0, 1,
       [](Scene& s, double x) { cushion<CushionRestitution>(s).normal = x; }},
      {"scene.cushions.rectangle.model.restitution.tangential", 0, 1,
       [](Scene& s, double x) { cushion<CushionRestitution>(s).tangential = x; }},
      {"scene.cushions.rectangle.model.restitution.elasticBelow", 0, 1,
       [](Scene& s, double x) { cushion<CushionRestitution>(s).elastic_below_m_s = x; }},
      {"scene.cushions.rectangle.model.han2005.restitution", 0, 1,
       [](Scene& s, double x) { cushion<Han2005>(s).restitution = x; }},
      {"scene.cushions.rectangle.model.han2005.friction", 0, 10,
       [](Scene& s, double x) { cushion<Han2005>(s).friction = x; }},
      {"scene.cushions.rectangle.model.han2005.height", radius_m, 1.99 * radius_m,
       [](Scene& s, double x) { cushion<Han2005>(s).height_m = x; }},
      {"scene.cushions.rectangle.model.mathavan2010.restitution", 0, 1,
       [](Scene& s, double x) { cushion<Mathavan2010>(s).restitution = x; }},
      {"scene.cushions.rectangle.model.mathavan2010.friction", 0, 10,
       [](Scene& s, double x) { cushion<Mathavan2010>(s).friction = x; }},
      {"scene.cushions.rectangle.model.mathavan2010.height", radius_m, 1.99 * radius_m,
       [](Scene& s, double x) { cushion<Mathavan2010>(s).height_m = x; }},
      {"scene.cushions.rectangle.model.stronge2000.restitution", 0, 1,
       [](Scene& s, double x) { cushion<Stronge2000>(s).restitution = x; }},
      {"scene.cushions.rectangle.model.stronge2000.friction", 0, 10,
       [](Scene& s, double x) { cushion<Stronge2000>(s).friction = x; }},
      {"scene.cushions.rectangle.model.stronge2000.height", radius_m, 1.99 * radius_m,
       [](Scene& s, double x) { cushion<Stronge2000>(s).height_m = x; }},
      {"scene.cushions.rectangle.model.stronge2000.frequencyRatio", 1, 10,
       [](Scene& s, double x) { cushion<Stronge2000>(s).frequency_ratio = x; }},
      {"scene.ballBall.restitution.normal", 0, 1,
       [](Scene& s, double x) { pair<BallRestitution>(s).normal = x; }},
      {"scene.ballBall.restitution.elasticBelow", 0, 1,
       [](Scene& s, double x) { pair<BallRestitution>(s).elastic_below_m_s = x; }},
      {"scene.ballBall.frictional.restitution", 0, 1,
       [](Scene& s, double x) { pair<BallFriction>(s).restitution = x; }},
      {"scene.ballBall.frictional.a", 0, 1,
       [](Scene& s, double x) { pair<BallFriction>(s).a = x; }},
      {"scene.ballBall.frictional.b", 0, 1,
       [](Scene& s, double x) { pair<BallFriction>(s).b = x; }},
      {"scene.ballBall.frictional.c", 0, 1000,
       [](Scene& s, double x) { pair<BallFriction>(s).c_s_m = x; }},
      {"scene.ballBall.frictional.elasticBelow", 0, 1,
       [](Scene& s, double x) { pair<BallFriction>(s).elastic_below_m_s = x; }},
      {"scene.ballBall.mathavan2014.restitution", 0, 1,
       [](Scene& s, double x) { pair<Mathavan2014>(s).restitution = x; }},
      {"scene.ballBall.mathavan2014.friction", 0, 1,
       [](Scene& s, double x) { pair<Mathavan2014>(s).friction = x; }},
      {"scene.ballBall.mathavan2014.elasticBelow", 0, 1,
       [](Scene& s, double x) { pair<Mathavan2014>(s).elastic_below_m_s = x; }},
      {"scene.perturbation.ball", 0, 1, [](Scene& s, double x) { s.perturbation->ball = x; }},
      {"scene.perturbation.cushion", 0, 1, [](Scene& s, double x) { s.perturbation->cushion = x; }},
  };
  return all;
}

/// Four balls in the middle of the bed, whatever its size: two of them in a row, if there is room.
State some_balls(const Scene& scene) {
  const double r = scene.ball.radius_m;
  State state;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Ball next = ball(i, {3 * r * i, i % 2 == 0 ? 0 : 0.3 * r});
    state.balls.push_back(next);
    if (!faults_of(scene, state).empty()) state.balls.pop_back();
  }
  return state;
}

TEST(RangeEnds, AreAllowedAndOneUlpBeyondIsRefused) {
  for (const Range& range : ranges()) {
    for (const auto& [bound, beyond] :
         {std::pair{range.least, -infinity}, std::pair{range.greatest, infinity}}) {
      Scene scene = full();
      range.set(scene, bound);
      EXPECT_TRUE(faults_of(scene).empty()) << range.field << " = " << bound;
      for (const double bad : {std::nextafter(bound, beyond), beyond, nan}) {
        // No friction at all is a value of its own, and below the range.
        if (bad == 0) continue;
        Scene wrong = full();
        range.set(wrong, bad);
        const auto faults = faults_of(wrong);
        EXPECT_TRUE(std::any_of(faults.begin(), faults.end(),
                                [&](const Fault& fault) { return fault.field == range.field; }))
            << range.field << " = " << bad;
      }
    }
  }
}

TEST(RangeEnds, GiveSoundShots) {
  for (const Range& range : ranges()) {
    for (const double bound : {range.least, range.greatest}) {
      Scene scene = full();
      range.set(scene, bound);
      const State state = some_balls(scene);
      ASSERT_FALSE(state.balls.empty()) << range.field;
      for (const double speed : {0.0, 1e-6, 3.0}) {
        Limits limits = until(20);
        limits.max_events = 20'000;
        const std::string where =
            std::string(range.field) + " " + std::to_string(bound) + " at " + std::to_string(speed);
        const bool stalled = expect_sound_if_stalled(
            scene, state, Strike{BallId{0}, {1, 0}, speed, {0.2, 0.3}}, limits, where);
        // Only what spins between two cushions that both touch it may.
        const bool lane = scene.bed.length_m == diameter_m || scene.bed.width_m == diameter_m;
        EXPECT_TRUE(!stalled || lane) << where;
      }
    }
  }
}

TEST(RangeEnds, OfSpeedGiveSoundShots) {
  for (const Scene& scene : every_table()) {
    const State state = racked(scene, 1e-4);
    Limits limits = until(0.2);
    const Strike strike{BallId{0}, {1, 0}, max_speed_m_s, {}};
    ASSERT_TRUE(faults_of(scene, state, strike).empty());
    const Shot shot = shot_of(scene, state, strike, {}, limits);
    expect_sound(scene, shot, name_of(scene));
    const Strike faster{BallId{0}, {1, 0}, std::nextafter(max_speed_m_s, infinity), {}};
    EXPECT_EQ(faults_of(scene, state, faster).at(0).field, "strike.speed");
  }
}

TEST(RangeEnds, OfSpinGiveSoundShots) {
  for (const BallBallModel& model : pair_models()) {
    const Scene scene = carpet(model);
    Ball top = ball(0, {0, 0});
    top.spin = {max_spin_rad_s, -max_spin_rad_s, max_spin_rad_s};
    const Shot shot = shot_of(scene, balls({top, ball(1, {0.3, -0.3})}));
    EXPECT_EQ(shot.stop, Stop::rest);
    expect_sound(scene, shot, name_of(scene));
    top.spin.z = std::nextafter(max_spin_rad_s, infinity);
    EXPECT_EQ(faults_of(scene, balls({top})).at(0).field, "balls[0].spin.z");
  }
}

TEST(RangeEnds, OfPlaceGiveSoundShots) {
  for (const Scene& scene : every_cloth()) {
    const double far = max_coordinate_m;
    // At 1e6 m an ulp is 1e-10 m: the balls must not overlap by more than notation loses.
    const State state = balls({ball(0, {far - 1, far}), ball(1, {far, far})});
    const Shot shot =
        shot_of(scene, state, Strike{BallId{0}, {1, 0}, 3, {}}, {}, limits_for(scene, 3));
    EXPECT_GE(all_of<BallBall>(shot).size(), 1u) << name_of(scene);
    expect_sound(scene, shot, name_of(scene));
    const State beyond = balls({ball(0, {std::nextafter(far, infinity), 0})});
    EXPECT_EQ(faults_of(scene, beyond).at(0).field, "balls[0].position.x");
  }
}

TEST(BadNumbers, AreRefusedInEveryFieldOfABallAndAStrike) {
  const Scene scene = full();
  const std::vector<std::pair<const char*, std::function<void(Ball&, double)>>> fields{
      {"balls[0].position.x", [](Ball& b, double x) { b.position.x = x; }},
      {"balls[0].position.y", [](Ball& b, double x) { b.position.y = x; }},
      {"balls[0].velocity.x", [](Ball& b, double x) { b.velocity.x = x; }},
      {"balls[0].velocity.y", [](Ball& b, double x) { b.velocity.y = x; }},
      {"balls[0].spin.x", [](Ball& b, double x) { b.spin.x = x; }},
      {"balls[0].spin.y", [](Ball& b, double x) { b.spin.y = x; }},
      {"balls[0].spin.z", [](Ball& b, double x) { b.spin.z = x; }},
  };
  for (const auto& [name, set] : fields) {
    for (const double bad : {nan, infinity, -infinity, 1e300, -1e300}) {
      Ball b = ball(0, {0, 0});
      set(b, bad);
      const auto faults = faults_of(scene, balls({b}));
      EXPECT_TRUE(std::any_of(faults.begin(), faults.end(),
                              [&, wanted = name](const Fault& f) { return f.field == wanted; }))
          << name << " = " << bad;
    }
  }
  const State state = balls({ball(0, {0, 0})});
  for (const double bad : {nan, infinity, -infinity}) {
    EXPECT_FALSE(faults_of(scene, state, {BallId{0}, {bad, 0}, 1, {}}).empty());
    EXPECT_FALSE(faults_of(scene, state, {BallId{0}, {1, bad}, 1, {}}).empty());
    EXPECT_FALSE(faults_of(scene, state, {BallId{0}, {1, 0}, bad, {}}).empty());
    EXPECT_FALSE(faults_of(scene, state, {BallId{0}, {1, 0}, 1, {bad, 0}}).empty());
    EXPECT_FALSE(faults_of(scene, state, {BallId{0}, {1, 0}, 1, {0, bad}}).empty());
  }
}

TEST(BadNumbers, BallsInOnePlaceAreRefused) {
  for (const Scene& scene : every_table()) {
    for (const double distance : {0.0, denormal, 1e-9, radius_m, diameter_m - 2e-12}) {
      const auto faults = faults_of(scene, balls({ball(0, {0, 0}), ball(1, {distance, 0})}));
      ASSERT_EQ(faults.size(), 1u) << distance;
      EXPECT_EQ(faults[0].field, "balls[1].position");
    }
  }
}

TEST(Denormals, OfSpeedSpinAndPlaceGiveSoundShots) {
  for (const Scene& scene : every_table()) {
    for (const double tiny : {denormal, 1e-320, 2.3e-308, 1e-200, 1e-160, 1e-100}) {
      Ball slow = ball(0, {tiny, -tiny}, {tiny, tiny});
      if (std::holds_alternative<Spinning>(scene.bed.motion)) slow.spin = {tiny, -tiny, tiny};
      // Frozen to the first, one that does not move.
      const Shot shot = shot_of(scene, balls({slow, ball(1, {tiny + diameter_m, 0})}), std::nullopt,
                                {}, until(10));
      expect_sound(scene, shot, name_of(scene) + " " + std::to_string(std::log10(tiny)));
      EXPECT_LT(shot.events.size(), 1000u) << name_of(scene) << tiny;
      // What touches and is pressed together is parted at elastic_below.
      EXPECT_NEAR(state_of(shot, 0).position.x, 0, 1e-5);
    }
  }
}

TEST(MinusZero, ChangesNoEventAndNoPlace) {
  for (const Scene& scene : every_table()) {
    const Shot plus = shot_of(scene, balls({ball(0, {0, 0}), ball(1, {0.4, 0.01}, {0, 0})}),
                              Strike{BallId{0}, {1, 0}, 2, {}}, {}, until(1));
    const Shot minus =
        shot_of(scene, balls({ball(0, {-0.0, -0.0}), ball(1, {0.4, 0.01}, {-0.0, -0.0})}),
                Strike{BallId{0}, {1, -0.0}, 2, {}}, {}, until(1));
    EXPECT_EQ(plus.events, minus.events) << name_of(scene);
    EXPECT_EQ(Timeline(plus).states(1), Timeline(minus).states(1)) << name_of(scene);
  }
}

TEST(Friction, Of1e300LetsBallsMoveAlmostForEver) {
  for (const bool spins : {false, true}) {
    Scene scene = carpet(BallRestitution{});
    if (spins) {
      scene.bed.motion = Spinning{1e-300, 1e-300, 1e-300};
    } else {
      scene.bed.motion = Straight{1e-300, 1e-300, 0.5};
    }
    Scene without = scene;
    if (spins) {
      without.bed.motion = Spinning{0, 0, 0};
    } else {
      without.bed.motion = Straight{0, 0, 0.5};
    }
    const State state =
        balls({ball(0, {0, 0}, {1, 0}), ball(1, {1, 0.01}), ball(2, {2, 0.02}, {0, -0.1})});
    const Shot shot = shot_of(scene, state, std::nullopt, {}, until(10));
    const Shot free = shot_of(without, state, std::nullopt, {}, until(10));
    ASSERT_EQ(shot.events.size(), free.events.size());
    EXPECT_GE(shot.events.size(), 1u);
    for (std::size_t k = 0; k < free.events.size(); ++k) {
      EXPECT_EQ(balls_of(shot.events[k]).first, balls_of(free.events[k]).first);
      EXPECT_NEAR(time_of(shot.events[k]), time_of(free.events[k]), 1e-14);
    }
    // And without a horizon it comes to rest, some 1e299 s later.
    const Shot whole = shot_of(scene, state);
    EXPECT_EQ(whole.stop, Stop::rest);
    EXPECT_GT(whole.end_s, 1e290);
    for (const BallState& b : Timeline(whole).states(whole.end_s)) {
      EXPECT_TRUE(std::isfinite(length(b.position)));
      EXPECT_EQ(b.velocity, Vec2{});
    }
  }
}

}  // namespace
}  // namespace breakshot::physics
