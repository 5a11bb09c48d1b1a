// A client for tests: one connection, blocking, with a deadline on everything. It says and hears
// what it is told to, right or wrong.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <variant>

#include "common/wire/translate.hpp"

namespace breakshot::support {

/// How long a test waits for what must come. Reached only where something is broken.
inline constexpr std::chrono::milliseconds patience = std::chrono::seconds(20);

class LineClient {
 public:
  struct Options {
    const char* from = "127.0.0.1";  ///< our own address
    int receive_buffer = 0;          ///< 0: the system's
  };

  LineClient() : LineClient(Options{}) {}
  /// A socket that is not connected yet.
  explicit LineClient(const Options& options)
      : fd_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    check(fd_, "socket");
    if (options.receive_buffer > 0) {
      check(::setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &options.receive_buffer, sizeof(int)),
            "setsockopt");
    }
    const sockaddr_in own = address(options.from, 0);
    check(::bind(fd_, reinterpret_cast<const sockaddr*>(&own), sizeof own), "bind");
  }
  explicit LineClient(std::uint16_t port) : LineClient(Options{}) { connect(port); }
  ~LineClient() { close(); }
  LineClient(LineClient&& other) noexcept
      : fd_(std::exchange(other.fd_, -1)),
        decoder_(std::move(other.decoder_)),
        input_(std::move(other.input_)) {}
  LineClient& operator=(LineClient&&) = delete;

  void connect(std::uint16_t port) {
    const sockaddr_in server = address("127.0.0.1", port);
    check(::connect(fd_, reinterpret_cast<const sockaddr*>(&server), sizeof server), "connect");
  }
  /// Whether the system connects in this time. It goes on trying if it does not.
  bool connects(std::uint16_t port, std::chrono::microseconds within) {
    const timeval limit{0, within.count()};
    check(::setsockopt(fd_, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit), "setsockopt");
    const sockaddr_in server = address("127.0.0.1", port);
    if (::connect(fd_, reinterpret_cast<const sockaddr*>(&server), sizeof server) == 0) return true;
    if (errno != EINPROGRESS) check(-1, "connect");
    return false;
  }
  void close() {
    if (fd_ >= 0) ::close(std::exchange(fd_, -1));
  }
  /// Closes so that the other side sees an error instead of an end.
  void reset() {
    const linger at_once{1, 0};
    check(::setsockopt(fd_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once), "setsockopt");
    close();
  }

  void send(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      check(static_cast<int>(sent), "send");
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
  }
  void say(const lobby::Asked& asked) { send(wire::frame_of(asked)); }
  /// The id is chosen here and returned.
  lobby::RequestId say(lobby::Request request) {
    const lobby::RequestId id{++last_id_};
    say(lobby::Asked{id, std::move(request)});
    return id;
  }

  /// The next that is told, or nothing once the other side has closed. Throws if neither comes, or
  /// if what comes is not of the protocol.
  std::optional<lobby::Told> hear() {
    std::array<std::uint8_t, 16384> chunk{};
    while (true) {
      std::span<const std::uint8_t> rest(input_);
      auto taken = decoder_.take(rest);
      input_.erase(input_.begin(), input_.end() - static_cast<std::ptrdiff_t>(rest.size()));
      if (const auto* body = std::get_if<wire::ByteVector>(&taken)) return told(*body);
      if (std::holds_alternative<wire::TooLong>(taken)) throw std::runtime_error("too long");
      pollfd readable{fd_, POLLIN, 0};
      if (::poll(&readable, 1, static_cast<int>(patience.count())) == 0) {
        throw std::runtime_error("nothing came, not even the end");
      }
      const ssize_t got = ::recv(fd_, chunk.data(), chunk.size(), 0);
      if (got == 0 || (got < 0 && errno == ECONNRESET)) return std::nullopt;
      check(static_cast<int>(got), "recv");
      input_.insert(input_.end(), chunk.begin(), chunk.begin() + got);
    }
  }
  /// The next that is told, which must be an `Answer`.
  template <class Answer>
  Answer hear_a() {
    const auto told = hear();
    if (!told) throw std::runtime_error("the connection was closed");
    if (const auto* answer = std::get_if<Answer>(&told->answer)) return *answer;
    if (const auto* refused = std::get_if<lobby::Refused>(&told->answer)) {
      throw std::runtime_error("refused: " + refused->what);
    }
    throw std::runtime_error("answer " + std::to_string(told->answer.index()) + " came instead");
  }

 private:
  static void check(int result, const char* what) {
    if (result < 0) throw std::system_error(errno, std::generic_category(), what);
  }
  static sockaddr_in address(const char* ip, std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    ::inet_pton(AF_INET, ip, &address.sin_addr);
    return address;
  }
  static lobby::Told told(const wire::ByteVector& body) {
    auto read = wire::read_told(body);
    if (const auto* wrong = std::get_if<wire::Malformed>(&read)) {
      throw std::runtime_error(wrong->fault.field + ": " + wrong->fault.what);
    }
    return std::get<lobby::Told>(std::move(read));
  }

  int fd_;
  std::uint32_t last_id_ = 0;
  wire::FrameDecoder decoder_{wire::max_answer_frame};
  wire::ByteVector input_;
};

}  // namespace breakshot::support
