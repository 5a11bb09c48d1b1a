#include "client_cli/command.hpp"
#include "client_cli/commands/commands.hpp"

namespace breakshot::client {

const std::vector<AddCommand>& commands() {
  static const std::vector<AddCommand> all = {add_simulate};
  return all;
}

}  // namespace breakshot::client
