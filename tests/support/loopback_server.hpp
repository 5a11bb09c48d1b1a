// A server of one match on loopback, in a thread of the test's own: just enough of the protocol to
// see how a client takes it when the connection is cut at any step.
#pragma once

#include <array>
#include <atomic>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "common/lobby/lobby.hpp"
#include "common/wire/translate.hpp"

namespace breakshot::support {

/// One connection as the server sees it.
class Peer {
 public:
  explicit Peer(boost::asio::ip::tcp::socket& socket) : socket_(socket) {}

  /// The next request; nothing once the client has gone.
  std::optional<lobby::Asked> hear() {
    std::array<std::uint8_t, wire::frame_header_bytes> header{};
    boost::system::error_code error;
    boost::asio::read(socket_, boost::asio::buffer(header), error);
    if (error) return std::nullopt;
    std::size_t size = 0;
    for (const std::uint8_t byte : header) size = size * 256 + byte;
    std::vector<std::uint8_t> body(size);
    boost::asio::read(socket_, boost::asio::buffer(body), error);
    if (error) return std::nullopt;
    auto asked = wire::read_asked(body);
    if (!std::holds_alternative<lobby::Asked>(asked)) return std::nullopt;
    return std::get<lobby::Asked>(std::move(asked));
  }

  void tell(lobby::RequestId id, const lobby::Answer& answer) {
    say(wire::frame_of(lobby::Told{id, answer}));
  }

  void say(const std::vector<std::uint8_t>& bytes) {
    boost::system::error_code ignored;
    boost::asio::write(socket_, boost::asio::buffer(bytes), ignored);
  }

 private:
  boost::asio::ip::tcp::socket& socket_;
};

/// Serves one connection after the other, each by one call of `serve`, which returns when the
/// connection is to be closed.
class LoopbackServer {
 public:
  using Serve = std::function<void(Peer&)>;

  explicit LoopbackServer(Serve serve)
      : serve_(std::move(serve)),
        acceptor_(context_, {boost::asio::ip::address_v4::loopback(), 0}),
        port_(acceptor_.local_endpoint().port()),
        thread_([this] { run(); }) {}

  ~LoopbackServer() {
    ending_ = true;
    // Wakes the thread from accept; it may also be waiting for a client that is still connected.
    boost::asio::io_context context;
    boost::asio::ip::tcp::socket knock(context);
    boost::system::error_code ignored;
    knock.connect({boost::asio::ip::address_v4::loopback(), port_}, ignored);
    thread_.join();
  }
  LoopbackServer(const LoopbackServer&) = delete;
  LoopbackServer& operator=(const LoopbackServer&) = delete;

  std::uint16_t port() const { return port_; }

 private:
  void run() {
    while (true) {
      boost::asio::ip::tcp::socket socket(context_);
      boost::system::error_code error;
      acceptor_.accept(socket, error);
      if (ending_ || error) return;
      Peer peer(socket);
      serve_(peer);
    }
  }

  Serve serve_;
  boost::asio::io_context context_;
  boost::asio::ip::tcp::acceptor acceptor_;
  std::uint16_t port_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace breakshot::support
