// The program `breakshot`: reads the command line and runs one command.
#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "client_cli/command.hpp"
#include "client_cli/server_address.hpp"
#include "common/lobby/lobby.hpp"

namespace breakshot::client {
namespace {

int complain(const std::string& what, int status) {
  std::cout.flush();
  std::cerr << "breakshot: " << what << '\n';
  return status;
}

void add_globals(CLI::App& program, Globals& globals) {
  globals.server = text_of({"127.0.0.1", lobby::default_port});
  // Options of the program may follow the command's name as well.
  program.fallthrough();
  program.set_version_flag("--version", "breakshot " BREAKSHOT_VERSION);
  program.add_option("--server", globals.server, "The server to talk to")
      ->type_name("HOST[:PORT]")
      ->capture_default_str();
  program.add_flag("--json", globals.json, "Print one JSON object a line");
  const std::map<std::string, Colour> colours = {
      {"auto", Colour::automatic}, {"always", Colour::always}, {"never", Colour::never}};
  program.add_option("--colour,--color", globals.colour, "Use colour: auto, always or never")
      ->transform(CLI::Transformer(colours).description(""))
      ->type_name("WHEN");
}

int parse_and_run(int argc, char** argv) {
  CLI::App program("Pool over the network: play, watch, replay, verify and draw matches.",
                   "breakshot");
  Globals globals;
  add_globals(program, globals);
  program.require_subcommand(1);
  std::vector<Command> added;
  for (const AddCommand add : commands()) added.push_back(add(program, globals));

  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return program.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    const auto chosen = program.get_subcommands();
    const auto unread = program.remaining();
    if (chosen.empty() && !unread.empty()) {
      return complain(unread.front() + ": no such command\nTry 'breakshot --help'.", exit_usage);
    }
    const std::string name = chosen.empty() ? "" : " " + chosen.front()->get_name();
    return complain(std::string(error.what()) + "\nTry 'breakshot" + name + " --help'.",
                    exit_usage);
  }
  for (const Command& command : added) {
    if (!command.parser->parsed()) continue;
    const int status = command.run();
    // A full disk or a closed pipe must not look like success.
    std::cout.flush();
    if (!std::cout) return complain("standard output: cannot be written", exit_failed);
    return status;
  }
  return exit_usage;
}

}  // namespace
}  // namespace breakshot::client

int main(int argc, char** argv) {
  using namespace breakshot::client;
  try {
    return parse_and_run(argc, argv);
  } catch (const CommandError& error) {
    return complain(error.what(), error.status());
  } catch (const std::exception& error) {
    return complain(error.what(), exit_failed);
  }
}
