// `breakshot simulate` from outside.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "common/physics/simulate.hpp"
#include "tests/support/replace.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/subprocess.hpp"

namespace breakshot {
namespace {

const std::string scenario = R"({
  "scene": {"gravity": 9.81,
    "bed": {"motion": {"straight": {"slidingFriction": 0.2, "rollingFriction": 0.01, "rollingBelow": 1}}},
    "ballBall": {"elastic": {}}},
  "balls": [{"id": 4, "position": {"x": 1, "y": 0}}, {"id": 0, "position": {"x": 0, "y": 0}}],
  "strike": {"ball": 0, "direction": {"x": 1, "y": 0}, "speed": 2}
})";

support::Finished simulate(const std::string& text, std::vector<std::string> options = {}) {
  const support::Scratch scratch;
  const std::string file = scratch.path() / "scenario.json";
  std::ofstream(file) << text;
  std::vector<std::string> words = {BREAKSHOT_PROGRAM, "simulate", file};
  words.insert(words.end(), options.begin(), options.end());
  return support::run(words);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

TEST(Simulate, PrintsEventsAndTheFinalStateInAFixedForm) {
  const auto ran = simulate(scenario);
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.err, "");
  const auto lines = lines_of(ran.out);
  ASSERT_EQ(lines.size(), 5u) << ran.out;
  EXPECT_EQ(lines[0],
            "{\"t\":0,\"kind\":\"strike\",\"balls\":[0],\"states\":[{\"id\":0,\"phase\":\"slide\","
            "\"p\":[0,0],\"v\":[2,0],\"w\":[0,0,0]}]}");
  EXPECT_NE(lines[1].find("\"kind\":\"rolls\",\"balls\":[0]"), std::string::npos);
  EXPECT_NE(lines[2].find("\"kind\":\"ball_ball\",\"balls\":[0,4]"), std::string::npos);
  EXPECT_NE(lines[3].find("\"kind\":\"rests\",\"balls\":[4]"), std::string::npos);
  EXPECT_EQ(lines[4].rfind("{\"final\":[{\"id\":0,\"phase\":\"rest\"", 0), 0u);
  EXPECT_NE(lines[4].find(",\"pocketed\":[],\"events\":4,\"seconds\":"), std::string::npos);
  EXPECT_NE(lines[4].find("\"stopped\":\"rest\",\"digest\":\""), std::string::npos);
}

TEST(Simulate, PrintsSpinWhereBallsSpin) {
  const std::string spinning = R"({
    "scene": {"gravity": 9.81, "bed": {"motion": {"spinning":
        {"slidingFriction": 0.2, "rollingFriction": 0.1, "spinFriction": 0.0127}}}},
    "balls": [{"id": 0, "position": {"x": 0, "y": 0}}],
    "strike": {"ball": 0, "direction": {"x": 1, "y": 0}, "speed": 0.5, "tip": {"side": 0.4}}
  })";
  const auto ran = simulate(spinning);
  EXPECT_EQ(ran.status, 0) << ran.err;
  const auto lines = lines_of(ran.out);
  ASSERT_EQ(lines.size(), 5u) << ran.out;
  EXPECT_EQ(lines[0].find("\"w\":[0,0,0]"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("\"kind\":\"rolls\""), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("\"kind\":\"spins\""), std::string::npos) << lines[2];
  EXPECT_NE(lines[2].find("\"phase\":\"spin\""), std::string::npos) << lines[2];
  EXPECT_NE(lines[3].find("\"kind\":\"rests\""), std::string::npos) << lines[3];
  EXPECT_NE(lines[3].find("\"w\":[0,0,0]"), std::string::npos) << lines[3];
}

TEST(Simulate, SlicesChangeNoByte) {
  EXPECT_EQ(simulate(scenario, {"--slices", "0.1,0.2,0.2,1e-18,5"}).out, simulate(scenario).out);
}

TEST(Simulate, UntilEndsAtThatTime) {
  const auto lines = lines_of(simulate(scenario, {"--until", "0.25"}).out);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[1].find("\"seconds\":0.25,\"stopped\":\"until\""), std::string::npos);
}

TEST(Simulate, AuditAddsItsKeysAtTheEnd) {
  const auto ran = simulate(scenario, {"--audit"});
  EXPECT_NE(ran.out.find("\"energyStart\":0.311844,\"energyEnd\":0,\"worstRise\":"),
            std::string::npos);
  EXPECT_NE(ran.out.find("\"worstPenetration\":"), std::string::npos);
}

TEST(Simulate, NamesTheFieldOfBadInputAndPrintsNothingElse) {
  const auto ran = simulate(support::replaced(scenario, "9.81", "-1"));
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err.rfind("breakshot: ", 0), 0u);
  EXPECT_NE(ran.err.find("scenario.json: scene.gravity: "), std::string::npos) << ran.err;
}

