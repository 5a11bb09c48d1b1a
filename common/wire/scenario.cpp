#include "common/wire/scenario.hpp"

#include <google/protobuf/util/json_util.h>

#include <cctype>
#include <stdexcept>
#include <string>
#include <utility>

#include "breakshot/v1/scenario.pb.h"
#include "common/hash/hash.hpp"
#include "common/physics/angle.hpp"
#include "common/physics/validation.hpp"
#include "common/wire/check.hpp"
#include "common/wire/json_check.hpp"
#include "common/wire/scene.hpp"

namespace breakshot::wire {
namespace {

using physics::Fault;

/// Protobuf names fields in snake_case, the file in lowerCamelCase.
std::string camel_case(const std::string& path) {
  std::string camel;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] == '_' && i + 1 < path.size()) {
      camel += static_cast<char>(std::toupper(static_cast<unsigned char>(path[++i])));
    } else {
      camel += path[i];
    }
  }
  return camel;
}

/// Protobuf says "(scene.bed.motion) spinning: Cannot find field." or
/// "(scene.gravity): invalid value "x" for type TYPE_DOUBLE".
Fault fault_of_message(const std::string& message) {
  const std::size_t open = message.find('(');
  const std::size_t close = message.find(')');
  if (open != 0 || close == message.npos) return {"", message};
  std::string field = message.substr(1, close - 1);
  const std::size_t colon = message.find(": ", close);
  if (colon == message.npos) return {field, message.substr(close + 1)};
  if (colon > close + 2) {
    field += (field.empty() ? "" : ".") + message.substr(close + 2, colon - close - 2);
  }
  const std::string what = message.substr(colon + 2);
  if (what.rfind("Cannot find field", 0) == 0) {
    return {camel_case(field), "is not a field of a scenario"};
  }
  return {camel_case(field), what};
}

physics::Vec3 read(const v1::Vec3& message, const Where& at) {
  return {finite(message.x(), Where(at, "x")), finite(message.y(), Where(at, "y")),
          finite(message.z(), Where(at, "z"))};
}

physics::Ball read_ball(const v1::ScenarioBall& message, const Where& at) {
  physics::Ball ball;
  if (!message.has_id()) Where(at, "id").refuse("is missing; it must be given");
  ball.id = physics::BallId{message.id()};
  if (!message.has_position()) Where(at, "position").refuse("is missing; it must be given");
  ball.position = read(message.position(), Where(at, "position"));
  if (message.has_velocity()) {
    ball.velocity = read(message.velocity(), Where(at, "velocity"));
  }
  ball.spin = read(message.spin(), Where(at, "spin"));
  return ball;
}

physics::Vec2 read_direction(const v1::ScenarioStrike& message, const Where& at) {
  if (message.has_angle() == message.has_direction()) {
    at.refuse("needs either an angle or a direction");
    return {};
  }
  if (message.has_direction()) return read(message.direction(), Where(at, "direction"));
  const double angle = finite(message.angle(), Where(at, "angle"));
  if (angle > physics::max_angle_rad || angle < -physics::max_angle_rad) {
    Where(at, "angle")
        .refuse("is " + physics::shown(angle) + "; it must be from -1000000 to 1000000");
    return {};
  }
  return physics::direction_of(angle);
}

/// Zero where a number is missing.
physics::Tip read_tip(const v1::ScenarioTip& message, const Where& at) {
  return {finite(message.side(), Where(at, "side")), finite(message.height(), Where(at, "height"))};
}

physics::Strike read_strike(const v1::ScenarioStrike& message, const Where& at) {
  physics::Strike strike;
  if (!message.has_ball()) Where(at, "ball").refuse("is missing; it must be given");
  strike.ball = physics::BallId{message.ball()};
  strike.direction = read_direction(message, at);
  strike.speed_m_s = required(message.has_speed(), message.speed(), Where(at, "speed"));
  strike.tip = read_tip(message.tip(), Where(at, "tip"));
  return strike;
}

void write(physics::Vec2 v, v1::Vec2& message) {
  message.set_x(v.x);
  message.set_y(v.y);
}

void write(const physics::Ball& ball, v1::ScenarioBall& message) {
  message.set_id(number(ball.id));
  write(ball.position, *message.mutable_position());
  write(ball.velocity, *message.mutable_velocity());
  if (ball.spin == physics::Vec3{}) return;
  message.mutable_spin()->set_x(ball.spin.x);
  message.mutable_spin()->set_y(ball.spin.y);
  message.mutable_spin()->set_z(ball.spin.z);
}

