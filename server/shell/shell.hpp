// Performs what the hub decides: its outputs on the net, the store and the log, and back to it what
// these report, with the time and fresh entropy. One thread, that of run(), does all of it but the
// store's own work.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "server/hub/limits.hpp"
#include "server/net/limits.hpp"

namespace breakshot::shell {

struct Settings {
  std::string address = "127.0.0.1";  ///< to listen at: an IPv4 or IPv6 address
  std::uint16_t port = 0;             ///< 0: any free one
  std::filesystem::path database;     ///< the store's file
  std::string version;                ///< what clients are told about the server
  hub::Limits hub;
  net::Limits net;
};

class Shell {
 public:
  /// Opens the store, restores its matches and listens. Throws std::runtime_error, which says what
  /// failed and why.
  explicit Shell(const Settings& settings);
  ~Shell();
  Shell(const Shell&) = delete;
  Shell& operator=(const Shell&) = delete;

  /// The port that is listened at.
  std::uint16_t port() const;
  /// Serves until SIGTERM or SIGINT: then everything is stored and everyone is told goodbye before
  /// it returns. A second signal ends the process at once.
  void run();

 private:
  class Works;
  std::unique_ptr<Works> works_;
};

}  // namespace breakshot::shell