TEST(Simulate, SaysWhyAFileCannotBeRead) {
  const support::Scratch scratch;
  const auto folder = scratch.path().string();
  const auto said = [](const std::string& file) {
    const support::Finished finished = support::run({BREAKSHOT_PROGRAM, "simulate", file});
    EXPECT_EQ(finished.status, 2);
    return finished.err;
  };
  EXPECT_EQ(said(folder), "breakshot: " + folder + ": cannot be read: Is a directory\n");
  EXPECT_EQ(said(folder + "/none"),
            "breakshot: " + folder + "/none: cannot be read: No such file or directory\n");
}

TEST(Simulate, RefusesMethodsStepsAndScalarsThatMakeNoSense) {
  const std::string present_physics = std::to_string(physics::physics_version);
  const std::vector<std::pair<std::vector<std::string>, std::string>> senseless = {
      {{"--method", "euler"}, "--method: euler: must be one of exact, fixed, swept, literal"},
      {{"--method", "fixed"}, "--dt: the fixed method needs a time step"},
      {{"--method", "swept"}, "--dt: the swept method needs a time step"},
      {{"--method", "swept", "--dt", "0"}, "--dt: must be from 1e-9 to 1000 s"},
      {{"--method", "literal", "--dt", "-1"}, "--dt: must be from 1e-9 to 1000 s"},
      {{"--scalar", "half"}, "--scalar: half: must be one of float, double, longdouble, reference"},
      {{"--dt", "0.1"}, "--dt: the exact method has no time step"},
      {{"--until", "-1"}, "--until: must be a time of at least 0"},
      {{"--physics", "0"}, "--physics: must be from 1 to " + present_physics},
      {{"--physics", "99"}, "--physics: must be from 1 to " + present_physics}};
  for (const auto& [options, why] : senseless) {
    const auto ran = simulate(scenario, options);
    EXPECT_EQ(ran.status, 2) << options[0];
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err, "breakshot: " + why + "\n");
  }
  EXPECT_EQ(support::run({BREAKSHOT_PROGRAM, "simulate", "/no/such/file"}).status, 2);
}

TEST(Simulate, GivesTheBitsOfEarlierVersionsOfThePhysics) {
  const std::string frozen = BREAKSHOT_GOLDEN_DIR "/shots/break_frozen_head_on.json";
  const auto last_line = [&frozen](const std::string& physics) {
    return lines_of(support::run({BREAKSHOT_PROGRAM, "simulate", frozen, "--physics", physics}).out)
        .back();
  };
  EXPECT_NE(last_line("1").find("0f1c43a9baaf7eaf"), std::string::npos) << last_line("1");
  EXPECT_EQ(last_line("2"), last_line("1"));
  EXPECT_NE(last_line("3").find("7593e09223adaeec"), std::string::npos) << last_line("3");
}

TEST(Simulate, NamesThePartOfASceneThatTheLiteralMethodDoesNotKnow) {
  const std::string jaws = support::replaced(
      scenario, "\"ballBall\"",
      R"("cushions": {"rectangle": {"model": {"mirror": {}}}}, "pockets": {"jawed": {}}, "ballBall")");
  const auto ran =
      simulate(support::replaced(jaws, "\"bed\": {", "\"bed\": {\"length\": 4, \"width\": 2, "),
               {"--method", "literal"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("scenario.json: scene.pockets.jawed: "), std::string::npos) << ran.err;
}

TEST(Simulate, RunsEveryMethodInEveryScalar) {
  for (const std::string scalar : {"float", "double", "longdouble", "reference"}) {
    for (const std::vector<std::string>& method : {std::vector<std::string>{"exact"},
                                                   {"fixed", "--dt", "1e-3"},
                                                   {"swept", "--dt", "1e-3"},
                                                   {"literal", "--dt", "1e-3"},
                                                   {"literal"}}) {
      std::vector<std::string> options = {"--scalar", scalar, "--method"};
      options.insert(options.end(), method.begin(), method.end());
      const auto ran = simulate(scenario, options);
      EXPECT_EQ(ran.status, 0) << ran.err;
      EXPECT_EQ(lines_of(ran.out).size(), 5u) << method[0] << " in " << scalar;
    }
  }
  EXPECT_EQ(simulate(scenario, {"--scalar", "double", "--method", "exact"}).out,
            simulate(scenario).out);
}

TEST(Simulate, ExitsWithThreeWhenTheShotStalls) {
  const auto ran =
      simulate(support::replaced(scenario, "\"strike\"", "\"maxEvents\": 2, \"strike\""));
  EXPECT_EQ(ran.status, 3);
  const auto lines = lines_of(ran.out);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_NE(lines[2].find("\"stopped\":\"stalled\",\"stalled\":["), std::string::npos);
}

}  // namespace
}  // namespace breakshot
