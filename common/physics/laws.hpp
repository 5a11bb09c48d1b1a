// A scene read once into what the simulation needs: the numbers of its phenomena in the scalar of
// the simulation, one value for each phenomenon that is present.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "common/physics/cloth.hpp"
#include "common/physics/rails.hpp"
#include "common/physics/version.hpp"

namespace breakshot::physics {

/// Restitution along a contact's normal. Approaches slower than `elastic_below` separate at
/// max(e s, min(s, elastic_below)), which is never asked of elastic contacts: e = 1, elastic_below
/// = 0.
template <class Real>
struct Bounce {
  Real restitution = 1;
  Real elastic_below_m_s = 0;

  /// The restitution of an approach at speed s > 0.
  Real at(Real s) const {
    // Most approaches are far too fast to be weak, and need no division to show it.
    if (restitution == 1 || 2 * elastic_below_m_s < restitution * s) return restitution;
    const Real soft = elastic_below_m_s < s ? elastic_below_m_s / s : Real(1);
    return soft > restitution ? soft : restitution;
  }
};

/// A contact that touches, hardly parts and would close again under the accelerations of its balls
/// rests on them: it separates at a speed of its own, which makes a bounded number of hops of a
/// push. With e < 1 that is elastic_below. Elastic contacts have none; where spin or friction can
/// push one ball against another for long they take the default of the others: else a push is an
/// endless run of ever the same tiny hop.
/// "Hardly" is this share of that speed: without spin, and with it, where pushes last.
inline constexpr double resting_share = 1e-3;
inline constexpr double resting_share_with_spin = 0.5;

/// What happens across the normal of a contact.
enum class Touch : std::uint8_t {
  smooth,      ///< nothing, or a share of the tangential velocity is lost
  rubs,        ///< one impulse of Coulomb friction: Han 2005, Alciatore's throw
  integrated,  ///< a model of the whole contact: Mathavan 2010 and 2014
  compliant,   ///< Stronge 2000
};

/// What a cushion does to a ball.
template <class Real>
struct NoseResponse {
  CushionId id{};
  Bounce<Real> bounce;
  Touch touch = Touch::smooth;
  Real tangential = 1;  ///< of a smooth nose
  NoseLaw<Real> law;    ///< of the others
};

/// A straight nose with its frame.
template <class Real>
struct Nose {
  BasicVec2<Real> from;
  BasicVec2<Real> along;   ///< unit vector
  BasicVec2<Real> inward;  ///< unit normal towards the playing side
  Real extent{};           ///< m
};

/// A rounded nose, as balls meet it.
template <class Real>
struct Arc {
  Path<Real> centre;     ///< one that rests
  Real distance{};       ///< of the centre of a ball that touches, m
  BasicVec2<Real> from;  ///< unit vectors
  BasicVec2<Real> to;
};

/// A hole's edge, as the centres of balls meet it.
template <class Real>
struct Drop {
  PocketId pocket{};
  Path<Real> centre;  ///< one that rests
  Real radius{};      ///< m
};

/// What balls do to one another.
template <class Real>
struct PairResponse {
  Bounce<Real> bounce;
  Touch touch = Touch::smooth;
  PairLaw<Real> law;
};

template <class Real>
struct PocketMouths {
  Real corner_from_corner{};  ///< nearer to the corner than this, along the cushion, m
  Real side_from_middle{};    ///< nearer to the middle of a long cushion than this, m
};

template <class Real>
struct Laws {
  explicit Laws(const Scene& scene, std::uint32_t physics = physics_version);

