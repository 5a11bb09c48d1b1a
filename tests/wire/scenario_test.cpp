// Scenario files: every fault is named with the path of its field.
#include "common/wire/scenario.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/replace.hpp"

namespace breakshot::wire {
namespace {

const std::string good = R"({
  "scene": {
    "gravity": 9.81,
    "ball": {"radius": 0.028575, "mass": 0.155922},
    "bed": {"length": 2.3368, "width": 1.1684, "motion": {"straight":
        {"slidingFriction": 0.2, "rollingFriction": 0.01, "rollingBelow": 1.0}}},
    "cushions": {"rectangle": {"model": {"mirror": {}}}},
    "pockets": {"standard": {}},
    "ballBall": {"restitution": {"normal": 0.95}},
    "perturbation": {"ball": 0.001}
  },
  "balls": [{"id": 0, "position": {"x": -0.5842, "y": 0}},
            {"id": 7, "position": {"x": 0.5842, "y": 0}, "velocity": {"x": 0.1, "y": 0}}],
  "strike": {"ball": 0, "angle": 0.5, "speed": 3.0},
  "seed": "00112233445566778899aabbccddeeff",
  "horizon": 60
})";

/// The field of the first fault, with what is wrong; empty for a good text.
std::string fault_of(const std::string& text) {
  const auto reading = read_scenario(text);
  if (std::holds_alternative<Scenario>(reading)) return "";
  const auto& fault = std::get<std::vector<physics::Fault>>(reading).at(0);
  return fault.field + ": " + fault.what;
}

std::string fault_after(const std::string& from, const std::string& to) {
  return fault_of(support::replaced(good, from, to));
}

void expect_fault(const std::string& from, const std::string& to, const std::string& field) {
  const std::string fault = fault_after(from, to);
  EXPECT_EQ(fault.rfind(field + ": ", 0), 0u) << to << " gives: " << fault;
}

TEST(Scenario, ReadsWhatItSays) {
  const auto reading = read_scenario(good);
  const auto* scenario = std::get_if<Scenario>(&reading);
  ASSERT_NE(scenario, nullptr) << fault_of(good);
  EXPECT_EQ(std::get<physics::Straight>(scenario->scene.bed.motion).sliding_friction, 0.2);
  EXPECT_EQ(std::get<physics::BallRestitution>(*scenario->scene.ball_ball).elastic_below_m_s, 1e-3);
  EXPECT_EQ(std::get<physics::StandardPockets>(*scenario->scene.pockets).side_mouth_m, 0.1285875);
  EXPECT_EQ(scenario->scene.perturbation->cushion, 0);
  ASSERT_EQ(scenario->state.balls.size(), 2u);
  EXPECT_EQ(scenario->state.balls[1].velocity, (physics::Vec2{0.1, 0}));
  EXPECT_NEAR(scenario->strike->direction.y, 0.479425538604203, 1e-16);
  EXPECT_EQ(scenario->seed.seed[1], 0x11);
  EXPECT_EQ(scenario->limits.horizon_s, 60);
  EXPECT_EQ(scenario->limits.max_events, 1'000'000u);
}

TEST(Scenario, NamesFieldsThatDoNotExist) {
  expect_fault("\"gravity\"", "\"gravitas\"", "scene.gravitas");
  expect_fault("\"straight\"", "\"flying\"", "scene.bed.motion.flying");
  expect_fault("\"mirror\"", "\"rubber\"", "scene.cushions.rectangle.model.rubber");
  expect_fault("\"x\": 0.1", "\"z\": 0.1", "balls[1].velocity.z");
}

// ---- The full model

