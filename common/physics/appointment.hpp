// The next event of one ball that takes no other ball: the end of its phase, a cushion, a hole.
#pragma once

#include <cstdint>

#include "common/physics/noses.hpp"
#include "common/physics/pair_detector.hpp"

namespace breakshot::physics {

enum class Due : std::uint8_t { nothing, phase_end, cushion, hole, ball };

/// The next event of one ball.
template <class Real>
struct Appointment {
  Real time_s = never<Real>;
  Due due = Due::nothing;
  std::uint32_t with = 0;  ///< the nose, counting arcs after them, the hole or the other ball
};

/// Which of two next events of a ball holds: the earlier; at one instant, one that takes no other
/// ball, and of two meetings the one with the lower ball. So an appointment does not depend on the
/// order in which pairs are looked at.
template <class Real>
bool comes_first(const Appointment<Real>& a, const Appointment<Real>& b) {
  if (a.time_s != b.time_s) return a.time_s < b.time_s;
  return a.due == Due::ball && b.due == Due::ball && a.with < b.with;
}

/// Finds it. Most balls of a table with jaws never come near them: as long as a ball is between the
/// lines of the noses, the six cushions are all there is.
template <class Real>
class OwnEvents {
 public:
  OwnEvents(const Laws<Real>& laws, Real top_speed)
      : laws_(laws),
        top_speed_(top_speed),
        walls_(laws.walls, laws.walls.size(), laws.radius, top_speed),
        main_noses_(laws.noses, laws.walls.empty() ? 0 : main_noses, laws.radius, top_speed),
        noses_(laws.noses, laws.noses.size(), laws.radius, top_speed) {}

  /// The next such event of a path; of what comes after `until_s` nothing is said. Else that makes
  /// no difference: what touches a nose is met at once, or not, whenever it is asked.
  template <PathLike Mover>
  Appointment<Real> next(const Mover& path, Real until_s = never<Real>) const {
    Appointment<Real> first;
    if (path.end_s < never<Real>) first = {path.end_s, Due::phase_end, 0};
    if (stays(path)) return first;
    if (stays_inside(path, smaller(until_s, first.time_s))) return first;
    if (!main_noses_.empty() && laws_.is_inside(path.segment.position)) {
      const Real leaves = walls_.first(path, first.time_s).time_s;
      if (leaves == first.time_s) return first;
      const Appointment<Real> cushion = first_nose(path, main_noses_, first);
      if (cushion.time_s <= leaves) return cushion;
    }
    return first_circle(path, first_nose(path, noses_, first));
  }

 private:
  static constexpr std::size_t main_noses = 6;

  /// Whether the ball of a path certainly comes to no rail by `until_s`.
  template <PathLike Mover>
  bool stays_inside(const Mover& path, Real until_s) const {
    if (!laws_.inside) return false;
    const auto& s = path.segment;
    const Real span = until_s - s.start_s;
    const Real gained =
        path.curved ? (magnitude(s.acceleration.x) + magnitude(s.acceleration.y)) * span / 2 : 0;
    const Real reach = Real(never_farther) * (path.speed + gained) * span;
    // What touches by rounding is not inside.
    const Real coordinate = larger(laws_.diameter, larger(laws_.inside->x, laws_.inside->y));
    return laws_.is_inside(s.position,
                           reach + touch_gap_bound(2 * coordinate, 2 * path.speed, s.start_s));
  }

  template <PathLike Mover>
  static Appointment<Real> first_nose(const Mover& path, const Noses<Real>& noses,
                                      const Appointment<Real>& first) {
    const auto [time_s, nose] = noses.first(path, first.time_s);
    return time_s < first.time_s ? Appointment<Real>{time_s, Due::cushion, nose} : first;
  }

  template <PathLike Mover>
  Appointment<Real> first_circle(const Mover& path, Appointment<Real> first) const {
    if (plain_engine) return first;
    for (std::uint32_t i = 0; i < laws_.arcs.size(); ++i) {
      const Arc<Real>& arc = laws_.arcs[i];
      if (stays_away(path, arc.centre, arc.distance, first.time_s)) continue;
      const Real t = arc_time(path, arc, laws_.finder);
      if (t < first.time_s) first = {t, Due::cushion, laws_.cushion_of_arc(i)};
    }
    for (std::uint32_t i = 0; i < laws_.drops.size(); ++i) {
      const Drop<Real>& drop = laws_.drops[i];
      if (stays_away(path, drop.centre, drop.radius, first.time_s)) continue;
      const Real t = drop_time(path, drop, laws_.finder);
      if (t < first.time_s) first = {t, Due::hole, i};
    }
    return first;
  }

  template <PathLike Mover>
  bool stays_away(const Mover& path, const Path<Real>& centre, Real distance, Real until_s) const {
    const auto& s = path.segment;
    const Real span = smaller(until_s - s.start_s, Real(longest_span_s<Real>));
    return PairDetector<Real>(distance, top_speed_, laws_.finder)
               .separation(centre.segment.position - s.position, -s.velocity, -s.acceleration,
                           span) > 0;
  }

  const Laws<Real>& laws_;
  Real top_speed_;
  Noses<Real> walls_;
  Noses<Real> main_noses_;
  Noses<Real> noses_;
};

}  // namespace breakshot::physics
