#include "client_cli/command.hpp"

namespace breakshot::client {

const std::vector<AddCommand>& commands() {
  static const std::vector<AddCommand> all = {};
  return all;
}

}  // namespace breakshot::client
