// How balls move on the cloth between contacts. A ball whose point of contact slips at u = v + w x
// (0, 0, -R) slides with a = -mu_s g u/|u|; u keeps its direction, and is gone after
// 2 |u| / (7 mu_s g). Then it rolls with a = -mu_r g v/|v| for |v| / (mu_r g). Spin about the
// vertical decays at 5 mu_sp g / (2 R) all the while (Marlow 1995, "The Physics of Pocket
// Billiards"; Alciatore, "Pool and billiards physics principles", TP 4.1). Straight motion is the
// paper's: the speed alone says whether a ball slides or rolls, and there is no spin.
#pragma once

#include <concepts>
#include <optional>

#include "common/physics/impact.hpp"
#include "common/physics/phenomena.hpp"
#include "common/physics/scene.hpp"
#include "common/physics/segment.hpp"

namespace breakshot::physics {

template <class Real>
constexpr Real never = std::numeric_limits<Real>::infinity();

/// A speed that two velocities of these sizes cannot resolve.
template <class Real>
constexpr Real unresolved_speed(Real speeds) {
  return 2 * std::numeric_limits<Real>::epsilon() * speeds;
}

/// A ball's motion from an instant on, and when its phase ends.
template <class Real>
struct Path {
  BasicSegment<Real> segment;
  Real speed{};              ///< at start, m/s
  Real end_s = never<Real>;  ///< of the phase
  bool curved = false;       ///< or speeding up: not a straight path that only slows down
};

/// What detection asks of a path: a Path is one, and so is what has its parts elsewhere.
template <class P>
concept PathLike = requires(const P& path) {
  path.segment.start_s;
  path.segment.position;
  path.segment.velocity;
  path.segment.acceleration;
  path.speed;
  path.end_s;
  path.curved;
  { stays(path) } -> std::same_as<bool>;
};

template <class Real>
void copy_in_parts(const Path<Real>& from, Path<Real>& to) {
  copy_in_parts(from.segment, to.segment);
  to.speed = from.speed;
  to.end_s = from.end_s;
  to.curved = from.curved;
}

/// Whether the ball of a path does not change its place.
template <class Real>
bool stays(const Path<Real>& path) {
  return is_still(path.segment.phase);
}

template <class Real>
class Cloth {
 public:
  explicit Cloth(const Scene& scene) : radius_(Real(scene.ball.radius_m)) {
    const Real gravity = scene.gravity_m_s2 ? Real(*scene.gravity_m_s2) : Real(0);
    if (const auto* straight = std::get_if<Straight>(&scene.bed.motion)) {
      friction_ = true;
      slide_deceleration_ = Real(straight->sliding_friction) * gravity;
      roll_deceleration_ = Real(straight->rolling_friction) * gravity;
      rolling_below_ = Real(straight->rolling_below_m_s);
    } else if (const auto* spinning = std::get_if<Spinning>(&scene.bed.motion)) {
      friction_ = spins_ = true;
      slide_deceleration_ = Real(spinning->sliding_friction) * gravity;
      roll_deceleration_ = Real(spinning->rolling_friction) * gravity;
      spin_deceleration_ = 5 * Real(spinning->spin_friction) * gravity / (2 * radius_);
    }
  }

  /// Whether balls accelerate between events.
  bool slows() const { return friction_; }

  /// Whether balls have spin.
  bool spins() const { return !plain_engine && spins_; }

  /// The path of a ball that leaves `position` so at `time_s`.
  Path<Real> path_from(BallId ball, Real time_s, BasicVec2<Real> position,
                       const Moving<Real>& moving) const {
    return spins() ? spinning_from(ball, time_s, position, moving)
                   : straight_from(ball, time_s, position, moving.velocity);
  }

  /// The path after the end of a phase: slides become rolls, rolls end in rest or spin, spin in
  /// rest.
  Path<Real> path_after(const Path<Real>& ended) const {
    const BasicSegment<Real>& s = ended.segment;
    const BasicVec2<Real> position = position_at(s, ended.end_s);
    if (s.phase == Phase::slide && spins()) {
      const BasicVec2<Real> velocity = s.velocity - slip_of(s.velocity, s.spin) * (Real(2) / 7);
      const Real speed = length(velocity);
      if (speed > unresolved_speed(ended.speed)) {
        return rolling(s.ball, ended.end_s, position, velocity / speed, speed,
                       spin_at(s, ended.end_s).z);
      }
    } else if (s.phase == Phase::slide && rolling_below_ > 0) {
      return rolling(s.ball, ended.end_s, position, s.velocity / ended.speed, rolling_below_,
                     Real(0));
    }
    const bool spent = s.phase == Phase::spin;
    return standing(s.ball, ended.end_s, position, spent ? Real(0) : spin_at(s, ended.end_s).z);
  }

