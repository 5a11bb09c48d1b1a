// The commands of the program, one file each.
#pragma once

#include "client_cli/command.hpp"

namespace breakshot::client {

Command add_audit(CLI::App& program, const Globals& globals);
Command add_bot(CLI::App& program, const Globals& globals);
Command add_export(CLI::App& program, const Globals& globals);
Command add_list(CLI::App& program, const Globals& globals);
Command add_play(CLI::App& program, const Globals& globals);
Command add_render(CLI::App& program, const Globals& globals);
Command add_replay(CLI::App& program, const Globals& globals);
Command add_simulate(CLI::App& program, const Globals& globals);
Command add_verify(CLI::App& program, const Globals& globals);
Command add_watch(CLI::App& program, const Globals& globals);

}  // namespace breakshot::client
