// Random values that the record accepts, from a seed: every alternative of every variant, awkward
// numbers and texts included. They obey the record's rules of order, not those of the game.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "common/record/record.hpp"

namespace breakshot::support {

class Arbitrary {
 public:
  explicit Arbitrary(std::uint64_t seed) : random_(seed) {}

  /// Below `end`, which is at least 1.
  std::uint64_t below(std::uint64_t end) { return random_() % end; }
  bool coin() { return below(2) == 0; }

  template <std::size_t N>
  std::array<std::uint8_t, N> bytes() {
    std::array<std::uint8_t, N> bytes{};
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(below(256));
    return bytes;
  }

  double real() {
    static constexpr double awkward[] = {0.0,
                                         -0.0,
                                         1.0,
                                         std::numeric_limits<double>::denorm_min(),
                                         std::numeric_limits<double>::max(),
                                         std::numeric_limits<double>::lowest(),
                                         0.1};
    if (below(4) == 0) return awkward[below(std::size(awkward))];
    const double any = std::bit_cast<double>(random_());
    return std::isfinite(any) ? any : 0.5;
  }

  record::Header header() {
    record::Header header;
    header.physics = number();
    header.id = match::MatchId{random_()};
    header.created_unix_ms = static_cast<std::int64_t>(random_());
    header.settings = settings();
    for (int seat = 0; seat < header.settings.seats; ++seat) {
      header.players.push_back({text(), bytes<32>()});
    }
    header.commitment = bytes<32>();
    return header;
  }

  /// An entry of a match with so many seats; its digest is not chained.
  record::Entry entry(std::size_t seats) {
    record::Entry entry;
    entry.seq = match::Seq{number()};
    if (coin()) entry.author.seat = seat(seats);
    entry.id = match::CommandId{random_()};
    entry.command = command(seats);
    entry.outcome = outcome(seats);
    if (coin()) entry.secret = bytes<32>();
    entry.digest = bytes<32>();
    return entry;
  }

  /// A chain of entries; the last one holds a secret or not.
  record::Record record(std::size_t entries) {
    record::Record record{header(), {}};
    hash::Digest before = record::digest_of(record.header);
    for (std::size_t i = 0; i < entries; ++i) {
      record::Entry next = entry(record.header.settings.seats);
      next.seq = match::Seq{static_cast<std::uint32_t>(i)};
      if (i + 1 < entries) next.secret.reset();
      next.digest = before = record::digest_of(before, next);
      record.entries.push_back(std::move(next));
    }
    return record;
  }

  physics::Scene scene() {
    physics::Scene scene;
    if (coin()) scene.gravity_m_s2 = real();
    scene.ball = {real(), real()};
    scene.bed.motion = motion();
    if (coin()) scene.bed.length_m = real();
    if (coin()) scene.bed.width_m = real();
    if (coin()) scene.cushions = cushions();
    if (coin()) scene.pockets = pockets();
    if (coin()) scene.ball_ball = ball_ball();
    if (coin()) scene.perturbation = physics::Perturbation{real(), real()};
    return scene;
  }

  physics::Shot shot() {
    physics::Shot shot;
    std::vector<physics::BallId> balls;
    for (const physics::Ball& ball : state().balls) balls.push_back(ball.id);
    shot.end_s = std::abs(real());
    for (const physics::BallId ball : balls) shot.segments.push_back(segment(ball, 0));
    if (balls.empty()) return shot;
    for (const double time_s : times(shot.end_s)) {
      shot.segments.push_back(segment(one_of(balls), time_s));
    }
    for (const double time_s : times(shot.end_s)) shot.events.push_back(event(balls, time_s));
    shot.stop = physics::Stop(below(2));
    return shot;
  }

 private:
  std::uint32_t number() { return static_cast<std::uint32_t>(random_()); }
  rules::Seat seat(std::size_t seats) { return rules::Seat(below(seats)); }
  physics::BallId ball() { return physics::BallId{number()}; }
  physics::PocketId pocket() { return physics::PocketId(below(256)); }
  physics::Vec2 vec2() { return {real(), real()}; }
  physics::Vec3 vec3() { return {real(), real(), real()}; }

  template <class T>
  const T& one_of(const std::vector<T>& values) {
    return values[below(values.size())];
  }

  std::string text() {
    static const std::vector<std::string> pieces{"", "a", " ", "é", "東", "🎱"};
    std::string text;
    for (std::uint64_t i = below(6); i > 0; --i) text += one_of(pieces);
    return text;
  }

  match::Settings settings() {
    match::Settings settings;
    settings.preset = text();
    settings.scene = scene();
    settings.game = match::GameKind(below(2));
    settings.seats = static_cast<std::uint8_t>(1 + below(match::max_practice_seats));
    settings.race_to = number();
    return settings;
  }

  physics::Motion motion() {
    switch (below(3)) {
      case 0:
        return physics::Frictionless{};
      case 1:
        return physics::Straight{real(), real(), real()};
      default:
        return physics::Spinning{real(), real(), real()};
    }
  }

  physics::CushionModel cushion_model() {
    switch (below(5)) {
      case 0:
        return physics::Mirror{};
      case 1:
        return physics::CushionRestitution{real(), real(), real()};
      case 2:
        return physics::Han2005{real(), real(), real()};
      case 3:
        return physics::Mathavan2010{real(), real(), real()};
      default:
        return physics::Stronge2000{real(), real(), real(), real()};
    }
  }

