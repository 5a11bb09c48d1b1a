// What happened in a shot, as far as any game asks: facts read from events and segments, without a
// judgement.
#pragma once

#include <optional>
#include <vector>

#include "common/physics/event.hpp"
#include "common/physics/scene.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::rules {

/// A gap of at most this much before the shot counts as touching ("frozen"), m.
inline constexpr double frozen_gap_m = 1e-6;

struct Pocketed {
  physics::BallId ball{};
  physics::PocketId pocket{};
  double time_s = 0;

  friend bool operator==(const Pocketed&, const Pocketed&) = default;
};

struct Facts {
  std::optional<physics::BallId> first_hit;  ///< the first object ball that the cue ball hit
  std::vector<physics::BallId> first_hits;   ///< all that it hit at that instant, ascending
  std::vector<Pocketed> pocketed;            ///< in order
  bool cushion_after_contact = false;        ///< any ball, by the frozen-ball rules
  std::vector<physics::BallId>
      object_balls_to_cushion;  ///< ascending, frozen ones only if they left and came back
  /// The cue ball's centre crossed the head string before its first contact (or it had none).
  bool crossed_head_string_before_contact = false;
  /// The first ball hit lay on or beyond the head string before the shot.
  bool first_hit_beyond_head_string = false;

  friend bool operator==(const Facts&, const Facts&) = default;
};

Facts facts_of(const physics::Scene& scene, const physics::State& before,
               const physics::Shot& shot);

}  // namespace breakshot::rules
