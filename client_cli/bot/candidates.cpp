#include "client_cli/bot/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "client_cli/bot/prospect.hpp"
#include "common/physics/angle.hpp"
#include "common/physics/table.hpp"
#include "common/rules/groups.hpp"
#include "common/rules/placement.hpp"

namespace breakshot::bot {
namespace {

using Candidates = std::vector<Candidate>;

constexpr std::array pot_speeds_m_s = {1.6, 2.4, 1.0, 3.6, 5.0};
constexpr std::array bank_speeds_m_s = {2.4, 3.6, 5.0};
constexpr std::array kick_speeds_m_s = {2.0, 3.2};
constexpr std::array safety_speeds_m_s = {1.2, 0.7, 2.0};
constexpr std::array break_speeds_m_s = {9.0, 7.5, 10.5};
/// How far beside the middle a hit is aimed, in ball diameters, by thickness.
constexpr std::array thicknesses = {0.0, 0.45, -0.45, 0.85, -0.85};
/// Pots with the ball in hand are tried for this many of the best lanes.
constexpr std::size_t lanes_tried = 6;
constexpr int fan_directions = 24;

/// What a shot of each family needs to know about the position.
struct Try {
  const Position& position;
  std::optional<Vec2> place;
  physics::State table;  ///< with the cue ball placed
  Vec2 cue;
  double radius;
  Candidates& out;

  Try(const Position& p, std::optional<Vec2> at, Candidates& o)
      : position(p),
        place(at),
        table(at ? rules::with_ball(p.table, rules::cue_ball, *at) : p.table),
        out(o) {
    cue = rules::find(table, rules::cue_ball)->position;
    radius = p.scene.ball.radius_m;
  }

  template <class Speeds>
  void add(Vec2 direction, const Speeds& speeds, const rules::Call& intended) const {
    for (const double speed : speeds) out.push_back({place, direction, speed, intended});
  }