  /// The pocket that takes a ball which meets `nose` with its centre at `position`, if any: of
  /// standard pockets.
  std::optional<PocketId> pocket_at(std::size_t nose, BasicVec2<Real> position) const;
  /// Whether a ball at `position` is between the lines of a rectangle's noses, by `margin`.
  bool is_inside(BasicVec2<Real> position, Real margin = 0) const {
    return inside && position.x <= inside->x - margin && position.x >= margin - inside->x &&
           position.y <= inside->y - margin && position.y >= margin - inside->y;
  }
  /// Whether any contact does something across its normal.
  bool rubs() const {
    return (ball_ball && ball_ball->touch != Touch::smooth) ||
           std::any_of(responses.begin(), responses.end(),
                       [](const NoseResponse<Real>& nose) { return nose.touch != Touch::smooth; });
  }
  /// Whether normals are perturbed.
  bool perturbs() const { return perturb_balls > 0 || perturb_cushions > 0; }
  /// The speed at which a resting contact separates; 0 if it never rests.
  Real hop_of(const Bounce<Real>& bounce) const {
    return bounce.restitution == 1 ? elastic_hop_m_s : bounce.elastic_below_m_s;
  }
  /// The place of an arc among all cushions: after the straight ones.
  std::uint32_t cushion_of_arc(std::size_t arc) const {
    return static_cast<std::uint32_t>(noses.size() + arc);
  }

  EntryFinder finder;
  Real radius{};
  Real diameter{};
  Cloth<Real> cloth;
  std::vector<Nose<Real>> noses;
  std::vector<Arc<Real>> arcs;
  std::vector<NoseResponse<Real>> responses;  ///< of noses, then of arcs
  std::vector<Drop<Real>> drops;
  std::vector<Nose<Real>> walls;  ///< with jaws: the lines of the noses, from corner to corner
  std::optional<BasicVec2<Real>> inside;  ///< half the sides of a rectangle clear of all rails
  std::optional<PocketMouths<Real>> mouths;
  BasicVec2<Real> half_bed;  ///< of a rectangle
  std::optional<PairResponse<Real>> ball_ball;
  Real elastic_hop_m_s{};  ///< 0 where elastic contacts do not rest
  Real resting_share{};
  double perturb_balls = 0;
  double perturb_cushions = 0;
};

/// Restitution 1 leaves nothing to be weak about.
template <class Real>
Bounce<Real> bounce_of(double restitution, double elastic_below_m_s) {
  if (restitution == 1) return {};
  return {Real(restitution), Real(elastic_below_m_s)};
}

/// The sliding friction of a scene's cloth.
template <class Real>
Real cloth_friction_of(const Scene& scene) {
  const auto* spinning = std::get_if<Spinning>(&scene.bed.motion);
  return spinning == nullptr ? Real(0) : Real(spinning->sliding_friction);
}

template <class Real>
struct PairReader {
  const Scene& scene;

  PairResponse<Real> operator()(const Elastic&) const { return {}; }
  PairResponse<Real> operator()(const BallRestitution& m) const {
    return {bounce_of<Real>(m.normal, m.elastic_below_m_s), Touch::smooth, {}};
  }
  PairResponse<Real> operator()(const BallFriction& m) const {
    return {bounce_of<Real>(m.restitution, m.elastic_below_m_s), Touch::rubs,
            law(m.a, m.b, m.c_s_m)};
  }
  PairResponse<Real> operator()(const Mathavan2014& m) const {
    return {bounce_of<Real>(m.restitution, m.elastic_below_m_s), Touch::integrated,
            law(m.friction, 0, 0)};
  }

  PairLaw<Real> law(double a, double b, double c) const {
    return {Real(scene.ball.radius_m), Real(a), Real(b), Real(c), cloth_friction_of<Real>(scene)};
  }
};

template <class Real>
struct NoseReader {
  const Scene& scene;
  CushionId id;

  NoseResponse<Real> operator()(const Mirror&) const { return {id, {}, Touch::smooth, 1, {}}; }
  NoseResponse<Real> operator()(const CushionRestitution& m) const {
    return {
        id, bounce_of<Real>(m.normal, m.elastic_below_m_s), Touch::smooth, Real(m.tangential), {}};
  }
  NoseResponse<Real> operator()(const Han2005& m) const { return of(m, Touch::rubs, 0); }
  NoseResponse<Real> operator()(const Mathavan2010& m) const { return of(m, Touch::integrated, 0); }
  NoseResponse<Real> operator()(const Stronge2000& m) const {
    return of(m, Touch::compliant, m.frequency_ratio);
  }

