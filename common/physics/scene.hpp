// A scene: which phenomena are present, and with which parameters. What is not listed is absent,
// costs nothing and appears in no event. Validation names every bad field.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/physics/ball.hpp"

namespace breakshot::physics {

/// The approach speed below which a contact with e < 1 is elastic, so that a ball pushed along by
/// another makes a bounded number of tiny hops (design section 2, "weak contacts"), m/s.
inline constexpr double default_elastic_below_m_s = 1e-3;

// ---- Motion on the bed

/// Balls keep their velocity.
struct Frictionless {
  friend bool operator==(const Frictionless&, const Frictionless&) = default;
};

/// The paper's sections 3.3 and 3.4: straight paths; kinetic friction while the ball is faster than
/// `rolling_below_m_s`, rolling resistance below. Deceleration is coefficient times gravity.
struct Straight {
  double sliding_friction = 0.2;   ///< 0 or [1e-300, 10]
  double rolling_friction = 0.01;  ///< 0 or [1e-300, 10]
  double rolling_below_m_s = 1.0;  ///< [0, 1e4]

  friend bool operator==(const Straight&, const Straight&) = default;
};

/// Slip-dependent motion of a spinning ball: sliding on a curved path while the point of contact
/// slips, then rolling, then spinning in place; spin about the vertical axis decays all the while.
/// Sources and equations: cloth.hpp.
struct Spinning {
  double sliding_friction = 0.2;   ///< 0 or [1e-300, 10]
  double rolling_friction = 0.01;  ///< 0 or [1e-300, 10]
  double spin_friction = 0.0127;   ///< of the vertical axis: 0 or [1e-300, 10]

  friend bool operator==(const Spinning&, const Spinning&) = default;
};

using Motion = std::variant<Frictionless, Straight, Spinning>;

struct Bed {
  Motion motion;
  std::optional<double> length_m;  ///< along x, between cushion noses; [2R, 1e4]
  std::optional<double> width_m;   ///< along y, between cushion noses; [2R, 1e4]

  friend bool operator==(const Bed&, const Bed&) = default;
};

// ---- Cushions

/// The paper's reflection R = v - 2 n (v . n).
struct Mirror {
  friend bool operator==(const Mirror&, const Mirror&) = default;
};

/// v_n' = -normal v_n, v_t' = tangential v_t.
struct CushionRestitution {
  double normal = 0.85;                                  ///< [0, 1]
  double tangential = 1.0;                               ///< [0, 1]
  double elastic_below_m_s = default_elastic_below_m_s;  ///< [0, 1]

  friend bool operator==(const CushionRestitution&, const CushionRestitution&) = default;
};

/// Restitution and Coulomb friction at a nose above the ball's centre, as one impulse (Han 2005).
/// Equations: han2005.hpp.
struct Han2005 {
  double restitution = 0.85;  ///< [0, 1]
  double friction = 0.2;      ///< of ball and nose, [0, 10]
  double height_m = 0.0357;   ///< of the nose above the bed, [R, 2R)

  friend bool operator==(const Han2005&, const Han2005&) = default;
};

/// The same contact integrated over the impulse, with friction at nose and cloth (Mathavan, Jackson
/// and Parkin 2010). Equations: mathavan2010.hpp.
struct Mathavan2010 {
  double restitution = 0.98;  ///< [0, 1]; of the energy, across the height of the nose
  double friction = 0.14;     ///< of ball and nose, [0, 10]
  double height_m = 0.0357;   ///< of the nose above the bed, [R, 2R)

  friend bool operator==(const Mathavan2010&, const Mathavan2010&) = default;
};

/// A nose that gives way along and across its normal (Stronge 2000). Equations: stronge2000.hpp.
struct Stronge2000 {
  double restitution = 0.85;     ///< [0, 1]
  double friction = 0.2;         ///< of ball and nose, [0, 10]
  double height_m = 0.0357;      ///< of the nose above the bed, [R, 2R)
  double frequency_ratio = 1.8;  ///< of tangential to normal vibration, [1, 10]

