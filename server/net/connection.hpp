// One client's line: frames out of what arrives, and a bounded queue of what is to be sent. One
// reader and one writer coroutine; everything happens on one thread.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/wire/frame.hpp"
#include "common/wire/translate.hpp"
#include "server/hub/hub.hpp"
#include "server/net/limits.hpp"

namespace breakshot::net {

using Clock = std::chrono::steady_clock;
using FramePointer = std::shared_ptr<const wire::ByteVector>;

class Connection;

/// What a connection reports. It must outlive the connection's coroutines.
struct Reports {
  std::function<void(Connection&, lobby::Asked)> asked;
  std::function<void(Connection&)> drained;
  /// Nothing more will come of it.
  std::function<void(Connection&)> ended;
};

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(hub::ConnectionId id, boost::asio::ip::tcp::socket socket, std::string address,
             const Limits& limits, const Reports& reports);

  /// Starts reading and writing. `ended` is reported once, after this.
  void start();

  hub::ConnectionId id() const { return id_; }
  /// The address that it counts for.
  const std::string& address() const { return address_; }

  /// Queues a frame. If no more may wait, the connection is ended: too slow.
  void send(FramePointer frame);
  /// Reports `drained` once everything sent so far has been given to the socket.
  void report_drained();
  void treat(hub::Standing standing);
  /// Reads no further request, and closes when what was queued is sent and the other side has
  /// closed too, or at the deadline.
  void close();
  /// Says goodbye, then closes.
  void end(lobby::GoodbyeReason reason, const std::string& what);
  /// Closes at once, whatever waits.
  void abort();
  /// Looks at the deadlines.
  void check(Clock::time_point now);

 private:
  boost::asio::awaitable<void> read();
  boost::asio::awaitable<void> write();
  boost::asio::awaitable<void> hold_back();
  void take_request(const wire::ByteVector& body);
  std::vector<boost::asio::const_buffer> next_batch();
  void written(std::size_t bytes);
  void wake_writer();
  void coroutine_ended();

  const hub::ConnectionId id_;
  boost::asio::ip::tcp::socket socket_;
  const std::string address_;
  const Limits& limits_;
  const Reports& reports_;
  int coroutines_ = 2;

  hub::Standing standing_ = hub::Standing::stranger;
  bool closing_ = false;
  Clock::time_point close_by_ = Clock::time_point::max();
  const Clock::time_point opened_ = Clock::now();

  // Reading
  wire::ByteVector input_;
  wire::FrameDecoder decoder_{wire::max_hello_frame};
  Clock::time_point heard_ = opened_;
  Clock::time_point next_request_ = opened_;  ///< see hold_back
  boost::asio::steady_timer pause_;

  // Writing
  std::deque<FramePointer> queue_;
  std::size_t in_flight_ = 0;       ///< frames at its front that the system is reading from
  std::size_t front_written_ = 0;   ///< bytes of the first frame that have been sent
  std::uint64_t bytes_queued_ = 0;  ///< since the beginning
  std::uint64_t bytes_sent_ = 0;    ///< since the beginning
  std::deque<std::uint64_t> drain_marks_;
  Clock::time_point progress_ = opened_;
  boost::asio::steady_timer writable_;  ///< expires never: cancelled when there is work
};

}  // namespace breakshot::net