  /// The acceleration of a ball that moves so.
  BasicVec2<Real> acceleration_of(const Moving<Real>& moving) const {
    const Real speed = length(moving.velocity);
    if (spins()) {
      const BasicVec2<Real> slip = slip_of(moving.velocity, moving.spin);
      const Real slip_speed = length(slip);
      if (slip_speed > unresolved_slip(speed, moving.spin)) {
        return slip / slip_speed * -slide_deceleration_;
      }
      return speed > 0 ? moving.velocity / speed * -roll_deceleration_ : BasicVec2<Real>{};
    }
    if (!friction_ || speed == 0) return {};
    return moving.velocity / speed *
           -(speed > rolling_below_ ? slide_deceleration_ : roll_deceleration_);
  }

 private:
  /// The velocity of the point that touches the cloth.
  BasicVec2<Real> slip_of(BasicVec2<Real> velocity, BasicVec3<Real> spin) const {
    return {velocity.x - radius_ * spin.y, velocity.y + radius_ * spin.x};
  }

  /// Slip that rounding alone may have left to a ball that rolls.
  Real unresolved_slip(Real speed, BasicVec3<Real> spin) const {
    return 4 * unresolved_speed(speed + radius_ * length(BasicVec2<Real>{spin.x, spin.y}));
  }

  Real spin_decay(Real spin) const {
    if (spin == 0) return 0;
    return spin < 0 ? spin_deceleration_ : -spin_deceleration_;
  }

  Path<Real> straight_from(BallId ball, Real time_s, BasicVec2<Real> position,
                           BasicVec2<Real> velocity) const {
    const Real speed = length(velocity);
    if (speed == 0 || !friction_) {
      const Phase phase = speed == 0 ? Phase::rest : Phase::roll;
      return {{ball, phase, time_s, position, velocity, {}, {}, {}}, speed, never<Real>, false};
    }
    const bool slides = speed > rolling_below_;
    const Real deceleration = slides ? slide_deceleration_ : roll_deceleration_;
    const Real lost = slides ? speed - rolling_below_ : speed;
    return {{ball,
             slides ? Phase::slide : Phase::roll,
             time_s,
             position,
             velocity,
             velocity / speed * -deceleration,
             {},
             {}},
            speed,
            deceleration > 0 ? time_s + lost / deceleration : never<Real>,
            false};
  }

  Path<Real> spinning_from(BallId ball, Real time_s, BasicVec2<Real> position,
                           const Moving<Real>& moving) const {
    if (moving.velocity == BasicVec2<Real>{} && moving.spin.x == 0 && moving.spin.y == 0) {
      return standing(ball, time_s, position, moving.spin.z);
    }
    const BasicVec2<Real> slip = slip_of(moving.velocity, moving.spin);
    const Real slip_speed = length(slip);
    const Real speed = length(moving.velocity);
    if (!(slip_speed > unresolved_slip(speed, moving.spin))) {
      if (speed == 0) return standing(ball, time_s, position, moving.spin.z);
      return rolling(ball, time_s, position, moving.velocity / speed, speed, moving.spin.z);
    }
    Path<Real> path;
    const BasicVec2<Real> a = slip / slip_speed * -slide_deceleration_;
    const Real turning = 5 / (2 * radius_);
    path.segment = {ball,
                    Phase::slide,
                    time_s,
                    position,
                    moving.velocity,
                    a,
                    moving.spin,
                    {turning * a.y, -turning * a.x, spin_decay(moving.spin.z)}};
    path.speed = speed;
    path.curved = true;
    if (slide_deceleration_ > 0) path.end_s = time_s + 2 * slip_speed / (7 * slide_deceleration_);
    return path;
  }

  Path<Real> rolling(BallId ball, Real time_s, BasicVec2<Real> position, BasicVec2<Real> direction,
                     Real speed, Real vertical_spin) const {
    Path<Real> path;
    const BasicVec2<Real> velocity = direction * speed;
    const BasicVec2<Real> a = direction * -roll_deceleration_;
    path.segment = {ball, Phase::roll, time_s, position, velocity, a, {}, {}};
    if (spins()) {
      path.segment.spin = {-velocity.y / radius_, velocity.x / radius_, vertical_spin};
      path.segment.spin_change = {-a.y / radius_, a.x / radius_, spin_decay(vertical_spin)};
    }
    path.speed = speed;
    if (roll_deceleration_ > 0) path.end_s = time_s + speed / roll_deceleration_;
    return path;
  }

  /// A ball in one place: at rest, or spinning until it is.
  Path<Real> standing(BallId ball, Real time_s, BasicVec2<Real> position, Real spin) const {
    Path<Real> path;
    path.segment = {ball, Phase::rest, time_s, position, {}, {}, {}, {}};
    if (spin == 0) return path;
    path.segment.phase = Phase::spin;
    path.segment.spin.z = spin;
    path.segment.spin_change.z = spin_decay(spin);
    if (spin_deceleration_ > 0) {
      path.end_s = time_s + (spin < 0 ? -spin : spin) / spin_deceleration_;
    }
    return path;
  }

  Real radius_{};
  bool friction_ = false;
  bool spins_ = false;
  Real slide_deceleration_{};  ///< m/s^2; all 0 without friction
  Real roll_deceleration_{};
  Real rolling_below_{};      ///< m/s; straight motion
  Real spin_deceleration_{};  ///< rad/s^2
};

}  // namespace breakshot::physics
