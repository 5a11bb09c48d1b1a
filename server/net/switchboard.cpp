#include "server/net/switchboard.hpp"

#include <spdlog/spdlog.h>

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <exception>
#include <map>
#include <stdexcept>
#include <utility>

#include "server/net/connection.hpp"

namespace breakshot::net {
namespace asio = boost::asio;
using asio::ip::tcp;

namespace {

constexpr auto quietly = asio::as_tuple(asio::use_awaitable);

void rethrow(std::exception_ptr error) {
  if (error) std::rethrow_exception(error);
}

/// What a connection counts for: an IPv4 address, or the /64 that one household of IPv6 has.
std::string counted_address(const asio::ip::address& address) {
  if (address.is_v4()) return address.to_string();
  asio::ip::address_v6 v6 = address.to_v6();
  if (v6.is_v4_mapped()) {
    return asio::ip::make_address_v4(asio::ip::v4_mapped, v6).to_string();
  }
  asio::ip::address_v6::bytes_type bytes = v6.to_bytes();
  std::fill(bytes.begin() + 8, bytes.end(), std::uint8_t{0});
  return asio::ip::address_v6(bytes).to_string();
}

tcp::acceptor listening(asio::io_context& context, const std::string& address, std::uint16_t port,
                        int backlog) {
  boost::system::error_code error;
  const asio::ip::address ip = asio::ip::make_address(address, error);
  if (error) {
    throw std::runtime_error("cannot listen at '" + address + "': it is no IPv4 or IPv6 address");
  }
  tcp::acceptor acceptor(context);
  const tcp::endpoint endpoint(ip, port);
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error && ip.is_v6()) acceptor.set_option(asio::ip::v6_only(false), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(backlog, error);
  if (error) {
    throw std::runtime_error("cannot listen at " + address + " port " + std::to_string(port) +
                             ": " + error.message());
  }
  return acceptor;
}

}  // namespace

class Switchboard::Lines {
 public:
  Lines(asio::io_context& context, const std::string& address, std::uint16_t port,
        const Limits& limits, std::function<void(Heard)> heard)
      : limits_(limits),
        heard_(std::move(heard)),
        acceptor_(listening(context, address, port, limits.backlog)),
        port_(acceptor_.local_endpoint().port()),
        accept_pause_(context),
        check_timer_(context) {
    reports_.asked = [this](Connection& from, lobby::Asked asked) {
      heard_(Asked{from.id(), std::move(asked)});
    };
    reports_.drained = [this](Connection& from) { heard_(hub::Drained{from.id()}); };
    reports_.ended = [this](Connection& from) { ended(from); };
  }

  void start(const std::shared_ptr<Lines>& self) {
    const auto accepting = [self] { return self->accept(); };
    const auto checking = [self] { return self->check(); };
    asio::co_spawn(acceptor_.get_executor(), accepting, rethrow);
    asio::co_spawn(acceptor_.get_executor(), checking, rethrow);
  }

  std::uint16_t port() const { return port_; }

  Connection* find(hub::ConnectionId id) const {
    const auto found = open_.find(id);
    return found == open_.end() ? nullptr : found->second.get();
  }

  void stop_listening() {
    boost::system::error_code ignored;
    acceptor_.close(ignored);
    accept_pause_.cancel();
  }

  void when_empty(std::function<void()> then) {
    empty_ = std::move(then);
    report_empty();
  }

  void stop() {
    stop_listening();
    stopped_ = true;
    check_timer_.cancel();
  }

 private:
  asio::awaitable<void> accept() {
    while (acceptor_.is_open()) {
      tcp::socket socket(acceptor_.get_executor());
      const auto [error] = co_await acceptor_.async_accept(socket, quietly);
      if (!error) {
        accepted(std::move(socket));
      } else if (acceptor_.is_open()) {
        spdlog::warn("a connection could not be accepted: {}", error.message());
        accept_pause_.expires_after(limits_.accept_pause);
        co_await accept_pause_.async_wait(quietly);
      }
    }
  }

