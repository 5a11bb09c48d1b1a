#include "client_cli/read_input.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "client_cli/command_error.hpp"

namespace breakshot::client {
namespace {

std::string all_of(std::istream& stream) {
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

std::string read_input(const std::string& name) {
  if (name == "-") return all_of(std::cin);
  // A folder opens, and fails only when it is read.
  std::error_code none;
  const bool is_folder = std::filesystem::is_directory(name, none);
  errno = 0;
  std::ifstream file(name, std::ios::binary);
  if (file && !is_folder) return all_of(file);
  throw CommandError(name + ": cannot be read: " + std::strerror(is_folder ? EISDIR : errno),
                     exit_usage);
}

}  // namespace breakshot::client
