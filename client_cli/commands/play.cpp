// breakshot play: a person plays, in a terminal or from a script.
#include <unistd.h>

#include <iostream>
#include <memory>
#include <string>

#include "client_cli/commands/commands.hpp"
#include "client_cli/draw/abilities.hpp"
#include "client_cli/online/connection.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/online/new_match.hpp"
#include "client_cli/play/session.hpp"
#include "client_cli/playback.hpp"

namespace breakshot::client {
namespace {

struct Options {
  OpeningOptions opening;
  std::string name = user_name();
  double speed = 1;
};

int play(const Options& options, const Globals& globals) {
  const Opening opening = options.opening.opening();
  const Abilities abilities = abilities_of(globals.colour);
  Connection connection(server_of(globals), guest_of(options.name),
                        [interactive = abilities.interactive,
                         notice = notice_on_standard_error()](const std::string& what) {
                          // Not behind the prompt.
                          if (interactive) std::cout << "\r\x1b[K" << std::flush;
                          notice(what);
                        });
  const Surroundings surroundings{std::cout,    abilities,     STDIN_FILENO,
                                  globals.json, options.speed, globals.server};
  Session session(connection, sit_down(connection, opening), surroundings);
  return session.run();
}

}  // namespace

Command add_play(CLI::App& program, const Globals& globals) {
  const auto options = std::make_shared<Options>();
  CLI::App* parser = program.add_subcommand("play", "Play a match");
  parser->footer(
      "Without MATCH, --code, --new or --private it goes back to a match of yours that is still\n"
      "running, joins an open one, or opens one. At the table, type help: aim, speed, tip and "
      "call\n"
      "prepare a shot, shoot plays it.\n"
      "Where input or output is no terminal, a line is read only when it is your turn.");
  options->opening.add_to(*parser);
  parser->add_option("--name", options->name, "The guest as whom you play")
      ->type_name("NAME")
      ->capture_default_str();
  parser
      ->add_option("--speed", options->speed,
                   "How fast shots are shown: 0.01 to 1000, 1 is real time")
      ->check(CLI::Range(min_speed, max_speed).description(""))
      ->type_name("X")
      ->capture_default_str();
  return {parser, [options, &globals] { return play(*options, globals); }};
}

}  // namespace breakshot::client
