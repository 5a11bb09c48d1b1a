#include "client_cli/account.hpp"

#include <cstdio>

namespace breakshot::client {
namespace {

bool is_shot(const record::Entry& entry) {
  return entry.outcome.shot && std::holds_alternative<match::Shoot>(entry.command);
}

void say(std::string& text, const std::string& sentence) {
  if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
}

rules::Seat seat_of(const record::Entry& entry) {
  return entry.author.seat.value_or(rules::Seat{0});
}

std::string event_line(const physics::Event& event) {
  char time[32];
  std::snprintf(time, sizeof time, "%12.6f s  ", physics::time_of(event));
  return time + words_of(event);
}

const char* kind_of(const match::Command& command) {
  static constexpr const char* kinds[] = {"start",   "place",        "shoot",    "choose",
                                          "concede", "agree_rerack", "abandoned"};
  static_assert(std::size(kinds) == std::variant_size_v<match::Command>);
  return kinds[command.index()];
}

Json ids_of(const std::vector<physics::BallId>& balls) {
  return array_of(balls, [](physics::BallId ball) { return Json(number(ball)); });
}

Json json_of(const match::Shoot& shoot, std::uint32_t number_of_shot, const physics::Shot& shot) {
  const rules::Call& call = shoot.call;
  return object({{"number", number_of_shot},
                 {"direction", array({shoot.direction.x, shoot.direction.y})},
                 {"speed", shoot.speed_m_s},
                 {"tip", array({shoot.tip.side, shoot.tip.height})},
                 {"ball", call.ball ? Json(number(*call.ball)) : Json()},
                 {"pocket", call.pocket ? Json(number(*call.pocket)) : Json()},
                 {"safety", call.safety},
                 {"events", shot.events.size()},
                 {"seconds", shot.end_s}});
}

}  // namespace

std::string Account::label_of(const record::Entry& entry) const {
  char label[32];
  if (is_shot(entry)) {
    std::snprintf(label, sizeof label, "shot %-4u ", static_cast<unsigned>(shots_));
  } else {
    std::snprintf(label, sizeof label, "%-10s", "");
  }
  return label;
}

std::vector<std::string> Account::lines_of(const record::Entry& entry, bool events) {
  const match::Outcome& outcome = entry.outcome;
  if (is_shot(entry)) ++shots_;
  std::vector<std::string> lines;
  std::string text;
  say(text, command_text(entry.author, entry.command, before_, names_));
  if (outcome.ruling) say(text, ruling_text(*outcome.ruling, seat_of(entry), names_));
  const bool finished = outcome.status.stage == match::Stage::finished;
  const bool new_rack = outcome.status.rack != before_.rack;
  if (!finished && !new_rack) say(text, status_text(outcome.status, names_));
  lines.push_back(label_of(entry) + text);
  if (events && outcome.shot) {
    for (const physics::Event& event : outcome.shot->events) lines.push_back(event_line(event));
  }
  if (new_rack && !finished) {
    text = "Rack " + std::to_string(outcome.status.rack) + ".";
    if (outcome.status.rack > 1) say(text, score_text(outcome.status, names_) + ".");
    say(text, status_text(outcome.status, names_));
    lines.push_back(text);
  }
  if (finished) {
    text = status_text(outcome.status, names_);
    const std::string score = score_text(outcome.status, names_);
    if (!score.empty()) say(text, score + ".");
    lines.push_back(text);
  }
  before_ = outcome.status;
  return lines;
}

Json Account::json_of(const record::Entry& entry) {
  const match::Outcome& outcome = entry.outcome;
  if (is_shot(entry)) ++shots_;
  Json shot;
  if (is_shot(entry)) {
    shot = client::json_of(std::get<match::Shoot>(entry.command), shots_, *outcome.shot);
  }
  const std::optional<rules::Seat> seat = entry.author.seat;
  const Json line = object(
      {{"entry", static_cast<std::uint32_t>(entry.seq)},
       {"command", kind_of(entry.command)},
       {"seat", seat ? Json(rules::number(*seat)) : Json()},
       {"name", seat ? Json(name_of(names_, *seat)) : Json()},
       {"shot", shot},
       {"pocketed", outcome.ruling ? ids_of(outcome.ruling->pocketed) : Json()},
       {"said", command_text(entry.author, entry.command, before_, names_)},
       {"ruling",
        outcome.ruling ? Json(ruling_text(*outcome.ruling, seat_of(entry), names_)) : Json()},
       {"next", status_text(outcome.status, names_)},
       {"rack", outcome.status.rack},
       {"score", array_of(outcome.status.score, [](std::uint32_t racks) { return Json(racks); })},
       {"digest", hash::hex_of(entry.digest)}});
  before_ = outcome.status;
  return line;
}

std::vector<std::string> heading_of(const record::Record& record) {
  const std::size_t entries = record.entries.size();
  return {match_text(record.header), "match " + words_of(record.header.id) + ", " +
                                         std::to_string(entries) +
                                         (entries == 1 ? " entry" : " entries")};
}

std::vector<std::string> account_of(const record::Record& record, bool events) {
  std::vector<std::string> lines = heading_of(record);
  Account account(names_of(record.header));
  for (const record::Entry& entry : record.entries) {
    for (std::string& line : account.lines_of(entry, events)) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace breakshot::client
