// Every limit of carrying, in one place. What a frame may hold is limited by common/wire, what
// clients may order by server/hub.
#pragma once

#include <chrono>
#include <cstddef>

#include "common/wire/frame.hpp"
#include "server/hub/limits.hpp"

namespace breakshot::net {

struct Limits {
  // ---- Connections
  /// At once; one more is told Goodbye.
  std::size_t connections = hub::Limits{}.connections;
  /// At once from one address (an IPv4 address, or a /64 of IPv6).
  std::size_t connections_per_address = 64;
  /// Of those that were turned away, how many may be seen off at once; others are just closed.
  std::size_t turned_away = 64;
  /// Connections that the operating system keeps until they are accepted.
  int backlog = 128;

  // ---- Time
  /// From the connection to a good Hello.
  std::chrono::milliseconds hello_deadline = std::chrono::seconds(10);
  /// From one whole request to the next. Clients ping three times as often.
  std::chrono::milliseconds idle_deadline = std::chrono::seconds(60);
  /// From one byte that the other side took to the next, while some wait.
  std::chrono::milliseconds write_deadline = std::chrono::seconds(30);
  /// For the last words and the other side's closing.
  std::chrono::milliseconds close_deadline = std::chrono::seconds(5);
  /// How often the deadlines above are looked at.
  std::chrono::milliseconds check_interval = std::chrono::milliseconds(250);
  /// Before accepting again when the operating system refused, e.g. for want of descriptors.
  std::chrono::milliseconds accept_pause = std::chrono::milliseconds(100);

  // ---- Requests
  /// One in this long time on average; more have to wait, which slows down nobody else.
  std::chrono::microseconds request_interval = std::chrono::milliseconds(10);
  /// So many may come at once after a silence.
  int request_burst = 200;

  // ---- Memory, in bytes that wait to be sent on one connection. Frames that are told to many are
  // shared by them. A guest has room for two of the longest frames.
  std::size_t stranger_queue = 64 * 1024;
  std::size_t guest_queue = 2 * wire::max_answer_frame;
  std::size_t player_queue = 4 * wire::max_answer_frame;
  /// Read from, and given to, a socket at a time.
  std::size_t read_batch = 16 * 1024;
  std::size_t write_batch = 256 * 1024;
  /// Frames given to a socket at a time; no system takes more than 1024.
  std::size_t write_batch_frames = 64;
};

}  // namespace breakshot::net