  bool sees(Vec2 place_m, BallId id) const {
    return corridor_free(table, radius, cue, place_m, rules::cue_ball, id);
  }
};

rules::Call pocketing(BallId ball, PocketId pocket) {
  return {ball, pocket, false};
}

rules::Call safety() {
  return {std::nullopt, std::nullopt, true};
}

/// Whether the cue ball may be played from where it lies; without a hand on it, always.
bool may_stay(const Position& position) {
  const Vec2 place = rules::find(position.table, rules::cue_ball)->position;
  return rules::may_play_from(position.scene.bed, position.status.ball_in_hand, place);
}

/// From behind the head string at the apex ball, full and a little to either side.
void add_breaks(const Position& position, Candidates& out) {
  const Vec2 spot = physics::head_spot(position.scene.bed);
  const Vec2 apex = physics::foot_spot(position.scene.bed);
  const double radius = position.scene.ball.radius_m;
  std::vector<std::optional<Vec2>> places;
  if (may_stay(position)) places.emplace_back(std::nullopt);
  if (position.status.ball_in_hand != rules::BallInHand::none) {
    for (const double side : {0.0, 6.0, -6.0}) {
      const Vec2 place = spot + Vec2{-2 * radius, side * radius};
      if (can_place(position, place)) places.emplace_back(place);
    }
  }
  for (const auto& place : places) {
    const Try shot(position, place, out);
    for (const double aside : {0.0, 0.1, -0.1, 0.25, -0.25}) {
      const Vec2 point = apex + Vec2{0, aside * 2 * radius};
      shot.add(towards(shot.cue, point), break_speeds_m_s, {});
    }
  }
}

/// One pot, aimed at three places of the gate: each leaves the cue ball somewhere else.
void add_pot(const Try& shot, const Pot& pot) {
  const Vec2 object = rules::find(shot.table, pot.ball)->position;
  const Gate gate = gates_of(shot.position.scene)[physics::number(pot.pocket)];
  for (const double part : {0.5, 0.25, 0.75}) {
    const Vec2 target = gate.from + (gate.to - gate.from) * part;
    const auto aim = aim_of(shot.cue, object, towards(object, target), shot.radius);
    if (!aim || !shot.sees(aim->ghost, pot.ball)) continue;
    shot.add(aim->direction, pot_speeds_m_s, pocketing(pot.ball, pot.pocket));
  }
}

/// The object ball by way of one cushion.
void add_banks(const Try& shot, const std::vector<BallId>& targets) {
  const auto gates = gates_of(shot.position.scene);
  const auto cushions = physics::segments_of(shot.position.scene);
  for (const BallId id : targets) {
    const Vec2 object = rules::find(shot.table, id)->position;
    for (std::size_t i = 0; i < gates.size(); ++i) {
      for (const auto& cushion : cushions) {
        const Vec2 image = image_in(cushion, shot.radius, gates[i].middle());
        const auto aim = aim_of(shot.cue, object, towards(object, image), shot.radius);
        if (!aim || aim->cut_cos < 0.5 || !shot.sees(aim->ghost, id)) continue;
        shot.add(aim->direction, bank_speeds_m_s, pocketing(id, static_cast<PocketId>(i)));
      }
    }
  }
}

/// Straight at each ball, full to thin, at speeds that leave the table much as it is.
void add_safeties(const Try& shot, const std::vector<BallId>& targets) {
  for (const double thickness : thicknesses) {
    for (const BallId id : targets) {
      const Vec2 object = rules::find(shot.table, id)->position;
      const Vec2 beside = physics::perp(towards(shot.cue, object)) * (thickness * 2 * shot.radius);
      if (!shot.sees(object + beside, id)) continue;
      shot.add(towards(shot.cue, object + beside), safety_speeds_m_s, safety());
    }
  }
}

/// The cue ball by way of one cushion, where nothing straight can be seen.
void add_kicks(const Try& shot, const std::vector<BallId>& targets) {
  for (const double thickness : {0.0, 0.4, -0.4}) {
    for (const BallId id : targets) {
      const Vec2 object = rules::find(shot.table, id)->position;
      for (const auto& cushion : physics::segments_of(shot.position.scene)) {
        const Vec2 image = image_in(cushion, shot.radius, object);
        const Vec2 beside = physics::perp(towards(shot.cue, image)) * (thickness * 2 * shot.radius);
        shot.add(towards(shot.cue, image + beside), kick_speeds_m_s, safety());
      }
    }
  }
}

void add_fan(const Try& shot) {
  for (int i = 0; i < fan_directions; ++i) {
    shot.add(physics::direction_of(2 * physics::pi * i / fan_directions), kick_speeds_m_s,
             safety());
  }
}

/// Behind the ball on its way to the pocket, near and far, straight and with an angle either way.
void add_in_hand(const Position& position, Candidates& out) {
  auto lanes = lanes_of(position);
  if (lanes.size() > lanes_tried) lanes.resize(lanes_tried);
  const double radius = position.scene.ball.radius_m;
  for (const Pot& lane : lanes) {
    const Vec2 object = rules::find(position.table, lane.ball)->position;
    const Vec2 way = towards(object, lane.target);
    const Vec2 ghost = object - way * (2 * radius);
    for (const double aside : {0.0, 0.4, -0.4, 1.0, -1.0}) {
      const Vec2 back = towards({0, 0}, physics::perp(way) * aside - way);
      for (const double distance : {0.15, 0.35, 0.7, 1.2}) {
        const Vec2 place = ghost + back * distance;
        if (!can_place(position, place)) continue;
        const Try shot(position, place, out);
        const auto aim = aim_of(place, object, way, radius);
        if (!aim || !shot.sees(aim->ghost, lane.ball)) continue;
        shot.add(aim->direction, std::array{1.6, 2.6}, pocketing(lane.ball, lane.pocket));
      }
    }
  }
}

/// A place for a ball in hand from which the shots without a plan of their own are tried.
std::optional<Vec2> spare_place(const Position& position) {
  const Vec2 spot = physics::head_spot(position.scene.bed);
  const double radius = position.scene.ball.radius_m;
  for (int back = 2; back <= 10; back += 4) {
    for (const int side : {0, 4, -4, 8, -8, 12, -12}) {
      const Vec2 place = spot + Vec2{-back * radius, side * radius};
      if (can_place(position, place)) return place;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<Candidate> candidates_of(const Position& position, std::size_t count) {
  Candidates out;
  const bool in_hand = position.status.ball_in_hand != rules::BallInHand::none;
  const auto targets = targets_of(position);
  if (position.status.breaking) {
    add_breaks(position, out);
  } else {
    if (in_hand) add_in_hand(position, out);
    const Try shot(position, may_stay(position) ? std::nullopt : spare_place(position), out);
    Position placed = position;
    placed.table = shot.table;
    for (const Pot& pot : pots_of(placed)) add_pot(shot, pot);
    add_safeties(shot, targets);
    add_banks(shot, targets);
    add_kicks(shot, targets);
    add_fan(shot);
  }
  if (out.size() > count) out.resize(count);
  return out;
}

}  // namespace breakshot::bot
