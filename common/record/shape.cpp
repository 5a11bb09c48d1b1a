#include "common/record/shape.hpp"

#include <algorithm>
#include <utility>

#include "common/record/limits.hpp"

namespace breakshot::record {
namespace {

using Fault = std::optional<std::string>;

std::string nth(const char* list, std::size_t i) {
  return std::string(list) + '[' + std::to_string(i) + ']';
}

/// The balls that have a path: those of the leading segments that start at 0, in order of id.
std::vector<physics::BallId> balls_of(const std::vector<physics::Segment>& segments) {
  std::vector<physics::BallId> balls;
  for (const physics::Segment& segment : segments) {
    if (segment.start_s != 0 || (!balls.empty() && segment.ball <= balls.back())) break;
    balls.push_back(segment.ball);
  }
  return balls;
}

/// Times of a list of a shot: never falling, and within the shot.
class Clock {
 public:
  explicit Clock(double end_s) : end_s_(end_s) {}

  Fault fault(double time_s) {
    if (time_s < now_s_) return "is earlier than the one before it";
    if (time_s > end_s_) return "is later than the end of the shot";
    now_s_ = time_s;
    return std::nullopt;
  }

 private:
  double now_s_ = 0;
  double end_s_;
};

Fault ball_fault(const std::vector<physics::BallId>& balls, physics::BallId ball) {
  if (std::binary_search(balls.begin(), balls.end(), ball)) return std::nullopt;
  return "is of ball " + std::to_string(number(ball)) + ", which has no segment from 0";
}

Fault balls_fault(const std::vector<physics::BallId>& balls, const physics::Event& event) {
  const auto* contact = std::get_if<physics::BallBall>(&event);
  if (contact != nullptr && contact->lower >= contact->higher) {
    return "must name the lower ball first";
  }
  const physics::BallsOf of = physics::balls_of(event);
  if (Fault fault = ball_fault(balls, of.first)) return fault;
  return of.second ? ball_fault(balls, *of.second) : std::nullopt;
}

Fault seat_fault(const char* field, std::optional<match::Seat> seat, std::size_t seats) {
  if (!seat || number(*seat) < seats) return std::nullopt;
  return std::string(field) + ": seat " + std::to_string(number(*seat)) + " of a match with " +
         std::to_string(seats);
}

Fault list_fault(const char* field, std::size_t size, std::size_t seats) {
  if (size == seats) return std::nullopt;
  return std::string(field) + ": " + std::to_string(size) + " listed, one for each of " +
         std::to_string(seats) + " seats is right";
}

}  // namespace

Fault shape_fault(const physics::State& state) {
  for (std::size_t i = 1; i < state.balls.size(); ++i) {
    if (state.balls[i].id <= state.balls[i - 1].id) {
      return nth("balls", i) + " does not ascend by id";
    }
  }
  return std::nullopt;
}

Fault shape_fault(const physics::Shot& shot) {
  if (shot.end_s < 0) return "ends before it starts";
  const std::vector<physics::BallId> balls = balls_of(shot.segments);
  Clock segment_clock(shot.end_s);
  for (std::size_t i = 0; i < shot.segments.size(); ++i) {
    Fault fault = segment_clock.fault(shot.segments[i].start_s);
    if (!fault) fault = ball_fault(balls, shot.segments[i].ball);
    if (fault) return nth("segments", i) + ' ' + *fault;
  }
  Clock event_clock(shot.end_s);
  for (std::size_t i = 0; i < shot.events.size(); ++i) {
    Fault fault = event_clock.fault(physics::time_of(shot.events[i]));
    if (!fault) fault = balls_fault(balls, shot.events[i]);
    if (fault) return nth("events", i) + ' ' + *fault;
  }
  return std::nullopt;
}

Fault shape_fault(const Header& header) {
  const std::size_t seats = header.settings.seats;
  if (seats < 1 || seats > max_seats) {
    return "settings.seats: " + std::to_string(seats) + " seats, 1 to " +
           std::to_string(max_seats) + " are right";
  }
  return list_fault("players", header.players.size(), seats);
}

Fault shape_fault(const Header& header, const Entry& entry) {
  const std::size_t seats = header.settings.seats;
  const match::Status& status = entry.outcome.status;
  std::optional<match::Seat> leaver, rack_winner;
  if (const auto* abandoned = std::get_if<match::Abandoned>(&entry.command)) {
    leaver = abandoned->seat;
  }
  if (entry.outcome.ruling) rack_winner = entry.outcome.ruling->rack_winner;
  for (const Fault& fault :
       {seat_fault("author.seat", entry.author.seat, seats),
        seat_fault("command.seat", leaver, seats),
        seat_fault("outcome.ruling.rack_winner", rack_winner, seats),
        seat_fault("outcome.status.game.turn", status.game.turn, seats),
        seat_fault("outcome.status.winner", status.winner, seats),
        list_fault("outcome.status.score", status.score.size(), seats),
        list_fault("outcome.status.game.groups", status.game.groups.size(), seats),
        list_fault("outcome.status.rerack_agreed", status.rerack_agreed.size(), seats)}) {
    if (fault) return fault;
  }
  return std::nullopt;
}

}  // namespace breakshot::record