  void accepted(tcp::socket socket) {
    boost::system::error_code error;
    const tcp::endpoint remote = socket.remote_endpoint(error);
    if (error) return;  // gone already
    const std::string address = counted_address(remote.address());
    const hub::ConnectionId id{++last_id_};
    const auto connection =
        std::make_shared<Connection>(id, std::move(socket), address, limits_, reports_);
    if (open_.size() >= limits_.connections) {
      return turn_away(connection, "the server is full");
    }
    if (per_address_[address] >= limits_.connections_per_address) {
      return turn_away(connection, "there are too many connections from your address");
    }
    ++per_address_[address];
    open_.emplace(id, connection);
    spdlog::debug("connection {} from {}", last_id_, address);
    connection->start();
    heard_(hub::Opened{id});
  }

  void turn_away(const std::shared_ptr<Connection>& connection, const std::string& why) {
    spdlog::debug("turned away a connection from {}: {}", connection->address(), why);
    if (turned_away_.size() >= limits_.turned_away) return;
    turned_away_.emplace(connection->id(), connection);
    connection->start();
    connection->end(lobby::GoodbyeReason::too_many, why);
  }

  void ended(Connection& from) {
    const hub::ConnectionId id = from.id();
    if (turned_away_.erase(id) == 0) {
      const auto count = per_address_.find(from.address());
      if (--count->second == 0) per_address_.erase(count);
      open_.erase(id);
      spdlog::debug("connection {} closed", static_cast<std::uint64_t>(id));
      heard_(hub::Closed{id});
    }
    report_empty();
  }

  asio::awaitable<void> check() {
    while (!stopped_) {
      check_timer_.expires_after(limits_.check_interval);
      co_await check_timer_.async_wait(quietly);
      const Clock::time_point now = Clock::now();
      for (const auto& [id, connection] : open_) connection->check(now);
      for (const auto& [id, connection] : turned_away_) connection->check(now);
    }
  }

  void report_empty() {
    if (!empty_ || !open_.empty() || !turned_away_.empty()) return;
    asio::post(acceptor_.get_executor(), std::exchange(empty_, nullptr));
  }

  const Limits limits_;
  const std::function<void(Heard)> heard_;
  Reports reports_;
  tcp::acceptor acceptor_;
  const std::uint16_t port_;
  asio::steady_timer accept_pause_;
  asio::steady_timer check_timer_;
  bool stopped_ = false;
  std::uint64_t last_id_ = 0;
  std::map<hub::ConnectionId, std::shared_ptr<Connection>> open_;
  std::map<std::string, std::size_t> per_address_;
  /// Not the hub's business: they are only told why they cannot stay.
  std::map<hub::ConnectionId, std::shared_ptr<Connection>> turned_away_;
  std::function<void()> empty_;
};

Switchboard::Switchboard(asio::io_context& context, const std::string& address, std::uint16_t port,
                         const Limits& limits, std::function<void(Heard)> heard)
    : lines_(std::make_shared<Lines>(context, address, port, limits, std::move(heard))) {
  lines_->start(lines_);
}

Switchboard::~Switchboard() {
  lines_->stop();
}

std::uint16_t Switchboard::port() const {
  return lines_->port();
}

void Switchboard::tell(const std::vector<hub::ConnectionId>& to, const lobby::Told& told) {
  FramePointer frame;
  for (const hub::ConnectionId id : to) {
    Connection* connection = lines_->find(id);
    if (connection == nullptr) continue;
    if (!frame) frame = std::make_shared<const wire::ByteVector>(wire::frame_of(told));
    connection->send(frame);
  }
}

void Switchboard::report_drained(hub::ConnectionId id) {
  if (Connection* connection = lines_->find(id)) connection->report_drained();
}

void Switchboard::treat(hub::ConnectionId id, hub::Standing standing) {
  if (Connection* connection = lines_->find(id)) connection->treat(standing);
}

void Switchboard::close(hub::ConnectionId id) {
  if (Connection* connection = lines_->find(id)) connection->close();
}

void Switchboard::stop_listening() {
  lines_->stop_listening();
}

void Switchboard::when_empty(std::function<void()> then) {
  lines_->when_empty(std::move(then));
}

}  // namespace breakshot::net