const std::string full = R"({
  "scene": {
    "gravity": 9.81,
    "bed": {"length": 2.3368, "width": 1.1684, "motion": {"spinning":
        {"slidingFriction": 0.2, "rollingFriction": 0.01, "spinFriction": 0.0127}}},
    "cushions": {"rectangle": {"model": {"stronge2000":
        {"restitution": 0.8, "friction": 0.21, "height": 0.036}}}},
    "pockets": {"jawed": {"cornerMouth": 0.12, "sideShelf": 0.005}},
    "ballBall": {"frictional": {"restitution": 0.9, "c": 2}}
  },
  "balls": [{"id": 0, "position": {"x": -0.5842, "y": 0}},
            {"id": 7, "position": {"x": 0.5842, "y": 0}, "spin": {"x": 1, "y": 2, "z": 3}}],
  "strike": {"ball": 0, "angle": 0.5, "speed": 3.0, "tip": {"side": 0.2, "height": -0.1}}
})";

const std::string free_cushions = R"({
  "scene": {
    "bed": {"motion": {"frictionless": {}}},
    "cushions": {
      "segments": [{"from": {"x": 1, "y": -1}, "to": {"x": 1, "y": 1}, "model": {"mirror": {}}}],
      "arcs": [{"centre": {"x": -2, "y": 0}, "radius": 0.5, "from": {"x": 0, "y": -1},
                "to": {"x": 1, "y": 0}, "model": {"restitution": {"normal": 0.8, "tangential": 1}}}]
    }
  },
  "balls": [{"id": 0, "position": {"x": 0, "y": 0}}],
  "horizon": 60
})";

Scenario scenario_of(const std::string& text) {
  const auto reading = read_scenario(text);
  EXPECT_EQ(fault_of(text), "");
  const auto* scenario = std::get_if<Scenario>(&reading);
  return scenario == nullptr ? Scenario{} : *scenario;
}

void expect_fault_of_full(const std::string& from, const std::string& to,
                          const std::string& field) {
  const std::string fault = fault_of(support::replaced(full, from, to));
  EXPECT_EQ(fault.rfind(field + ": ", 0), 0u) << to << " gives: " << fault;
}

TEST(Scenario, ReadsTheFullModel) {
  const Scenario scenario = scenario_of(full);
  const physics::Scene& scene = scenario.scene;
  EXPECT_EQ(scene.bed.motion, (physics::Motion{physics::Spinning{0.2, 0.01, 0.0127}}));
  physics::Stronge2000 nose{0.8, 0.21, 0.036};
  EXPECT_EQ(nose.frequency_ratio, 1.8);
  EXPECT_EQ(scene.cushions, physics::Cushions{physics::RectangleCushions{nose}});
  physics::JawedPockets jaws;
  jaws.corner_mouth_m = 0.12;
  jaws.side_shelf_m = 0.005;
  EXPECT_EQ(scene.pockets, physics::Pockets{jaws});
  physics::BallFriction throwing;
  throwing.restitution = 0.9;
  throwing.c_s_m = 2;
  EXPECT_EQ(scene.ball_ball, physics::BallBallModel{throwing});
  EXPECT_EQ(scenario.strike->tip, (physics::Tip{0.2, -0.1}));
  EXPECT_EQ(scenario.state.balls.at(1).spin, (physics::Vec3{1, 2, 3}));
}

TEST(Scenario, ReadsEveryModelOfSpinningBalls) {
  const std::string stronge = R"("stronge2000":
        {"restitution": 0.8, "friction": 0.21, "height": 0.036})";
  const std::string numbers = R"({"restitution": 0.7, "friction": 0.1, "height": 0.035})";
  const auto cushion = [&](const std::string& name) {
    const auto scenario =
        scenario_of(support::replaced(full, stronge, "\"" + name + "\":" + numbers));
    return std::get<physics::RectangleCushions>(scenario.scene.cushions.value()).model;
  };
  EXPECT_EQ(cushion("han2005"), (physics::CushionModel{physics::Han2005{0.7, 0.1, 0.035}}));
  EXPECT_EQ(cushion("mathavan2010"),
            (physics::CushionModel{physics::Mathavan2010{0.7, 0.1, 0.035}}));
  const Scenario scenario =
      scenario_of(support::replaced(full, R"("frictional": {"restitution": 0.9, "c": 2})",
                                    R"("mathavan2014": {"restitution": 0.9, "friction": 0.06})"));
  physics::Mathavan2014 model;
  model.restitution = 0.9;
  model.friction = 0.06;
  EXPECT_EQ(scenario.scene.ball_ball, physics::BallBallModel{model});
}

