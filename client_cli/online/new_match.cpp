#include "client_cli/online/new_match.hpp"

#include <map>

#include "client_cli/command.hpp"
#include "common/physics/table.hpp"

namespace breakshot::client {

void OpeningOptions::add_to(CLI::App& parser) {
  match_.add_to(parser);
  parser.add_flag("--new", new_, "Open a new match instead of joining one");
  parser.add_flag("--private", private_, "Open a new match that takes an invite code to join");
  parser
      .add_option("--race", race_to_,
                  "Racks to win the match, up to " + std::to_string(match::max_race_to))
      ->check(CLI::Range(1u, static_cast<unsigned>(match::max_race_to)).description(""))
      ->type_name("N")
      ->capture_default_str();
  std::string names;
  for (const auto& preset : physics::presets()) {
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  }
  parser.add_option("--preset", preset_, "The table: " + names + " (default: the server's)")
      ->type_name("NAME");
  const std::map<std::string, match::GameKind> games = {{"8-ball", match::GameKind::eight_ball},
                                                        {"practice", match::GameKind::practice}};
  parser.add_option("--game", game_, "8-ball or practice")
      ->transform(CLI::CheckedTransformer(games).description(""))
      ->type_name("GAME");
  parser
      .add_option("--seats", seats_,
                  "Players of a practice, up to " + std::to_string(match::max_practice_seats))
      ->check(CLI::Range(1u, static_cast<unsigned>(match::max_practice_seats)).description(""))
      ->type_name("N")
      ->capture_default_str();
}

Opening OpeningOptions::opening() const {
  const auto name = match_.name();
  if (name && (new_ || private_)) {
    throw CommandError(
        "a match that exists cannot be opened anew: leave out MATCH and --code, or "
        "--new and --private",
        exit_usage);
  }
  if (name) return *name;
  // A practice is one's own affair: nobody expects to find a stranger's table.
  if (new_ || private_ || game_ == match::GameKind::practice) return create();
  return AnyMatch{create()};
}

lobby::Create OpeningOptions::create() const {
  const bool practice = game_ == match::GameKind::practice;
  return {preset_,
          game_,
          static_cast<std::uint8_t>(practice ? seats_ : 2),
          practice ? 1 : race_to_,
          private_,
          std::nullopt};
}

}  // namespace breakshot::client
