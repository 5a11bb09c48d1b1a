// Bytes to and from a server, and waiting for them. Everything here happens on the caller's thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include "client_cli/server_address.hpp"

namespace breakshot::client {

using Milliseconds = std::chrono::milliseconds;

/// The connection is no more, or never was; `what` says why. Coming back later may help.
class Lost : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Why a wait ended.
enum class Woke { stream, other, timeout };

class Stream {
 public:
  /// Connects to the first of the host's addresses that answers. Throws Lost, also after
  /// `patience`.
  Stream(const ServerAddress& server, Milliseconds patience);
  ~Stream();
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// Sends all bytes. Throws Lost, also where the server takes nothing for `patience`.
  void send(std::span<const std::uint8_t> bytes, Milliseconds patience);

  /// Waits until there is something to receive, `other` (a file descriptor, or -1) can be read, or
  /// the time is over. A signal may end the wait early, as a timeout. The stream goes before
  /// `other`.
  Woke wait(int other, Milliseconds patience);

  /// What has arrived, at most `buffer.size()` bytes; 0 if there is nothing yet. Throws Lost where
  /// the server has closed the connection.
  std::size_t receive(std::span<std::uint8_t> buffer);

 private:
  struct Socket;
  std::unique_ptr<Socket> socket_;  ///< keeps Asio's headers out of this one
};

}  // namespace breakshot::client
