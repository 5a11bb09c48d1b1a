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

using Motion = std::variant<Frictionless, Straight>;

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

using CushionModel = std::variant<Mirror, CushionRestitution>;

/// A straight cushion nose. The playing side is to the left of from -> to.
struct CushionSegment {
  Vec2 from;  ///< m
  Vec2 to;    ///< m
  CushionModel model;

  friend bool operator==(const CushionSegment&, const CushionSegment&) = default;
};

/// Four cushions round the bed: 0 foot, 1 left, 2 head, 3 right.
struct RectangleCushions {
  CushionModel model;

  friend bool operator==(const RectangleCushions&, const RectangleCushions&) = default;
};

struct FreeCushions {
  std::vector<CushionSegment> segments;

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

using BallBallModel = std::variant<Elastic, BallRestitution>;

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
  std::optional<StandardPockets> pockets;
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

/// All faults of the balls of `state` within a faultless scene: none at all, duplicates, ranges,
/// overlap with one another (where balls can touch) or with a cushion, balls off the bed, spin in a
/// motion without spin. Balls are named by their index in `state`, "balls[3].position".
std::vector<Fault> faults_of(const Scene& scene, const State& state);

/// Balls in one scene.
inline constexpr std::size_t max_balls = 1'000'000;

/// A stroke: sets the velocity of a ball at rest at t = 0.
struct Strike {
  BallId ball{};
  Vec2 direction{1, 0};  ///< length 1 to within 1e-9; normalised before use
  double speed_m_s = 0;  ///< [0, 1e4]

  friend bool operator==(const Strike&, const Strike&) = default;
};

std::vector<Fault> faults_of(const Scene& scene, const State& state, const Strike& strike);

}  // namespace breakshot::physics
