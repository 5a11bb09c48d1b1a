#include "common/wire/shots.hpp"

#include <algorithm>
#include <variant>

namespace breakshot::wire {
namespace {

using physics::BallId;
using physics::CushionId;

static_assert(v1::Phase_MAX == static_cast<int>(physics::Phase::pocketed) + 1);
static_assert(v1::Stop_MAX == static_cast<int>(physics::Stop::horizon) + 1);

// ---- Events

struct EventWriter {
  v1::ShotEvent& message;

  void operator()(const physics::Struck& e) const {
    message.mutable_struck()->set_ball(number(e.ball));
  }
  void operator()(const physics::BallBall& e) const {
    message.set_pass(e.pass);
    message.mutable_ball_ball()->set_lower(number(e.lower));
    message.mutable_ball_ball()->set_higher(number(e.higher));
  }
  void operator()(const physics::BallCushion& e) const {
    message.set_pass(e.pass);
    message.mutable_ball_cushion()->set_ball(number(e.ball));
    message.mutable_ball_cushion()->set_cushion(number(e.cushion));
  }
  void operator()(const physics::BallPocket& e) const {
    message.set_pass(e.pass);
    message.mutable_ball_pocket()->set_ball(number(e.ball));
    message.mutable_ball_pocket()->set_pocket(number(e.pocket));
  }
  void operator()(const physics::Rolls& e) const {
    message.mutable_rolls()->set_ball(number(e.ball));
  }
  void operator()(const physics::Spins& e) const {
    message.mutable_spins()->set_ball(number(e.ball));
  }
  void operator()(const physics::Rests& e) const {
    message.mutable_rests()->set_ball(number(e.ball));
  }
};

physics::Event read(const v1::ShotEvent& message, const Where& at) {
  const double t = finite(message.time_s(), Where(at, "time_s"));
  const std::uint32_t pass = message.pass();
  using Kind = v1::ShotEvent::KindCase;
  const Kind kind = message.kind_case();
  const bool contact =
      kind == Kind::kBallBall || kind == Kind::kBallCushion || kind == Kind::kBallPocket;
  if (pass != 0 && !contact) Where(at, "pass").refuse("is given; only contacts have passes");
  switch (kind) {
    case Kind::kStruck:
      return physics::Struck{t, BallId{message.struck().ball()}};
    case Kind::kBallBall: {
      const auto& e = message.ball_ball();
      if (e.lower() >= e.higher()) Where(at, "ball_ball.lower").refuse("must be less than higher");
      return physics::BallBall{t, pass, BallId{e.lower()}, BallId{e.higher()}};
    }
    case Kind::kBallCushion: {
      const auto& e = message.ball_cushion();
      return physics::BallCushion{t, pass, BallId{e.ball()}, CushionId{e.cushion()}};
    }
    case Kind::kBallPocket: {
      const auto& e = message.ball_pocket();
      const auto id = pocket(e.pocket(), Where(at, "ball_pocket.pocket"));
      return physics::BallPocket{t, pass, BallId{e.ball()}, id};
    }
    case Kind::kRolls:
      return physics::Rolls{t, BallId{message.rolls().ball()}};
    case Kind::kSpins:
      return physics::Spins{t, BallId{message.spins().ball()}};
    case Kind::kRests:
      return physics::Rests{t, BallId{message.rests().ball()}};
    case Kind::KIND_NOT_SET:
      break;
  }
  at.refuse("has no kind; exactly one must be given");
  return physics::Struck{};
}

// ---- Segments

void write(const physics::Segment& s, v1::Segment& message) {
  message.set_ball(number(s.ball));
  message.set_phase(enum_of<v1::Phase>(s.phase));
  message.set_start_s(s.start_s);
  message.set_x(s.position.x);
  message.set_y(s.position.y);
  message.set_velocity_x(s.velocity.x);
  message.set_velocity_y(s.velocity.y);
  message.set_acceleration_x(s.acceleration.x);
  message.set_acceleration_y(s.acceleration.y);
  message.set_spin_x(s.spin.x);
  message.set_spin_y(s.spin.y);
  message.set_spin_z(s.spin.z);
  message.set_spin_change_x(s.spin_change.x);
  message.set_spin_change_y(s.spin_change.y);
  message.set_spin_change_z(s.spin_change.z);
}

physics::Segment read(const v1::Segment& message, const Where& at) {
  const auto real = [&](double value, const char* name) { return finite(value, Where(at, name)); };
  return {
      BallId{message.ball()},
      enumerated<physics::Phase>(message.phase(), v1::Phase_MAX, Where(at, "phase")),
      real(message.start_s(), "start_s"),
      {real(message.x(), "x"), real(message.y(), "y")},
      {real(message.velocity_x(), "velocity_x"), real(message.velocity_y(), "velocity_y")},
      {real(message.acceleration_x(), "acceleration_x"),
       real(message.acceleration_y(), "acceleration_y")},
      {real(message.spin_x(), "spin_x"), real(message.spin_y(), "spin_y"),
       real(message.spin_z(), "spin_z")},
      {real(message.spin_change_x(), "spin_change_x"),
       real(message.spin_change_y(), "spin_change_y"),
       real(message.spin_change_z(), "spin_change_z")},
  };
}

// ---- The order of a shot, on which a timeline relies

/// The balls of the leading segments, which start at 0 and go by ball.
std::vector<BallId> balls_of(const physics::Shot& shot) {
  std::vector<BallId> balls;
  for (const physics::Segment& s : shot.segments) {
    if (s.start_s != 0 || (!balls.empty() && s.ball <= balls.back())) break;
    balls.push_back(s.ball);
  }
  return balls;
}

void check_segments(const physics::Shot& shot, const std::vector<BallId>& balls, const Where& at) {
  double before = 0;
  for (std::size_t i = 0; i < shot.segments.size(); ++i) {
    const physics::Segment& s = shot.segments[i];
    const Where here(at, "segments", static_cast<int>(i));
    if (!(s.start_s >= before && s.start_s <= shot.end_s)) {
      Where(here, "start_s").refuse("must not be before the segment before, nor after end_s");
    }
    if (!std::binary_search(balls.begin(), balls.end(), s.ball)) {
      Where(here, "ball").refuse("has no segment among the first, which start at 0");
    }
    before = s.start_s;
  }
}

void check_events(const physics::Shot& shot, const std::vector<BallId>& balls, const Where& at) {
  const auto known = [&](BallId ball) {
    return std::binary_search(balls.begin(), balls.end(), ball);
  };
  double before = 0;
  for (std::size_t i = 0; i < shot.events.size(); ++i) {
    const physics::Event& event = shot.events[i];
    const Where here(at, "events", static_cast<int>(i));
    const double t = physics::time_of(event);
    if (!(t >= before && t <= shot.end_s)) {
      Where(here, "time_s").refuse("must not be before the event before, nor after end_s");
    }
    const auto [first, second] = physics::balls_of(event);
    if (!known(first) || (second && !known(*second))) {
      here.refuse("is of a ball that has no segment at 0");
    }
    before = t;
  }
}

}  // namespace

void write(const physics::State& table, v1::Table& message) {
  message.mutable_balls()->Reserve(static_cast<int>(table.balls.size()));
  for (const physics::Ball& ball : table.balls) {
    v1::BallAt& at = *message.add_balls();
    at.set_id(number(ball.id));
    at.set_x(ball.position.x);
    at.set_y(ball.position.y);
    at.set_velocity_x(ball.velocity.x);
    at.set_velocity_y(ball.velocity.y);
    at.set_spin_x(ball.spin.x);
    at.set_spin_y(ball.spin.y);
    at.set_spin_z(ball.spin.z);
  }
}

physics::State read(const v1::Table& message, const Where& at) {
  physics::State table;
  table.balls.reserve(static_cast<std::size_t>(message.balls_size()));
  for (int i = 0; i < message.balls_size() && at.good(); ++i) {
    const v1::BallAt& ball = message.balls(i);
    const Where here(at, "balls", i);
    const auto real = [&](double value, const char* name) {
      return finite(value, Where(here, name));
    };
    table.balls.push_back({
        BallId{ball.id()},
        {real(ball.x(), "x"), real(ball.y(), "y")},
        {real(ball.velocity_x(), "velocity_x"), real(ball.velocity_y(), "velocity_y")},
        {real(ball.spin_x(), "spin_x"), real(ball.spin_y(), "spin_y"),
         real(ball.spin_z(), "spin_z")},
    });
  }
  return table;
}

void write(const physics::Shot& shot, v1::Shot& message) {
  message.mutable_events()->Reserve(static_cast<int>(shot.events.size()));
  for (const physics::Event& event : shot.events) {
    v1::ShotEvent& said = *message.add_events();
    said.set_time_s(physics::time_of(event));
    std::visit(EventWriter{said}, event);
  }
  message.mutable_segments()->Reserve(static_cast<int>(shot.segments.size()));
  for (const physics::Segment& segment : shot.segments) write(segment, *message.add_segments());
  message.set_end_s(shot.end_s);
  message.set_stop(enum_of<v1::Stop>(shot.stop));
}

physics::Shot read(const v1::Shot& message, const Where& at) {
  physics::Shot shot;
  shot.events.reserve(static_cast<std::size_t>(message.events_size()));
  for (int i = 0; i < message.events_size() && at.good(); ++i) {
    shot.events.push_back(read(message.events(i), Where(at, "events", i)));
  }
  shot.segments.reserve(static_cast<std::size_t>(message.segments_size()));
  for (int i = 0; i < message.segments_size() && at.good(); ++i) {
    shot.segments.push_back(read(message.segments(i), Where(at, "segments", i)));
  }
  shot.end_s = finite(message.end_s(), Where(at, "end_s"));
  shot.stop = enumerated<physics::Stop>(message.stop(), v1::Stop_MAX, Where(at, "stop"));
  if (!at.good()) return shot;
  const std::vector<BallId> balls = balls_of(shot);
  check_segments(shot, balls, at);
  check_events(shot, balls, at);
  return shot;
}

}  // namespace breakshot::wire
