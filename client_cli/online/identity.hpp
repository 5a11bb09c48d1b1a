// Who this machine is to its servers: for each server and guest name the secret token that makes
// the guest the same one again. Whoever reads a token can play as that guest, so nobody else may.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "client_cli/server_address.hpp"
#include "common/lobby/lobby.hpp"

namespace breakshot::client {

/// Where programs keep what should outlive them (XDG Base Directory Specification):
/// $XDG_STATE_HOME/breakshot, or ~/.local/state/breakshot where that is unset, empty or no absolute
/// path. CommandError if there is no home directory either.
std::filesystem::path state_directory();

/// The tokens under one directory, one file each. Everything that fails is a CommandError naming
/// the file.
class TokenStore {
 public:
  explicit TokenStore(std::filesystem::path directory) : directory_(std::move(directory)) {}

  /// Nothing if the guest has no token yet. A file that holds no token is an error, not a new
  /// guest: its owner may still be able to mend it.
  std::optional<lobby::Token> load(const ServerAddress& server, const std::string& name) const;

  /// Replaces the guest's token in one step, so that a crash leaves the old one or the new one.
  void save(const ServerAddress& server, const std::string& name, const lobby::Token& token) const;

  /// Writes a token that its server no longer knows beside the guest's, as <name>~, which is no
  /// file of any guest, and returns that file: the server may only have been started with other
  /// data.
  std::filesystem::path set_aside(const ServerAddress& server, const std::string& name,
                                  const lobby::Token& token) const;

  /// <directory>/tokens/<server>/<name>, with ASCII that is unfit for file names as
  /// %XX: the longest name is 128 bytes and stays below the 255 of a file name.
  std::filesystem::path file_of(const ServerAddress& server, const std::string& name) const;

 private:
  std::filesystem::path directory_;
};

/// 32 bytes from the operating system that nobody can guess.
std::array<std::uint8_t, 32> entropy();

}  // namespace breakshot::client
