// The commands of the program, one file each.
#pragma once

#include "client_cli/command.hpp"

namespace breakshot::client {

Command add_simulate(CLI::App& program, const Globals& globals);

}  // namespace breakshot::client
