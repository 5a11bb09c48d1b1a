// All clients' lines by their number: who is told what, and what is heard from whom. The listener
// and its connections live on the thread of one io_context; nothing here may be called from
// another.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "common/lobby/lobby.hpp"
#include "server/hub/hub.hpp"
#include "server/net/limits.hpp"

namespace boost::asio {
class io_context;
}

namespace breakshot::net {

/// A well-formed request. Others are refused here.
struct Asked {
  hub::ConnectionId connection{};
  lobby::Asked asked;
};

/// What is heard, for the hub; a connection is Opened first and Closed last.
using Heard = std::variant<hub::Opened, Asked, hub::Drained, hub::Closed>;

class Switchboard {
 public:
  /// Listens at an address (an IPv4 or IPv6 address, no name) and port; 0 is any free one. Throws
  /// std::runtime_error, which says what cannot be listened at and why. `heard` is called from the
  /// io_context's thread; it may call back. Must outlive the run of `context`.
  Switchboard(boost::asio::io_context& context, const std::string& address, std::uint16_t port,
              const Limits& limits, std::function<void(Heard)> heard);
  ~Switchboard();

  /// The port that is listened at.
  std::uint16_t port() const;

  /// Encodes once for all. Those that are gone are passed over.
  void tell(const std::vector<hub::ConnectionId>& to, const lobby::Told& told);
  /// Hears Drained when everything told so far has been given to the socket.
  void report_drained(hub::ConnectionId id);
  void treat(hub::ConnectionId id, hub::Standing standing);
  /// Closes when everything told has been sent, or at a deadline.
  void close(hub::ConnectionId id);

  void stop_listening();
  /// Calls once, when there is no connection left, which may be now.
  void when_empty(std::function<void()> then);

 private:
  class Lines;
  std::shared_ptr<Lines> lines_;
};

}  // namespace breakshot::net
