#include "client_cli/stored_match.hpp"

#include <algorithm>
#include <filesystem>

#include "client_cli/fetch.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/read_input.hpp"

namespace breakshot::client {
namespace {

record::ByteVector bytes_of(const std::string& name) {
  const std::string bytes = read_input(name);
  return {bytes.begin(), bytes.end()};
}

StoredMatch match_in(const std::string& name, const record::ByteVector& bytes) {
  record::Reading reading = record::read_file(bytes);
  if (reading.record) return {std::move(*reading.record), std::move(reading.damage)};
  const std::string what = reading.damage ? reading.damage->what : "it is empty";
  throw CommandError(name + ": is not a match record: " + what, exit_usage);
}

StoredMatch match_on_server(const std::string& name, const Globals& globals,
                            const std::string& guest) {
  auto fetched = fetch_record(server_of(globals), guest_or_stranger(guest), name);
  if (const auto* failure = std::get_if<Failure>(&fetched)) {
    throw CommandError(name + ": " + failure->what);
  }
  return {std::get<record::Record>(std::move(fetched)), std::nullopt};
}

bool contains(const std::vector<physics::BallId>& balls, physics::BallId ball) {
  return std::find(balls.begin(), balls.end(), ball) != balls.end();
}

bool lies_on(const physics::State& table, physics::BallId id) {
  return std::any_of(table.balls.begin(), table.balls.end(),
                     [id](const physics::Ball& ball) { return ball.id == id; });
}

}  // namespace

StoredMatch open_match(const std::string& name, const Globals& globals, const std::string& guest) {
  std::error_code ignored;
  const bool is_file = name == "-" || std::filesystem::exists(name, ignored);
  if (is_file || !match_name_of(name)) return match_in(name, bytes_of(name));
  return match_on_server(name, globals, guest);
}

std::string damage_text(const StoredMatch& match) {
  const std::size_t whole = match.record.entries.size();
  return "damaged at byte " + std::to_string(match.damage->offset) + ": " + match.damage->what +
         "; " + (whole == 1 ? "the entry" : "the " + std::to_string(whole) + " entries") +
         " before it " + (whole == 1 ? "is" : "are") + " whole";
}

std::vector<StoredShot> shots_of(const record::Record& record) {
  std::vector<StoredShot> shots;
  match::Status before;
  PocketedBalls pocketed;
  for (const record::Entry& entry : record.entries) {
    if (entry.outcome.shot && std::holds_alternative<match::Shoot>(entry.command)) {
      const auto number = static_cast<std::uint32_t>(shots.size() + 1);
      shots.push_back({&entry, number, before, pocketed.balls()});
    }
    pocketed.follow(entry.outcome);
    before = entry.outcome.status;
  }
  return shots;
}

const StoredShot& shot_of(const std::vector<StoredShot>& shots, std::uint32_t number) {
  if (shots.empty()) throw CommandError("--shot: no shot has been played yet", exit_usage);
  if (number >= 1 && number <= shots.size()) return shots[number - 1];
  throw CommandError("--shot: there is no shot " + std::to_string(number) +
                         "; the match has shots 1 to " + std::to_string(shots.size()),
                     exit_usage);
}

CueVector cue_vector_of(const record::Entry& entry) {
  const auto& shoot = std::get<match::Shoot>(entry.command);
  const auto& segments = entry.outcome.shot->segments;
  // The first segments of a shot are where the balls stood.
  const auto first = std::find_if(segments.begin(), segments.end(),
                                  [](const auto& s) { return s.ball == rules::cue_ball; });
  const physics::Vec2 from = first == segments.end() ? physics::Vec2{} : first->position;
  return {from, shoot.direction, shoot.speed_m_s};
}

void PocketedBalls::follow(const match::Outcome& outcome) {
  if (outcome.ruling) {
    for (const physics::BallId ball : outcome.ruling->pocketed) {
      if (!contains(balls_, ball)) balls_.push_back(ball);
    }
  }
  // Spotted balls and those of a new rack are back.
  std::erase_if(balls_, [&](physics::BallId ball) { return lies_on(outcome.table, ball); });
}

}  // namespace breakshot::client
