// The laws of one scene in the form in which the loop uses them: constants in the scalar of the
// simulation, one value for each phenomenon that is present.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "common/physics/scene.hpp"
#include "common/physics/segment.hpp"

namespace breakshot::physics {

template <class Real>
constexpr Real never = std::numeric_limits<Real>::infinity();

/// Restitution along a contact's normal. Approaches slower than `elastic_below` separate at
/// max(e s, min(s, elastic_below)), which is never asked of elastic contacts: e = 1, elastic_below
/// = 0.
template <class Real>
struct Bounce {
  Real restitution = 1;
  Real elastic_below_m_s = 0;

  /// The restitution of an approach at speed s > 0.
  Real at(Real s) const {
    if (restitution == 1) return restitution;
    const Real soft = elastic_below_m_s < s ? elastic_below_m_s / s : Real(1);
    return soft > restitution ? soft : restitution;
  }
};

/// A straight nose with its frame.
template <class Real>
struct Nose {
  BasicVec2<Real> from;
  BasicVec2<Real> along;   ///< unit vector
  BasicVec2<Real> inward;  ///< unit normal towards the playing side
  Real extent{};           ///< m
  Bounce<Real> bounce;
  Real tangential = 1;
};

/// A ball's motion from an instant on, and when its phase ends.
template <class Real>
struct Path {
  BasicSegment<Real> segment;
  Real speed{};              ///< at start, m/s
  Real end_s = never<Real>;  ///< of the phase
};

template <class Real>
struct PocketMouths {
  Real corner_from_corner{};  ///< nearer to the corner than this, along the cushion, m
  Real side_from_middle{};    ///< nearer to the middle of a long cushion than this, m
};

template <class Real>
struct Laws {
  explicit Laws(const Scene& scene);

  /// The path of a ball that leaves `position` with `velocity` at `time_s`.
  Path<Real> path_from(BallId ball, Real time_s, BasicVec2<Real> position,
                       BasicVec2<Real> velocity) const;
  /// The path after the end of a phase: slides become rolls, rolls end in rest.
  Path<Real> path_after(const Path<Real>& ended) const;
  /// The deceleration vector of a ball with this velocity.
  BasicVec2<Real> acceleration_of(BasicVec2<Real> velocity) const;
  /// The pocket that takes a ball which meets `nose` with its centre at `position`, if any.
  std::optional<PocketId> pocket_at(std::size_t nose, BasicVec2<Real> position) const;

  Real radius{};
  Real diameter{};
  Real slide_deceleration{};  ///< m/s^2; both 0 without friction
  Real roll_deceleration{};
  Real rolling_below{};  ///< m/s
  bool friction = false;
  std::vector<Nose<Real>> noses;
  std::optional<PocketMouths<Real>> mouths;
  BasicVec2<Real> half_bed;  ///< of a rectangle
  std::optional<Bounce<Real>> ball_ball;
  double perturb_balls = 0;
  double perturb_cushions = 0;