  physics::Pockets pockets() {
    if (coin()) return physics::StandardPockets{real(), real()};
    return physics::JawedPockets{real(), real(), real(), real(), real(),
                                 real(), real(), real(), real(), real()};
  }

  physics::BallBallModel ball_ball() {
    switch (below(4)) {
      case 0:
        return physics::Elastic{};
      case 1:
        return physics::BallRestitution{real(), real()};
      case 2:
        return physics::BallFriction{real(), real(), real(), real(), real()};
      default:
        return physics::Mathavan2014{real(), real(), real()};
    }
  }

  physics::Cushions cushions() {
    if (coin()) return physics::RectangleCushions{cushion_model()};
    physics::FreeCushions free;
    for (std::uint64_t i = below(4); i > 0; --i) {
      free.segments.push_back({vec2(), vec2(), cushion_model()});
    }
    if (coin()) return free;
    for (std::uint64_t i = below(4); i > 0; --i) {
      free.arcs.push_back({vec2(), real(), vec2(), vec2(), cushion_model()});
    }
    return free;
  }

  physics::State state() {
    physics::State state;
    std::uint32_t id = number() % 100;
    for (std::uint64_t i = below(5); i > 0; --i) {
      state.balls.push_back({physics::BallId{id}, vec2(), vec2(), vec3()});
      id += 1 + number() % 1000;
    }
    return state;
  }

  physics::Segment segment(physics::BallId ball, double start_s) {
    physics::Segment segment{ball, physics::Phase(below(5)), start_s, vec2(), vec2(), vec2()};
    if (coin()) segment.spin = vec3();
    if (coin()) segment.spin_change = vec3();
    return segment;
  }

  std::vector<double> times(double end_s) {
    std::vector<double> times;
    for (std::uint64_t i = below(8); i > 0; --i) {
      times.push_back(end_s * (static_cast<double>(below(1000)) / 1000));
    }
    std::sort(times.begin(), times.end());
    return times;
  }

  physics::Event event(const std::vector<physics::BallId>& balls, double time_s) {
    const physics::BallId ball = one_of(balls), other = one_of(balls);
    const std::uint32_t pass = number();
    switch (below(7)) {
      case 0:
        return physics::Struck{time_s, ball};
      case 1:
        if (ball == other) return physics::Struck{time_s, ball};
        return physics::BallBall{time_s, pass, std::min(ball, other), std::max(ball, other)};
      case 2:
        return physics::BallCushion{time_s, pass, ball, physics::CushionId{number()}};
      case 3:
        return physics::BallPocket{time_s, pass, ball, pocket()};
      case 4:
        return physics::Rolls{time_s, ball};
      case 5:
        return physics::Spins{time_s, ball};
      default:
        return physics::Rests{time_s, ball};
    }
  }

  rules::Call call() {
    rules::Call call;
    if (coin()) call.ball = ball();
    if (coin()) call.pocket = pocket();
    call.safety = coin();
    return call;
  }

  match::Command command(std::size_t seats) {
    switch (below(7)) {
      case 0:
        return match::Start{};
      case 1:
        return match::Place{ball(), vec2()};
      case 2:
        if (coin()) return match::Shoot{vec2(), real(), call()};
        return match::Shoot{vec2(), real(), call(), {real(), real()}};
      case 3:
        return match::Choose{rules::Option(below(6))};
      case 4:
        return match::Concede{};
      case 5:
        return match::AgreeRerack{};
      default:
        return match::Abandoned{seat(seats)};
    }
  }

  rules::Ruling ruling(std::size_t seats) {
    rules::Ruling ruling;
    for (std::uint64_t i = below(4); i > 0; --i) ruling.fouls.push_back(rules::Foul(below(5)));
    for (std::uint64_t i = below(4); i > 0; --i) ruling.pocketed.push_back(ball());
    for (std::uint64_t i = below(4); i > 0; --i) ruling.spotted.push_back(ball());
    if (coin()) ruling.group_won = rules::Group(below(3));
    if (coin()) ruling.rack_winner = seat(seats);
    if (coin()) ruling.rack_end = rules::RackEnd(below(4));
    ruling.illegal_break = coin();
    return ruling;
  }

  match::Status status(std::size_t seats) {
    match::Status status;
    status.stage = match::Stage(below(3));
    status.rack = number();
    status.game.turn = seat(seats);
    status.game.breaking = coin();
    status.game.ball_in_hand = rules::BallInHand(below(3));
    for (std::uint64_t i = below(4); i > 0; --i) {
      status.game.options.push_back(rules::Option(below(6)));
    }
    for (std::size_t i = 0; i < seats; ++i) {
      status.score.push_back(number());
      status.game.groups.push_back(rules::Group(below(3)));
      status.rerack_agreed.push_back(coin());
    }
    if (coin()) status.winner = seat(seats);
    if (coin()) status.end = match::MatchEnd(below(3));
    return status;
  }

  match::Outcome outcome(std::size_t seats) {
    match::Outcome outcome;
    if (coin()) outcome.shot = shot();
    if (coin()) outcome.ruling = ruling(seats);
    outcome.table = state();
    outcome.status = status(seats);
    return outcome;
  }

  std::mt19937_64 random_;
};

}  // namespace breakshot::support
