// Shots made by hand: a test of the rules says what happened instead of hoping that a stroke does
// it.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "common/physics/event.hpp"
#include "common/physics/table.hpp"
#include "common/rules/placement.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::support {

/// The default preset: an 8-foot table with cushions, pockets and friction.
inline const physics::Scene& club_scene() {
  return physics::presets().front().scene;
}

inline physics::State table_of(
    std::initializer_list<std::pair<std::uint32_t, physics::Vec2>> balls) {
  physics::State table;
  for (const auto& [id, position] : balls) {
    table = rules::with_ball(table, physics::BallId{id}, position);
  }
  return table;
}

/// Says in any order what happened to the balls of a table; `shot` puts it in the order of the
/// physics. Balls that are not said to move stay where they are.
class ShotBuilder {
 public:
  explicit ShotBuilder(const physics::State& before) {
    for (const physics::Ball& ball : before.balls) {
      segments_.push_back({ball.id, physics::Phase::rest, 0, ball.position, {}, {}});
    }
  }

  ShotBuilder& hits(double time_s, std::uint32_t a, std::uint32_t b, std::uint32_t pass = 0) {
    const auto [lower, higher] = std::minmax(a, b);
    return event(physics::BallBall{time_s, pass, physics::BallId{lower}, physics::BallId{higher}});
  }
  ShotBuilder& reaches_rail(double time_s, std::uint32_t ball, std::uint32_t cushion,
                            std::uint32_t pass = 0) {
    return event(
        physics::BallCushion{time_s, pass, physics::BallId{ball}, physics::CushionId{cushion}});
  }
  ShotBuilder& drops(double time_s, std::uint32_t ball, std::uint8_t pocket) {
    segment({physics::BallId{ball}, physics::Phase::pocketed, time_s, {}, {}, {}});
    return event(physics::BallPocket{time_s, 0, physics::BallId{ball}, physics::PocketId{pocket}});
  }
  ShotBuilder& moves(double start_s, std::uint32_t ball, physics::Vec2 from, physics::Vec2 velocity,
                     physics::Vec2 acceleration = {}) {
    return segment(
        {physics::BallId{ball}, physics::Phase::slide, start_s, from, velocity, acceleration});
  }
  ShotBuilder& stops(double time_s, std::uint32_t ball, physics::Vec2 at) {
    segment({physics::BallId{ball}, physics::Phase::rest, time_s, at, {}, {}});
    return event(physics::Rests{time_s, physics::BallId{ball}});
  }

  physics::Shot shot() const {
    physics::Shot shot;
    shot.events = events_;
    shot.segments = segments_;
    std::stable_sort(shot.events.begin(), shot.events.end(), before_in_time);
    std::stable_sort(shot.segments.begin(), shot.segments.end(), [](const auto& a, const auto& b) {
      return std::pair(a.start_s, a.ball) < std::pair(b.start_s, b.ball);
    });
    for (const physics::Event& e : events_) shot.end_s = std::max(shot.end_s, time_of(e));
    return shot;
  }

 private:
  static std::uint32_t pass_of(const physics::Event& event) {
    return std::visit(
        [](const auto& e) -> std::uint32_t {
          if constexpr (requires { e.pass; })
            return e.pass;
          else
            return 0;
        },
        event);
  }
  static bool before_in_time(const physics::Event& a, const physics::Event& b) {
    return std::tuple(time_of(a), pass_of(a), a.index()) <
           std::tuple(time_of(b), pass_of(b), b.index());
  }

  ShotBuilder& event(const physics::Event& event) {
    events_.push_back(event);
    return *this;
  }
  ShotBuilder& segment(const physics::Segment& segment) {
    std::erase_if(segments_, [&](const physics::Segment& s) {
      return s.ball == segment.ball && s.start_s == segment.start_s;
    });
    segments_.push_back(segment);
    return *this;
  }

  std::vector<physics::Event> events_;
  std::vector<physics::Segment> segments_;
};

}  // namespace breakshot::support
