#include "client_cli/play/stance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "client_cli/bot/aim.hpp"
#include "client_cli/words.hpp"
#include "common/physics/angle.hpp"
#include "common/rules/eight_ball.hpp"
#include "common/rules/groups.hpp"
#include "common/rules/placement.hpp"

namespace breakshot::client {
namespace {

using Problem = std::optional<std::string>;

/// Far enough to reach anything on any table, m.
constexpr double reach_m = 100;

std::string number_text(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

physics::Vec2 cue_place(const Moment& moment) {
  return rules::find(moment.table, rules::cue_ball)->position;
}

bot::FirstContact contact_of(const Moment& moment, physics::BallId mover, physics::Vec2 direction) {
  return bot::first_contact(moment.scene, moment.table, mover, direction, reach_m);
}

std::string cut_text(physics::Vec2 aim, physics::Vec2 way) {
  const double cosine = std::clamp(physics::dot(aim, way), -1.0, 1.0);
  const double degrees = std::acos(cosine) * 180 / physics::pi;
  if (degrees < 0.5) return "full";
  const std::string number = number_text(degrees, 0);
  return "cut by " + number + (number == "1" ? " degree" : " degrees") + " to the " +
         (physics::cross(aim, way) > 0 ? "left" : "right");
}

std::string tip_text(const physics::Tip& tip) {
  const std::string words = words_of(tip);
  return words.empty() ? "" : ", the tip " + words;
}

std::string line_text(const Moment& moment, physics::Vec2 direction) {
  const auto contact = contact_of(moment, rules::cue_ball, direction);
  if (!contact.ball) return "The cue ball meets no ball before a cushion.";
  return "The cue ball meets the " + words_of(*contact.ball) + ", " +
         cut_text(direction, contact.ball_way) + ", and sends it along " +
         number_text(degrees_of(contact.ball_way), 1) + " degrees.";
}

/// The fault of a call by the rules of the game that is played.
Problem call_fault(const Moment& moment, const rules::Call& call) {
  if (moment.kind == match::GameKind::practice) return rules::call_fault(rules::Practice{}, call);
  return rules::call_fault(rules::EightBall{moment.game.turn, moment.game}, moment.table, call);
}

}  // namespace

double degrees_of(physics::Vec2 direction) {
  return std::atan2(direction.y, direction.x) * 180 / physics::pi;
}

bool asks_for_call(const Moment& moment) {
  return call_fault(moment, rules::Call{}).has_value();
}

Problem aim_along(Stance& stance, double degrees) {
  constexpr double most = 1e6;
  if (!(std::abs(degrees) <= most)) return "An angle of more than a million degrees is none.";
  stance.direction = physics::direction_of(degrees * physics::pi / 180);
  return std::nullopt;
}

Problem turn_by(Stance& stance, double degrees) {
  if (!stance.direction) return "There is no aim yet that could be turned; aim first.";
  return aim_along(stance, degrees_of(*stance.direction) + degrees);
}

Problem aim_at(Stance& stance, const Moment& moment, physics::BallId ball,
               std::optional<physics::PocketId> pocket) {
  const physics::Ball* object = rules::find(moment.table, ball);
  if (object == nullptr) return "The " + words_of(ball) + " is not on the table.";
  const physics::Vec2 cue = cue_place(moment);
  if (!pocket) {
    stance.direction = bot::towards(cue, object->position);
    return std::nullopt;
  }
  const auto gates = bot::gates_of(moment.scene);
  if (gates.empty()) return "This table has no pockets.";
  const physics::Vec2 way =
      bot::towards(object->position, gates.at(physics::number(*pocket)).middle());
  const auto aim = bot::aim_of(cue, object->position, way, moment.scene.ball.radius_m);
  if (!aim) {
    return "From there the " + words_of(ball) + " cannot be cut into the " + words_of(*pocket) +
           " directly.";
  }
  stance.direction = aim->direction;
  const rules::Call call{ball, pocket, false};
  if (asks_for_call(moment) && !call_fault(moment, call)) stance.call = call;
  return std::nullopt;
}

Problem set_speed(Stance& stance, double speed_m_s) {
  if (!(speed_m_s > 0 && speed_m_s <= match::max_shot_speed_m_s)) {
    return "The speed must be above 0 and at most " + number_text(match::max_shot_speed_m_s, 0) +
           " m/s.";
  }
  stance.speed_m_s = speed_m_s;
  return std::nullopt;
}

Problem set_tip(Stance& stance, const Moment& moment, const physics::Tip& tip) {
  if (!(tip == physics::Tip{}) &&
      !std::holds_alternative<physics::Spinning>(moment.scene.bed.motion)) {
    return "The balls of this table do not spin; only the centre can be struck.";
  }
  constexpr double limit = physics::miscue_offset;
  if (!(tip.side * tip.side + tip.height * tip.height <= limit * limit)) {
    return "There the cue would slip: the tip must be at most " + number_text(limit, 1) +
           " radii off the centre.";
  }
  stance.tip = tip;
  return std::nullopt;
}

Problem set_call(Stance& stance, const Moment& moment, const rules::Call& call) {
  if (call != rules::Call{}) {
    if (auto fault = call_fault(moment, call)) return "That cannot be called: " + *fault + ".";
  }
  stance.call = call;
  return std::nullopt;
}

Problem missing(const Stance& stance, const Moment& moment) {
  if (!rules::may_play_from(moment.scene.bed, moment.game.ball_in_hand, cue_place(moment))) {
    return "The cue ball is in hand; put it behind the head string first: place X Y.";
  }
  if (!stance.direction) return "Aim first: aim DEGREES, or at BALL POCKET.";
  if (call_fault(moment, stance.call)) {
    return "Say what the shot is for: call BALL POCKET, or call safety.";
  }
  return std::nullopt;
}

std::vector<std::string> preview(const Stance& stance, const Moment& moment) {
  std::vector<std::string> lines;
  const std::string speed = number_text(stance.speed_m_s, 2) + " m/s";
  if (stance.direction) {
    lines.push_back("Aim " + number_text(degrees_of(*stance.direction), 2) + " degrees at " +
                    speed + tip_text(stance.tip) + ". " + line_text(moment, *stance.direction));
  } else {
    lines.push_back("Not aimed yet; the speed is " + speed + tip_text(stance.tip) + ".");
  }
  if (asks_for_call(moment)) {
    const std::string call = words_of(stance.call);
    lines.push_back(call.empty() ? "Nothing is called yet." : "Called: " + call + ".");
  }
  return lines;
}

void draw_aim(const Stance& stance, const Moment& moment, Picture& picture) {
  if (!stance.direction) return;
  const physics::Vec2 from = cue_place(moment);
  picture.cue = CueVector{from, *stance.direction, stance.speed_m_s};
  const auto contact = contact_of(moment, rules::cue_ball, *stance.direction);
  picture.paths.push_back({rules::cue_ball, {from, contact.place}});
  if (!contact.ball) return;
  const physics::Vec2 object = rules::find(moment.table, *contact.ball)->position;
  const auto next = contact_of(moment, *contact.ball, contact.ball_way);
  picture.paths.push_back({*contact.ball, {object, next.place}});
}

}  // namespace breakshot::client