void write(const physics::Strike& strike, v1::ScenarioStrike& message) {
  message.set_ball(number(strike.ball));
  write(strike.direction, *message.mutable_direction());
  message.set_speed(strike.speed_m_s);
  if (strike.tip == physics::Tip{}) return;
  message.mutable_tip()->set_side(strike.tip.side);
  message.mutable_tip()->set_height(strike.tip.height);
}

void read_seed(const v1::Scenario& message, Scenario& scenario, const Where& at) {
  const auto& perturbation = scenario.scene.perturbation;
  if (message.has_seed()) {
    const auto seed = hash::bytes_of_hex<16>(message.seed());
    if (seed) {
      scenario.seed.seed = *seed;
    } else {
      at.refuse("is \"" + message.seed() + "\"; it must be exactly 32 hexadecimal digits");
    }
  } else if (perturbation && (perturbation->ball > 0 || perturbation->cushion > 0)) {
    at.refuse("is missing; a scene with perturbation needs one");
  }
}

void read_limits(const v1::Scenario& message, Scenario& scenario, const Where& root) {
  if (message.has_horizon()) {
    const Where at(root, "horizon");
    const double horizon = finite(message.horizon(), at);
    if (!(horizon > 0)) {
      at.refuse("is " + physics::shown(horizon) + "; it must be greater than 0");
    }
    scenario.limits.horizon_s = horizon;
  } else if (physics::may_never_rest(scenario.scene)) {
    Where(root, "horizon").refuse("is missing; without friction a ball may never come to rest");
  }
  if (message.has_max_events()) {
    if (message.max_events() == 0) Where(root, "max_events").refuse("is 0; it must be at least 1");
    scenario.limits.max_events = message.max_events();
  }
}

/// What the form of the message says; ranges are checked afterwards.
Scenario scenario_of(const v1::Scenario& message, const Where& root) {
  Scenario scenario;
  if (!message.has_scene()) Where(root, "scene").refuse("is missing; it must be given");
  scenario.scene = read(message.scene(), Where(root, "scene"));
  for (int i = 0; i < message.balls_size() && root.good(); ++i) {
    scenario.state.balls.push_back(read_ball(message.balls(i), Where(root, "balls", i)));
  }
  if (message.has_strike()) scenario.strike = read_strike(message.strike(), Where(root, "strike"));
  read_seed(message, scenario, Where(root, "seed"));
  read_limits(message, scenario, root);
  return scenario;
}

std::vector<Fault> faults_of(const Scenario& scenario) {
  std::vector<Fault> faults = physics::faults_of(scenario.scene);
  // Balls and strike can only be judged on a table that exists.
  if (!faults.empty()) return faults;
  faults = physics::faults_of(scenario.scene, scenario.state);
  if (scenario.strike) {
    for (Fault& fault : physics::faults_of(scenario.scene, scenario.state, *scenario.strike)) {
      faults.push_back(std::move(fault));
    }
  }
  return faults;
}

}  // namespace

std::variant<Scenario, std::vector<Fault>> read_scenario(std::string_view json) {
  if (const auto fault = json_fault(json)) return std::vector{*fault};
  v1::Scenario message;
  const auto status = google::protobuf::util::JsonStringToMessage(
      google::protobuf::StringPiece(json.data(), json.size()), &message);
  if (!status.ok()) return std::vector{fault_of_message(std::string(status.message()))};
  std::optional<Fault> form;
  Scenario scenario = scenario_of(message, Where(form));
  if (form) return std::vector{Fault{camel_case(form->field), form->what}};
  std::vector<Fault> faults = faults_of(scenario);
  if (!faults.empty()) return faults;
  return scenario;
}

std::string text_of(const Scenario& scenario) {
  v1::Scenario message;
  write(scenario.scene, *message.mutable_scene());
  for (const physics::Ball& ball : scenario.state.balls) write(ball, *message.add_balls());
  if (scenario.strike) write(*scenario.strike, *message.mutable_strike());
  message.set_seed(hash::hex_of(scenario.seed.seed));
  if (scenario.limits.horizon_s) message.set_horizon(*scenario.limits.horizon_s);
  message.set_max_events(scenario.limits.max_events);
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  std::string text;
  const auto status = google::protobuf::util::MessageToJsonString(message, &text, options);
  if (!status.ok()) throw std::logic_error("a scenario has no JSON: " + status.ToString());
  return text;
}

}  // namespace breakshot::wire
