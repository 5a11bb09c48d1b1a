#include <string>
#include <utility>

#include "common/match/match.hpp"
#include "common/physics/simulate.hpp"
#include "common/rules/placement.hpp"

namespace breakshot::match {
namespace {

using physics::Fault;
using physics::Scene;

void check_number(std::vector<Fault>& faults, const char* field, std::uint32_t value,
                  std::uint32_t least, std::uint32_t greatest) {
  if (value >= least && value <= greatest) return;
  const std::string right =
      least == greatest ? std::to_string(least)
                        : "from " + std::to_string(least) + " to " + std::to_string(greatest);
  faults.push_back({field, "is " + std::to_string(value) + "; it must be " + right});
}

/// What a game of pool needs beyond a faultless scene.
void check_table(std::vector<Fault>& faults, const Scene& scene) {
  const bool rectangle =
      scene.cushions && std::holds_alternative<physics::RectangleCushions>(*scene.cushions);
  if (!rectangle) {
    faults.push_back({"scene.cushions", "are not a rectangle; a match needs a rectangle's"});
  }
  if (!scene.pockets) faults.push_back({"scene.pockets", "are missing; a match needs pockets"});
  if (!scene.ball_ball) {
    faults.push_back({"scene.ballBall", "is missing; in a match balls must not pass through"});
  }
  if (physics::may_never_rest(scene)) {
    faults.push_back({"scene.bed.motion", "may never end; a match needs friction above 0"});
  }
  if (!rectangle) return;

  const double least_m = rules::least_bed_length_radii * scene.ball.radius_m;
  if (!(*scene.bed.length_m >= least_m)) {
    faults.push_back({"scene.bed.length", "is too short to spot a ball; it must be at least " +
                                              std::to_string(rules::least_bed_length_radii) +
                                              " radii of a ball"});
    return;
  }
  if (!physics::faults_of(scene, rules::rack_eight_ball(scene, {}, 0)).empty()) {
    faults.push_back({"scene.bed", "has no room for a rack; it must be longer or wider"});
  }
}

}  // namespace

std::vector<Fault> faults_of(const Settings& settings) {
  std::vector<Fault> faults = physics::faults_of(settings.scene);
  if (faults.empty()) check_table(faults, settings.scene);
  switch (settings.game) {
    case GameKind::eight_ball:
      check_number(faults, "seats", settings.seats, 2, 2);
      check_number(faults, "race_to", settings.race_to, 1, max_race_to);
      return faults;
    case GameKind::practice:
      check_number(faults, "seats", settings.seats, 1, max_practice_seats);
      check_number(faults, "race_to", settings.race_to, 1, 1);
      return faults;
  }
  faults.push_back({"game", "is unknown; it must be eight_ball or practice"});
  return faults;
}

}  // namespace breakshot::match