  NoseResponse<Real> of(const auto& m, Touch touch, double frequency_ratio) const {
    return {id,
            bounce_of<Real>(m.restitution, default_elastic_below_m_s),
            touch,
            1,
            {Real(scene.ball.radius_m), Real(m.height_m), Real(m.friction),
             cloth_friction_of<Real>(scene), Real(frequency_ratio)}};
  }
};

template <class Real>
BasicVec2<Real> vec_of(Vec2 v) {
  return {Real(v.x), Real(v.y)};
}

template <class Real>
Nose<Real> nose_of(const CushionSegment& segment) {
  Nose<Real> nose;
  nose.from = vec_of<Real>(segment.from);
  const BasicVec2<Real> whole = vec_of<Real>(segment.to) - nose.from;
  nose.extent = length(whole);
  nose.along = whole / nose.extent;
  nose.inward = perp(nose.along);
  return nose;
}

template <class Real>
Path<Real> fixed_at(Vec2 place) {
  Path<Real> path;
  path.segment.position = vec_of<Real>(place);
  return path;
}

template <class Real>
Laws<Real>::Laws(const Scene& scene, std::uint32_t physics)
    : finder(finder_of(physics)),
      radius(Real(scene.ball.radius_m)),
      diameter(2 * Real(scene.ball.radius_m)),
      cloth(scene) {
  using std::sqrt;
  const Rails rails = rails_of(scene);
  noses.reserve(rails.segments.size());
  arcs.reserve(rails.arcs.size());
  responses.reserve(rails.segments.size() + rails.arcs.size());
  drops.reserve(rails.holes.size());
  for (const RailSegment& rail : rails.segments) {
    noses.push_back(nose_of<Real>(rail.nose));
    responses.push_back(std::visit(NoseReader<Real>{scene, rail.id}, rail.nose.model));
  }
  for (const RailArc& rail : rails.arcs) {
    arcs.push_back({fixed_at<Real>(rail.nose.centre), radius + Real(rail.nose.radius_m),
                    vec_of<Real>(rail.nose.from), vec_of<Real>(rail.nose.to)});
    responses.push_back(std::visit(NoseReader<Real>{scene, rail.id}, rail.nose.model));
  }
  for (const Hole& hole : rails.holes) {
    drops.push_back({hole.pocket, fixed_at<Real>(hole.centre), Real(hole.radius_m)});
  }
  if (!drops.empty()) {
    walls.reserve(4);
    for (const CushionSegment& wall : segments_of(scene)) walls.push_back(nose_of<Real>(wall));
  }
  if (rails.inside) inside = vec_of<Real>(*rails.inside) - BasicVec2<Real>{radius, radius};
  if (const auto* standard =
          scene.pockets ? std::get_if<StandardPockets>(&*scene.pockets) : nullptr) {
    mouths = {Real(standard->corner_mouth_m) / sqrt(Real(2)), Real(standard->side_mouth_m) / 2};
    half_bed = {Real(*scene.bed.length_m) / 2, Real(*scene.bed.width_m) / 2};
  }
  if (scene.ball_ball) ball_ball = std::visit(PairReader<Real>{scene}, *scene.ball_ball);
  resting_share = Real(cloth.spins() ? resting_share_with_spin : physics::resting_share);
  if (scene.perturbation) {
    perturb_balls = scene.perturbation->ball;
    perturb_cushions = scene.perturbation->cushion;
  }
  const bool may_rest = perturb_balls == 0 || turned_contacts_rest(physics);
  const bool pushes = cloth.spins() || rubs() || (cloth.slows() && may_rest);
  if (pushes) elastic_hop_m_s = Real(default_elastic_below_m_s);
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
