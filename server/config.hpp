// What whoever runs the server has decided, read from the command line and a file.
#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "server/shell/shell.hpp"

namespace breakshot::server {

struct Config {
  shell::Settings shell;  ///< its database is the store's file in `data`
  std::filesystem::path data;
  std::string log_level;  ///< one of spdlog's
};

/// The program is to end without serving.
struct Exit {
  int status = 0;
  std::string out;  ///< for standard output: what was asked for
  std::string err;  ///< for standard error: what is wrong and what would be right
};

std::variant<Config, Exit> config_of(int argc, const char* const* argv);

/// The command with which others join a server that listens at `address` and `port`.
std::string join_command(const std::string& address, std::uint16_t port);

}  // namespace breakshot::server