TEST(Scenario, ReadsArcsAfterSegments) {
  const Scenario scenario = scenario_of(free_cushions);
  const auto& cushions = std::get<physics::FreeCushions>(scenario.scene.cushions.value());
  ASSERT_EQ(cushions.segments.size(), 1u);
  ASSERT_EQ(cushions.arcs.size(), 1u);
  EXPECT_EQ(cushions.arcs[0],
            (physics::CushionArc{
                {-2, 0}, 0.5, {0, -1}, {1, 0}, physics::CushionRestitution{0.8, 1, 1e-3}}));
  EXPECT_EQ(fault_of(support::replaced(free_cushions, "\"radius\": 0.5, ", "")),
            "scene.cushions.arcs[0].radius: is missing; it must be given");
  EXPECT_EQ(fault_of(support::replaced(free_cushions, "\"centre\": {\"x\": -2, \"y\": 0}, ", "")),
            "scene.cushions.arcs[0].centre.x: is missing; it must be given");
  EXPECT_EQ(fault_of(support::replaced(
                free_cushions,
                "\"segments\":", "\"rectangle\": {\"model\": {\"mirror\": {}}}, \"segments\":")),
            "scene.cushions: must be a rectangle, or segments and arcs, not both");
}

TEST(Scenario, NamesWhatIsMissingInTheFullModel) {
  const std::string stronge = "scene.cushions.rectangle.model.stronge2000.";
  expect_fault_of_full("\"rollingFriction\": 0.01, ", "",
                       "scene.bed.motion.spinning.rollingFriction");
  expect_fault_of_full(", \"spinFriction\": 0.0127", "", "scene.bed.motion.spinning.spinFriction");
  expect_fault_of_full("\"restitution\": 0.8, ", "", stronge + "restitution");
  expect_fault_of_full("\"friction\": 0.21, ", "", stronge + "friction");
  expect_fault_of_full(", \"height\": 0.036", "", stronge + "height");
  expect_fault_of_full("\"restitution\": 0.9, ", "", "scene.ballBall.frictional.restitution");
  expect_fault_of_full("\"frictional\": {\"restitution\": 0.9, \"c\": 2}",
                       "\"mathavan2014\": {\"restitution\": 0.9}",
                       "scene.ballBall.mathavan2014.friction");
  expect_fault_of_full("\"frictional\": {\"restitution\": 0.9, \"c\": 2}", "", "scene.ballBall");
  expect_fault_of_full("\"jawed\": {\"cornerMouth\": 0.12, \"sideShelf\": 0.005}", "",
                       "scene.pockets");
}

TEST(Scenario, NamesWhatCannotBeInTheFullModel) {
  expect_fault_of_full("\"side\": 0.2", "\"side\": 0.6", "strike.tip");
  expect_fault_of_full("\"side\": 0.2", "\"side\": \"NaN\"", "strike.tip.side");
  expect_fault_of_full("\"side\": 0.2", "\"left\": 0.2", "strike.tip.left");
  expect_fault_of_full("\"height\": 0.036", "\"height\": 0.1",
                       "scene.cushions.rectangle.model.stronge2000.height");
  EXPECT_EQ(fault_of(support::replaced(full, "\"side\": 0.2, ", "")), "");
  EXPECT_EQ(fault_of(support::replaced(full, "0.0127", "0")).rfind("horizon: ", 0), 0u);
  expect_fault("\"speed\": 3.0", "\"speed\": 3.0, \"tip\": {\"side\": 0.1}", "strike.tip");
}