  friend bool operator==(const Stronge2000&, const Stronge2000&) = default;
};

using CushionModel = std::variant<Mirror, CushionRestitution, Han2005, Mathavan2010, Stronge2000>;

/// A straight cushion nose. The playing side is to the left of from -> to.
struct CushionSegment {
  Vec2 from;  ///< m
  Vec2 to;    ///< m
  CushionModel model;

  friend bool operator==(const CushionSegment&, const CushionSegment&) = default;
};

/// A convex nose: the part of a circle from one direction, counter-clockwise, to another.
struct CushionArc {
  Vec2 centre;      ///< m
  double radius_m;  ///< (0, 10]
  Vec2 from;        ///< unit vector from the centre
  Vec2 to;          ///< unit vector from the centre, less than half a turn after `from`
  CushionModel model;

  friend bool operator==(const CushionArc&, const CushionArc&) = default;
};

/// Four cushions round the bed: 0 foot, 1 left, 2 head, 3 right.
struct RectangleCushions {
  CushionModel model;

  friend bool operator==(const RectangleCushions&, const RectangleCushions&) = default;
};

struct FreeCushions {
  std::vector<CushionSegment> segments;
  std::vector<CushionArc> arcs{};

  friend bool operator==(const FreeCushions&, const FreeCushions&) = default;
};

using Cushions = std::variant<RectangleCushions, FreeCushions>;

// ---- Pockets

/// The paper's pockets: a cushion contact nearer than corner_mouth / sqrt(2) to a corner, or within
/// side_mouth / 2 of the middle of a long cushion, drops the ball. Needs rectangle cushions.
struct StandardPockets {
  double corner_mouth_m = 0.1158875;  ///< (0, bed width]
  double side_mouth_m = 0.1285875;    ///< (0, bed length]

  friend bool operator==(const StandardPockets&, const StandardPockets&) = default;
};

/// Pockets with jaws: straight facings at the cut angles, noses rounded to arcs, and a hole that a
/// ball drops into when its centre crosses the edge. Needs rectangle cushions, whose model the jaws
/// share. Defaults: the WPA's equipment specifications.
struct JawedPockets {
  double corner_mouth_m = 0.1158875;  ///< between the points of the noses, (2R, bed width]
  double side_mouth_m = 0.1285875;    ///< (2R, bed length]
  double corner_cut_rad =
      2.478367538;  ///< 142 degrees, between cushion and facing, (3/4 of pi - 1/2, pi)
  double side_cut_rad = 1.815142422;  ///< 104 degrees, (pi/2, pi)
  double corner_shelf_m = 0.0412750;  ///< from the mouth to the edge of the hole, [0, mouth]
  double side_shelf_m = 0.0047625;    ///< [0, mouth]
  double corner_nose_m = 0.0209550;   ///< radius of the rounded nose, (0, 1]
  double side_nose_m = 0.0079375;     ///< (0, 1]
  double corner_hole_m = 0.0620;      ///< radius of the hole's edge, (0, mouth]
  double side_hole_m = 0.0645;        ///< (0, mouth]

  friend bool operator==(const JawedPockets&, const JawedPockets&) = default;
};

using Pockets = std::variant<StandardPockets, JawedPockets>;

// ---- Contact between balls

struct Elastic {
  friend bool operator==(const Elastic&, const Elastic&) = default;
};

/// Newton's restitution along the line of centres, no friction.
struct BallRestitution {
  double normal = 0.95;                                  ///< [0, 1]
  double elastic_below_m_s = default_elastic_below_m_s;  ///< [0, 1]

  friend bool operator==(const BallRestitution&, const BallRestitution&) = default;
};

/// Restitution with throw and transfer of spin. The coefficient of friction falls with the speed of
/// slip, mu = a + b exp(-c v): Alciatore's fit to Marlow's measurements. Equations: frictional.hpp.
struct BallFriction {
  double restitution = 0.95;                             ///< [0, 1]
  double a = 0.009951;                                   ///< [0, 1]
  double b = 0.108;                                      ///< [0, 1]
  double c_s_m = 1.088;                                  ///< s/m, [0, 1000]
  double elastic_below_m_s = default_elastic_below_m_s;  ///< [0, 1]

