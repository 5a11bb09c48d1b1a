#include "client_cli/simulation_report.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <variant>

#include "common/hash/hash.hpp"
#include "common/physics/timeline.hpp"
#include "common/physics/validation.hpp"
#include "common/record/record.hpp"

namespace breakshot::client {
namespace {

using physics::BallState;
using physics::shown;

constexpr std::array<const char*, 5> phases = {"rest", "slide", "roll", "spin", "pocketed"};
constexpr std::array<const char*, 7> kinds = {"strike", "ball_ball", "ball_cushion", "ball_pocket",
                                              "rolls",  "spins",     "rests"};
static_assert(kinds.size() == std::variant_size_v<physics::Event>);
constexpr std::array<const char*, 4> endings = {"rest", "horizon", "until", "stalled"};

std::string vector_of(physics::Vec2 v) {
  return "[" + shown(v.x) + "," + shown(v.y) + "]";
}

std::string vector_of(physics::Vec3 v) {
  return "[" + shown(v.x) + "," + shown(v.y) + "," + shown(v.z) + "]";
}

std::string json_of(const BallState& ball) {
  return "{\"id\":" + std::to_string(number(ball.id)) + ",\"phase\":\"" +
         phases[static_cast<std::size_t>(ball.phase)] + "\",\"p\":" + vector_of(ball.position) +
         ",\"v\":" + vector_of(ball.velocity) + ",\"w\":" + vector_of(ball.spin) + "}";
}

template <class Items, class Print>
std::string list_of(const Items& items, const Print& print) {
  std::string list = "[";
  for (const auto& item : items) list += (list.size() > 1 ? "," : "") + print(item);
  return list + "]";
}

std::string ids_of(const std::vector<physics::BallId>& ids) {
  return list_of(ids, [](physics::BallId id) { return std::to_string(number(id)); });
}

std::string line_of(const physics::Event& event, const physics::Timeline& timeline) {
  const physics::BallsOf balls = balls_of(event);
  std::vector<physics::BallId> ids = {balls.first};
  if (balls.second) ids.push_back(*balls.second);
  std::string line = "{\"t\":" + shown(time_of(event)) + ",\"kind\":\"" + kinds[event.index()] +
                     "\",\"balls\":" + ids_of(ids);
  if (const auto* contact = std::get_if<physics::BallCushion>(&event)) {
    line += ",\"cushion\":" + std::to_string(number(contact->cushion));
  }
  if (const auto* drop = std::get_if<physics::BallPocket>(&event)) {
    line += ",\"pocket\":" + std::to_string(number(drop->pocket));
  }
  return line + ",\"states\":" +
         list_of(ids,
                 [&](physics::BallId id) { return json_of(timeline.state(id, time_of(event))); }) +
         "}";
}

std::vector<physics::BallId> pocketed_in(const physics::Shot& shot) {
  std::vector<physics::BallId> balls;
  for (const physics::Event& event : shot.events) {
    if (const auto* drop = std::get_if<physics::BallPocket>(&event)) balls.push_back(drop->ball);
  }
  return balls;
}

std::string last_line(const Simulated& simulated, const physics::Timeline& timeline,
                      const std::optional<physics::Audit>& audit) {
  const physics::Shot& shot = simulated.shot;
  std::string line = "{\"final\":" + list_of(timeline.states(shot.end_s), json_of) +
                     ",\"pocketed\":" + ids_of(pocketed_in(shot)) +
                     ",\"events\":" + std::to_string(shot.events.size()) +
                     ",\"seconds\":" + shown(shot.end_s) + ",\"stopped\":\"" +
                     endings[static_cast<std::size_t>(simulated.ending)] + "\"";
  if (simulated.ending == Ending::stalled) line += ",\"stalled\":" + ids_of(simulated.stalled);
  line += ",\"digest\":\"" + hash::hex_of(record::simulation_digest(shot)) + "\"";
  if (audit) {
    line += ",\"energyStart\":" + shown(audit->energy_start_J) +
            ",\"energyEnd\":" + shown(audit->energy_end_J) +
            ",\"worstRise\":" + shown(audit->worst_rise_J) +
            ",\"worstPenetration\":" + shown(audit->worst_penetration_m);
  }
  return line + "}";
}

}  // namespace

void print_report(std::ostream& out, const Simulated& simulated,
                  const std::optional<physics::Audit>& audit) {
  const physics::Timeline timeline(simulated.shot);
  for (const physics::Event& event : simulated.shot.events) {
    out << line_of(event, timeline) << '\n';
  }
  out << last_line(simulated, timeline, audit) << '\n';
}

}  // namespace breakshot::client