TEST(Scenario, NamesFieldsThatAreGivenTwice) {
  expect_fault("\"gravity\": 9.81", "\"gravity\": 9.81, \"gravity\": 9.81", "scene.gravity");
  expect_fault("\"mass\": 0.155922", "\"mass\": 1, \"mass\": 1", "scene.ball.mass");
  expect_fault("\"y\": 0}}]", "\"y\": 0, \"y\": 0}}]", "balls[1].velocity.y");
  expect_fault("\"horizon\": 60", "\"balls\": []", "balls");
}

TEST(Scenario, NamesFieldsThatAreMissing) {
  expect_fault("\"gravity\": 9.81,", "", "scene.gravity");
  expect_fault("\"rollingFriction\": 0.01,", "", "scene.bed.motion.straight.rollingFriction");
  expect_fault("\"normal\": 0.95", "", "scene.ballBall.restitution.normal");
  expect_fault(
      "\"motion\": {\"straight\":", "\"motion\": {}, \"x\": {\"straight\":", "scene.bed.x");
  expect_fault("\"id\": 7,", "", "balls[1].id");
  expect_fault("\"x\": -0.5842,", "", "balls[0].position.x");
  expect_fault("\"angle\": 0.5,", "", "strike");
  expect_fault(", \"speed\": 3.0", "", "strike.speed");
  expect_fault("\"seed\": \"00112233445566778899aabbccddeeff\",", "", "seed");
  EXPECT_EQ(fault_after("\"horizon\": 60", "\"maxEvents\": 9"), "");
}

TEST(Scenario, NamesValuesThatCannotBe) {
  expect_fault("9.81", "\"NaN\"", "scene.gravity");
  expect_fault("9.81", "\"Infinity\"", "scene.gravity");
  expect_fault("9.81", "1e999", "scene.gravity");
  expect_fault("9.81", "\"heavy\"", "scene.gravity");
  expect_fault("9.81", "-9.81", "scene.gravity");
  expect_fault("\"id\": 7", "\"id\": 0", "balls[1].id");
  expect_fault("\"id\": 7", "\"id\": 1.5", "balls[1].id");
  expect_fault("\"x\": 0.5842", "\"x\": 2", "balls[1].position");
  expect_fault("\"x\": 0.5842", "\"x\": -0.55", "balls[1].position");
  expect_fault("\"ball\": 0,", "\"ball\": 3,", "strike.ball");
  expect_fault("\"ball\": 0,", "\"ball\": 7,", "strike.ball");
  expect_fault("\"angle\": 0.5", "\"direction\": {\"x\": 1, \"y\": 1}", "strike.direction");
  expect_fault("\"angle\": 0.5", "\"angle\": 1e7", "strike.angle");
  expect_fault("00112233", "0011223", "seed");
  expect_fault("00112233", "0011223g", "seed");
  expect_fault("\"horizon\": 60", "\"horizon\": 0", "horizon");
  expect_fault("\"horizon\": 60", "\"maxEvents\": 0", "maxEvents");
}

TEST(Scenario, NamesSeveralFaultsOfAScene) {
  const std::string text = support::replaced(support::replaced(good, "0.028575", "-1"),
                                             "\"slidingFriction\": 0.2", "\"slidingFriction\": -1");
  const auto reading = read_scenario(text);
  const auto* faults = std::get_if<std::vector<physics::Fault>>(&reading);
  ASSERT_NE(faults, nullptr);
  EXPECT_EQ(faults->size(), 2u);
}

TEST(Scenario, IsStrictJson) {
  for (const std::string text : {"", "{", "[]", "{\"scene\": {},}", "{'scene': {}}", "{} {}"}) {
    EXPECT_NE(fault_of(text), "") << text;
  }
  EXPECT_NE(fault_of("{\n  \"scene\": nonsense\n}").find("line 2"), std::string::npos);
}

}  // namespace
}  // namespace breakshot::wire
