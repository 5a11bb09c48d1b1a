// A picture of the table: everything that is to be seen, in metres, before anybody decides whether
// it becomes pixels, vectors or characters. Drawing needs no physics beyond the timeline.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client_cli/draw/palette.hpp"
#include "common/physics/scene.hpp"
#include "common/physics/timeline.hpp"

namespace breakshot::client {

/// An upright rectangle, m.
struct Box {
  physics::Vec2 low;
  physics::Vec2 high;

  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }

  friend bool operator==(const Box&, const Box&) = default;
};

/// A pocket as it is drawn: the mouth's ends on the noses, and the hole behind it, m.
struct DrawnPocket {
  physics::Vec2 mouth_from;
  physics::Vec2 mouth_to;
  physics::Vec2 centre;
  double radius_m = 0;
};

/// What of a scene can be seen and does not move.
struct Table {
  Box bed;  ///< between the noses, or round all that there is
  double ball_radius_m = 0;
  bool has_rails = false;  ///< rectangle cushions: drawn as a pool table with wood round it
  std::vector<physics::CushionSegment> cushions;
  std::vector<DrawnPocket> pockets;  ///< by PocketId; none or six
  std::optional<physics::Vec2> head_spot;
  std::optional<physics::Vec2> foot_spot;
  std::optional<double> head_string_x_m;
};

/// `balls` widen the bed where the scene sets no bounds.
Table table_of(const physics::Scene& scene, const std::vector<physics::BallState>& balls = {});

/// Width of a cushion from its nose to the wood, and of the wood, m.
double cushion_width(const Table& table);
double wood_width(const Table& table);
/// The table with its rails.
Box frame_of(const Table& table);

struct DrawnBall {
  physics::BallId id{};
  physics::Vec2 position;  ///< m
  physics::Vec2 velocity;  ///< m/s
  double scale = 1;        ///< of its radius: less while it falls into a pocket
};

/// The paper's red line: where the cue strikes and how hard.
struct CueVector {
  physics::Vec2 from;       ///< the cue ball's centre, m
  physics::Vec2 direction;  ///< unit vector
  double speed_m_s = 0;
};

/// The way of one ball as a polyline.
struct DrawnPath {
  physics::BallId ball{};
  std::vector<physics::Vec2> points;  ///< m
};

struct Picture {
  Table table;
  std::optional<Box> window;  ///< the part to be seen instead of the whole table
  std::vector<DrawnBall> balls;
  std::vector<DrawnPath> paths;
  std::optional<CueVector> cue;
  bool velocities = false;                ///< draw the paper's blue vectors
  std::vector<physics::BallId> pocketed;  ///< shown beside the table, in order
  std::string caption;                    ///< one line under the table; empty for none
};

/// Vectors are drawn as long as the ball would go in this time, s.
inline constexpr double cue_vector_s = 0.06;
inline constexpr double velocity_vector_s = 0.12;
/// How long a ball is seen falling into a pocket, s.
inline constexpr double falling_s = 0.18;

std::vector<DrawnBall> drawn(const std::vector<physics::BallState>& balls);
/// Balls at rest.
std::vector<DrawnBall> drawn(const physics::State& state);

/// The balls of a shot at an instant; those that dropped a moment ago are still falling.
std::vector<DrawnBall> balls_at(const Table& table, const physics::Timeline& timeline,
                                double time_s);

/// The ways of all balls that moved before `time_s`.
std::vector<DrawnPath> paths_until(const physics::Timeline& timeline, double time_s);

}  // namespace breakshot::client