 private:
  Path<Real> rolling(BallId ball, Real time_s, BasicVec2<Real> position, BasicVec2<Real> direction,
                     Real speed) const;
};

/// Restitution 1 leaves nothing to be weak about.
template <class Real>
Bounce<Real> bounce_of(double restitution, double elastic_below_m_s) {
  if (restitution == 1) return {};
  return {Real(restitution), Real(elastic_below_m_s)};
}

template <class Real>
Bounce<Real> bounce_of(const BallBallModel& model) {
  const auto* restitution = std::get_if<BallRestitution>(&model);
  return restitution == nullptr
             ? Bounce<Real>{}
             : bounce_of<Real>(restitution->normal, restitution->elastic_below_m_s);
}

template <class Real>
Nose<Real> nose_of(const CushionSegment& segment) {
  Nose<Real> nose;
  nose.from = {Real(segment.from.x), Real(segment.from.y)};
  const BasicVec2<Real> whole = BasicVec2<Real>{Real(segment.to.x), Real(segment.to.y)} - nose.from;
  nose.extent = length(whole);
  nose.along = whole / nose.extent;
  nose.inward = perp(nose.along);
  if (const auto* restitution = std::get_if<CushionRestitution>(&segment.model)) {
    nose.bounce = bounce_of<Real>(restitution->normal, restitution->elastic_below_m_s);
    nose.tangential = Real(restitution->tangential);
  }
  return nose;
}

template <class Real>
Laws<Real>::Laws(const Scene& scene)
    : radius(scene.ball.radius_m), diameter(2 * Real(scene.ball.radius_m)) {
  using std::sqrt;
  if (const auto* straight = std::get_if<Straight>(&scene.bed.motion)) {
    friction = true;
    slide_deceleration = Real(straight->sliding_friction) * Real(*scene.gravity_m_s2);
    roll_deceleration = Real(straight->rolling_friction) * Real(*scene.gravity_m_s2);
    rolling_below = Real(straight->rolling_below_m_s);
  }
  for (const CushionSegment& segment : segments_of(scene)) noses.push_back(nose_of<Real>(segment));
  if (scene.pockets) {
    mouths = {Real(scene.pockets->corner_mouth_m) / sqrt(Real(2)),
              Real(scene.pockets->side_mouth_m) / 2};
    half_bed = {Real(*scene.bed.length_m) / 2, Real(*scene.bed.width_m) / 2};
  }
  if (scene.ball_ball) ball_ball = bounce_of<Real>(*scene.ball_ball);
  if (scene.perturbation) {
    perturb_balls = scene.perturbation->ball;
    perturb_cushions = scene.perturbation->cushion;
  }
}

template <class Real>
Path<Real> Laws<Real>::rolling(BallId ball, Real time_s, BasicVec2<Real> position,
                               BasicVec2<Real> direction, Real speed) const {
  Path<Real> path;
  path.segment = {ball,     Phase::roll,       time_s,
                  position, direction * speed, direction * -roll_deceleration};
  path.speed = speed;
  if (roll_deceleration > 0) path.end_s = time_s + speed / roll_deceleration;
  return path;
}

template <class Real>
Path<Real> Laws<Real>::path_from(BallId ball, Real time_s, BasicVec2<Real> position,
                                 BasicVec2<Real> velocity) const {
  const Real speed = length(velocity);
  Path<Real> path;
  path.segment = {ball, Phase::rest, time_s, position, velocity, {}};
  path.speed = speed;
  if (speed == 0) return path;
  path.segment.phase = Phase::roll;
  if (!friction) return path;
  const BasicVec2<Real> direction = velocity / speed;
  const bool slides = speed > rolling_below;
  const Real deceleration = slides ? slide_deceleration : roll_deceleration;
  if (slides) path.segment.phase = Phase::slide;
  path.segment.acceleration = direction * -deceleration;
  if (deceleration > 0) {
    path.end_s = time_s + (slides ? speed - rolling_below : speed) / deceleration;
  }
  return path;
}

template <class Real>
Path<Real> Laws<Real>::path_after(const Path<Real>& ended) const {
  const BasicSegment<Real>& s = ended.segment;
  const BasicVec2<Real> position = position_at(s, ended.end_s);
  if (s.phase == Phase::slide && rolling_below > 0) {
    return rolling(s.ball, ended.end_s, position, s.velocity / ended.speed, rolling_below);
  }
  Path<Real> rest;
  rest.segment = {s.ball, Phase::rest, ended.end_s, position, {}, {}};
  return rest;
}

template <class Real>
BasicVec2<Real> Laws<Real>::acceleration_of(BasicVec2<Real> velocity) const {
  const Real speed = length(velocity);
  if (!friction || speed == 0) return {};
  return velocity / speed * -(speed > rolling_below ? slide_deceleration : roll_deceleration);
}

template <class Real>
std::optional<PocketId> Laws<Real>::pocket_at(std::size_t nose, BasicVec2<Real> position) const {
  if (!mouths) return std::nullopt;
  const bool foot = position.x > 0;
  const bool left = position.y > 0;
  const bool long_cushion = nose == 1 || nose == 3;
  const Real along = long_cushion ? position.x : position.y;
  const Real middle_distance = along < 0 ? -along : along;
  const Real corner_distance = (long_cushion ? half_bed.x : half_bed.y) - middle_distance;
  if (corner_distance < mouths->corner_from_corner) {
    return PocketId(static_cast<std::uint8_t>(left ? (foot ? 3 : 5) : (foot ? 2 : 0)));
  }
  if (long_cushion && middle_distance < mouths->side_from_middle) {
    return PocketId(static_cast<std::uint8_t>(left ? 4 : 1));
  }
  return std::nullopt;
}

}  // namespace breakshot::physics
