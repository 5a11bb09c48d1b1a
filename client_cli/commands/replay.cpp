// `breakshot replay MATCH`: shows a stored match, in a terminal or as text.
#include <iostream>

#include "client_cli/account.hpp"
#include "client_cli/commands/commands.hpp"
#include "client_cli/draw/terminal.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/play_shot.hpp"
#include "client_cli/stored_match.hpp"

namespace breakshot::client {
namespace {

struct Options {
  std::string match;
  std::string name;
  std::optional<std::uint32_t> shot;
  double speed = 1;
  bool paused = false;
  bool step = false;
  bool velocities = false;
  bool paths = false;
  bool text = false;
};

/// The shots to be shown: one, or all.
std::vector<StoredShot> chosen_shots(const record::Record& record, const Options& options) {
  std::vector<StoredShot> shots = shots_of(record);
  if (!options.shot) return shots;
  return {shot_of(shots, *options.shot)};
}

void print_text(const record::Record& record, const Options& options) {
  for (const std::string& line : heading_of(record)) std::cout << line << '\n';
  const std::vector<StoredShot> shots = chosen_shots(record, options);
  Account account(names_of(record.header));
  for (const record::Entry& entry : record.entries) {
    const auto lines = account.lines_of(entry, options.step);
    if (options.shot && shots.front().entry != &entry) continue;
    for (const std::string& line : lines) std::cout << line << '\n';
  }
}

void print_json(const record::Record& record, const Options& options) {
  const std::vector<StoredShot> shots = chosen_shots(record, options);
  Account account(names_of(record.header));
  for (const record::Entry& entry : record.entries) {
    const Json line = account.json_of(entry);
    if (options.shot && shots.front().entry != &entry) continue;
    std::cout << line.text() << '\n';
  }
}

/// "Shot 3 of 20, rack 1, Ada 0 : 0 Bob".
std::string place_text(const StoredShot& shot, std::size_t shots, const Names& names) {
  const std::string place = "Shot " + std::to_string(shot.number) + " of " + std::to_string(shots) +
                            ", rack " + std::to_string(shot.before.rack);
  const std::string score = score_text(shot.before, names);
  return score.empty() ? place : place + ", " + score;
}

/// What the shot meant and what is next.
std::string outcome_text(const record::Entry& entry, const Names& names) {
  const rules::Seat seat = entry.author.seat.value_or(rules::Seat{0});
  std::string text =
      entry.outcome.ruling ? ruling_text(*entry.outcome.ruling, seat, names) : std::string();
  return text + (text.empty() ? "" : " ") + status_text(entry.outcome.status, names);
}

int play(const record::Record& record, const Options& options, const Abilities& abilities) {
  const std::vector<StoredShot> shots = shots_of(record);
  const Names names = names_of(record.header);
  const Table table = table_of(record.header.settings.scene);
  PlaybackOptions playback;
  playback.speed = options.speed;
  playback.paused = options.paused || options.step;
  playback.velocities = options.velocities;
  playback.paths = options.paths;
  std::size_t next = options.shot ? shot_of(shots, *options.shot).number - 1 : 0;
  if (shots.empty()) throw CommandError(options.match + ": no shot has been played yet");
  Terminal terminal(abilities);
  while (next < shots.size()) {
    const StoredShot& shot = shots[next];
    playback.stay = options.shot || next + 1 == shots.size();
    playback.cue = cue_vector_of(*shot.entry);
    playback.pocketed = shot.pocketed;
    playback.caption = command_text(shot.entry->author, shot.entry->command, shot.before, names);
    playback.lines = {place_text(shot, shots.size(), names)};
    playback.ruling = outcome_text(*shot.entry, names);
    const Played played = play_shot(terminal, table, shot.shot(), playback);
    if (played.ended_by == PlaybackKey::quit) break;
    if (played.ended_by == PlaybackKey::previous_shot) {
      next -= next > 0 ? 1 : 0;
    } else if (next + 1 < shots.size() || played.ended_by == PlaybackKey::none) {
      ++next;
    }
    playback.speed = played.speed;
    playback.paused = played.paused;
    playback.velocities = played.velocities;
    playback.paths = played.paths;
  }
  return exit_done;
}

int replay(const Options& options, const Globals& globals) {
  const StoredMatch match = open_match(options.match, globals, options.name);
  const Abilities abilities = abilities_of(globals.colour);
  if (globals.json) {
    print_json(match.record, options);
  } else if (options.text || !abilities.interactive) {
    print_text(match.record, options);
  } else {
    play(match.record, options, abilities);
  }
  if (match.damage) throw CommandError(options.match + ": " + damage_text(match));
  return exit_done;
}

}  // namespace

Command add_replay(CLI::App& program, const Globals& globals) {
  auto options = std::make_shared<Options>();
  CLI::App* parser =
      program.add_subcommand("replay", "Show a stored match in the terminal, or tell it as text");
  parser
      ->add_option("MATCH", options->match,
                   "A .breakshot file, - for standard input, or the id of a match on the server")
      ->required();
  add_guest_name(*parser, options->name);
  parser->add_option("--shot", options->shot, "Show only this shot, from 1")->type_name("N");
  parser->add_option("--speed", options->speed, "Speed of time, 1 is real")
      ->type_name("X")
      ->check(CLI::Range(min_speed, max_speed))
      ->capture_default_str();
  parser->add_flag("--paused", options->paused, "Start paused");
  parser->add_flag("--step", options->step,
                   "Start paused, to step with full stop and comma; as text, tell every event");
  parser->add_flag("--vectors", options->velocities, "Draw the balls' velocities");
  parser->add_flag("--paths", options->paths, "Draw the ways of the balls");
  parser->add_flag("--text", options->text, "Tell the match as text even in a terminal");
  parser->footer(
      "Keys: space pauses, full stop and comma step from event to event, left and right seek,\n"
      "+ and - change the speed, n and p go to the next and the previous shot, v shows\n"
      "velocities, t the tracks of the balls, q quits.\n"
      "Exit status: 0; 1 the file is damaged (its valid beginning is shown); 2 no such match.");
  return {parser, [options, &globals] { return replay(*options, globals); }};
}

}  // namespace breakshot::client
