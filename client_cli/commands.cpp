#include "client_cli/commands/commands.hpp"

#include "client_cli/command.hpp"

namespace breakshot::client {

const std::vector<AddCommand>& commands() {
  static const std::vector<AddCommand> all = {add_play,     add_watch,  add_list,   add_bot,
                                              add_export,   add_replay, add_render, add_verify,
                                              add_simulate, add_audit};
  return all;
}

}  // namespace breakshot::client