  friend bool operator==(const BallFriction&, const BallFriction&) = default;
};

/// The same contact integrated over the impulse, with friction between the balls and on the cloth
/// (Mathavan, Jackson and Parkin 2014): costlier. Equations: mathavan2014.hpp.
struct Mathavan2014 {
  double restitution = 0.89;                             ///< [0, 1]
  double friction = 0.05;                                ///< of ball and ball, [0, 1]
  double elastic_below_m_s = default_elastic_below_m_s;  ///< [0, 1]

  friend bool operator==(const Mathavan2014&, const Mathavan2014&) = default;
};

using BallBallModel = std::variant<Elastic, BallRestitution, BallFriction, Mathavan2014>;

// ---- Perturbation of contact normals (the paper's section 5)

/// The greatest tangent of the random rotation of a contact's normal.
struct Perturbation {
  double ball = 0;     ///< [0, 1]
  double cushion = 0;  ///< [0, 1]

  friend bool operator==(const Perturbation&, const Perturbation&) = default;
};

struct Scene {
  std::optional<double> gravity_m_s2;  ///< [1e-3, 1000]; may be missing only for frictionless
  BallKind ball;
  Bed bed;
  std::optional<Cushions> cushions;
  std::optional<Pockets> pockets;
  std::optional<BallBallModel> ball_ball;
  std::optional<Perturbation> perturbation;

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// What is wrong with one field of an input: its dotted path, as in a scenario file
/// ("scene.bed.motion.straight.rollingFriction", "balls[3].position.x"), and a sentence that says
/// what is wrong and what would be right.
struct Fault {
  std::string field;
  std::string what;

  friend bool operator==(const Fault&, const Fault&) = default;
};

/// All faults of a scene, in the order of its fields; none for a good one.
std::vector<Fault> faults_of(const Scene& scene);

/// The cushions as segments, rectangle or free, in the order of their ids; none without cushions.
/// The scene must be free of faults.
std::vector<CushionSegment> segments_of(const Scene& scene);

/// Two balls may overlap on input by this much, m: what decimal notation loses, and no more.
inline constexpr double input_overlap_m = 1e-12;
/// Greatest coordinate of a ball on input, m, and greatest speed, m/s.
inline constexpr double max_coordinate_m = 1e6;
inline constexpr double max_speed_m_s = 1e4;
/// Greatest spin of a ball on input about each axis, rad/s.
inline constexpr double max_spin_rad_s = 1e8;

/// All faults of the balls of `state` within a faultless scene: none at all, duplicates, ranges,
/// overlap with one another (where balls can touch) or with a cushion, balls off the bed, spin in a
/// motion without spin. Balls are named by their index in `state`, "balls[3].position".
std::vector<Fault> faults_of(const Scene& scene, const State& state);

/// Balls in one scene.
inline constexpr std::size_t max_balls = 1'000'000;

/// Beyond this offset of the tip, in radii, a cue slips off the ball.
inline constexpr double miscue_offset = 0.5;

/// Where the tip meets the ball, in radii from the centre as the player sees it.
struct Tip {
  double side = 0;    ///< positive to the player's left: the ball then turns clockwise
  double height = 0;  ///< positive above the centre: follow; below it: draw

  friend bool operator==(const Tip&, const Tip&) = default;
};

/// A stroke: sets the velocity, and with an offset tip the spin, of a ball at rest at t = 0.
struct Strike {
  BallId ball{};
  Vec2 direction{1, 0};  ///< length 1 to within 1e-9; normalised before use
  double speed_m_s = 0;  ///< of the ball, [0, 1e4]
  Tip tip{};             ///< within miscue_offset; the centre in motions without spin

  friend bool operator==(const Strike&, const Strike&) = default;
};

std::vector<Fault> faults_of(const Scene& scene, const State& state, const Strike& strike);

}  // namespace breakshot::physics
