#include "client_cli/online/stream.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/system/error_code.hpp>
#include <climits>

namespace breakshot::client {
namespace {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;

int poll_timeout(Milliseconds patience) {
  return static_cast<int>(std::clamp<Milliseconds::rep>(patience.count(), 0, INT_MAX));
}

[[noreturn]] void fail(const std::string& doing, const boost::system::error_code& error) {
  throw Lost(doing + ": " + error.message());
}

}  // namespace

struct Stream::Socket {
  asio::io_context context;
  asio::ip::tcp::socket tcp{context};
};

Stream::~Stream() = default;

Stream::Stream(const ServerAddress& server, Milliseconds patience)
    : socket_(std::make_unique<Socket>()) {
  const std::string doing = "cannot connect to " + text_of(server);
  boost::system::error_code error;
  tcp::resolver resolver(socket_->context);
  const auto endpoints = resolver.resolve(server.host, std::to_string(server.port),
                                          tcp::resolver::numeric_service, error);
  if (error) fail(doing, error);

  error = asio::error::timed_out;
  asio::async_connect(
      socket_->tcp, endpoints,
      [&error](const boost::system::error_code& result, const tcp::endpoint&) { error = result; });
  socket_->context.run_for(patience);
  if (error == asio::error::connection_refused) {
    throw Lost(doing + ": no server is listening there");
  }
  if (error) fail(doing, error);
  socket_->tcp.non_blocking(true, error);
  if (!error) socket_->tcp.set_option(tcp::no_delay(true), error);
  if (error) fail(doing, error);
}

void Stream::send(std::span<const std::uint8_t> bytes, Milliseconds patience) {
  while (!bytes.empty()) {
    boost::system::error_code error;
    const std::size_t sent =
        socket_->tcp.write_some(asio::buffer(bytes.data(), bytes.size()), error);
    bytes = bytes.subspan(sent);
    if (!error || error == asio::error::interrupted) continue;
    if (error != asio::error::would_block) fail("cannot send to the server", error);
    pollfd writable{socket_->tcp.native_handle(), POLLOUT, 0};
    if (::poll(&writable, 1, poll_timeout(patience)) == 0) {
      throw Lost("the server takes nothing any more");
    }
  }
}

Woke Stream::wait(int other, Milliseconds patience) {
  std::array<pollfd, 2> ends = {pollfd{socket_->tcp.native_handle(), POLLIN, 0},
                                pollfd{other, POLLIN, 0}};
  if (::poll(ends.data(), ends.size(), poll_timeout(patience)) <= 0) return Woke::timeout;
  return ends[0].revents != 0 ? Woke::stream : Woke::other;
}

std::size_t Stream::receive(std::span<std::uint8_t> buffer) {
  boost::system::error_code error;
  const std::size_t got = socket_->tcp.read_some(asio::buffer(buffer.data(), buffer.size()), error);
  if (!error) return got;
  if (error == asio::error::would_block || error == asio::error::interrupted) return 0;
  if (error == asio::error::eof) throw Lost("the server closed the connection");
  fail("cannot receive from the server", error);
}

}  // namespace breakshot::client
