#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "client_cli/words.hpp"

namespace breakshot::client {
namespace {

std::string decimals(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  // Nobody shoots at minus zero degrees.
  return text[0] == '-' && std::strtod(text, nullptr) == 0 ? text + 1 : text;
}

/// "a", "a; or b", "a; b; or c": an alternative may have an "and" of its own.
std::string alternatives(const std::vector<rules::Option>& options) {
  std::string text;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (i > 0) text += i + 1 == options.size() ? "; or " : "; ";
    text += words_of(options[i]);
  }
  return text;
}

std::string rack_end_text(rules::RackEnd end) {
  switch (end) {
    case rules::RackEnd::eight_pocketed:
      return "the 8 ball was pocketed as called";
    case rules::RackEnd::foul_on_eight:
      return "the 8 ball was pocketed with a foul";
    case rules::RackEnd::eight_too_early:
      return "the 8 ball was pocketed too early";
    case rules::RackEnd::eight_wrong_pocket:
      return "the 8 ball was pocketed where it was not called";
  }
  return "for no known reason";
}

std::string match_end_text(const match::Status& status, const Names& names) {
  if (!status.winner) return "The match is over.";
  const std::string winner = name_of(names, *status.winner) + " wins the match";
  if (status.end == match::MatchEnd::conceded) return winner + ": the opponent has conceded.";
  if (status.end == match::MatchEnd::abandoned) return winner + ": the opponent has left.";
  return winner + ".";
}

std::string shot_text(const match::Shoot& shoot, const std::string& name, bool breaking) {
  const double angle = std::atan2(shoot.direction.y, shoot.direction.x) * 180 / std::numbers::pi;
  std::string text = name + (breaking ? " breaks" : " shoots") + " at " +
                     decimals(shoot.speed_m_s, 2) + " m/s and " + decimals(angle, 2) + " degrees";
  const std::string tip = words_of(shoot.tip);
  if (!tip.empty()) text += ", the tip " + tip;
  const std::string call = words_of(shoot.call);
  if (shoot.call.safety) {
    text += ", calling a safety";
  } else if (!call.empty()) {
    text += ", calling the " + call;
  }
  return text + ".";
}

std::string of_command(const match::Start&, const std::string&, const match::Status&,
                       const Names&) {
  return "The match starts.";
}

std::string of_command(const match::Place& place, const std::string& name, const match::Status&,
                       const Names&) {
  return name + " places the " + words_of(place.ball) + " at (" + decimals(place.position.x, 3) +
         ", " + decimals(place.position.y, 3) + ") m.";
}

std::string of_command(const match::Shoot& shoot, const std::string& name,
                       const match::Status& before, const Names&) {
  return shot_text(shoot, name, before.game.breaking);
}

std::string of_command(const match::Choose& choose, const std::string& name, const match::Status&,
                       const Names&) {
  return name + " chooses to " + words_of(choose.option) + ".";
}

std::string of_command(const match::Concede&, const std::string& name, const match::Status&,
                       const Names&) {
  return name + " concedes.";
}

std::string of_command(const match::AgreeRerack&, const std::string& name, const match::Status&,
                       const Names&) {
  return name + " agrees to rack again.";
}

std::string of_command(const match::Abandoned& abandoned, const std::string&, const match::Status&,
                       const Names& names) {
  return name_of(names, abandoned.seat) + " has left for good.";
}

/// "on stripes", or nothing on an open table.
std::string group_text(const rules::GameStatus& game) {
  const std::size_t turn = rules::number(game.turn);
  if (turn >= game.groups.size() || game.groups[turn] == rules::Group::none) return {};
  return " on " + words_of(game.groups[turn]);
}

}  // namespace

std::string ruling_text(const rules::Ruling& ruling, rules::Seat seat, const Names& names) {
  std::vector<std::string> sentences;
  for (const rules::Foul foul : ruling.fouls) sentences.push_back("Foul: " + words_of(foul) + ".");
  if (ruling.illegal_break) {
    sentences.push_back(
        "The break is not legal: no ball was pocketed and fewer than four reached a cushion.");
  }
  if (!ruling.pocketed.empty()) {
    sentences.push_back("Pocketed: " + balls_in_words(ruling.pocketed) + ".");
  }
  if (!ruling.spotted.empty()) {
    sentences.push_back("Back on the table: " + balls_in_words(ruling.spotted) + ".");
  }
  if (ruling.group_won && *ruling.group_won != rules::Group::none) {
    sentences.push_back(name_of(names, seat) + " has " + words_of(*ruling.group_won) + ".");
  }
  if (ruling.rack_winner) {
    const std::string why =
        ruling.rack_end ? ": " + rack_end_text(*ruling.rack_end) : std::string();
    sentences.push_back(name_of(names, *ruling.rack_winner) + " wins the rack" + why + ".");
  }
  std::string text;
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : " ") + sentence;
  return text;
}

std::string status_text(const match::Status& status, const Names& names) {
  if (status.stage == match::Stage::gathering) return "The match has not started.";
  if (status.stage == match::Stage::finished) return match_end_text(status, names);
  const rules::GameStatus& game = status.game;
  const std::string name = name_of(names, game.turn);
  if (!game.options.empty()) return name + " must choose: " + alternatives(game.options) + ".";
  std::string text = name + (game.breaking ? " breaks" : " shoots" + group_text(game));
  if (game.ball_in_hand == rules::BallInHand::anywhere) text += " with ball in hand";
  if (game.ball_in_hand == rules::BallInHand::behind_head_string) {
    text += " with ball in hand behind the head string";
  }
  return text + ".";
}

std::string score_text(const match::Status& status, const Names& names) {
  if (status.score.size() != 2) return {};
  return name_of(names, rules::Seat{0}) + " " + std::to_string(status.score[0]) + " : " +
         std::to_string(status.score[1]) + " " + name_of(names, rules::Seat{1});
}

std::string command_text(const match::Author& author, const match::Command& command,
                         const match::Status& before, const Names& names) {
  const std::string name = author.seat ? name_of(names, *author.seat) : "The server";
  return std::visit([&](const auto& kind) { return of_command(kind, name, before, names); },
                    command);
}

std::string match_text(const record::Header& header) {
  const match::Settings& settings = header.settings;
  std::string text = words_of(settings.game);
  if (settings.game == match::GameKind::eight_ball) {
    text += ", race to " + std::to_string(settings.race_to);
  }
  text += ", on the " + settings.preset + " table: ";
  const Names names = names_of(header);
  for (std::size_t seat = 0; seat < names.size(); ++seat) {
    if (seat > 0) text += settings.game == match::GameKind::eight_ball ? " against " : ", ";
    text += name_of(names, rules::Seat{static_cast<std::uint8_t>(seat)});
  }
  return text;
}

}  // namespace breakshot::client
