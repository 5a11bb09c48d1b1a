#include "server/net/connection.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <exception>
#include <span>
#include <utility>
#include <variant>

namespace breakshot::net {
namespace asio = boost::asio;

namespace {

// g++ 12 destroys aggregate temporaries of a co_await expression twice and uses captures of lambda
// temporaries after they are gone. So what is awaited is built from named values only.

/// Errors are values: a connection that fails is nothing out of the ordinary.
constexpr auto quietly = asio::as_tuple(asio::use_awaitable);

/// A mistake of ours must end the program, not be swallowed by a coroutine that nobody awaits.
void rethrow(std::exception_ptr error) {
  if (error) std::rethrow_exception(error);
}

std::size_t queue_limit(const Limits& limits, hub::Standing standing) {
  switch (standing) {
    case hub::Standing::stranger:
      return limits.stranger_queue;
    case hub::Standing::guest:
      return limits.guest_queue;
    case hub::Standing::player:
      return limits.player_queue;
  }
  return 0;
}

std::uint64_t number(hub::ConnectionId id) {
  return static_cast<std::uint64_t>(id);
}

FramePointer frame_of(lobby::RequestId id, lobby::Answer answer) {
  return std::make_shared<const wire::ByteVector>(
      wire::frame_of(lobby::Told{id, std::move(answer)}));
}

}  // namespace

Connection::Connection(hub::ConnectionId id, asio::ip::tcp::socket socket, std::string address,
                       const Limits& limits, const Reports& reports)
    : id_(id),
      socket_(std::move(socket)),
      address_(std::move(address)),
      limits_(limits),
      reports_(reports),
      input_(limits.read_batch),
      pause_(socket_.get_executor()),
      writable_(socket_.get_executor(), Clock::time_point::max()) {}

void Connection::start() {
  boost::system::error_code ignored;
  socket_.set_option(asio::ip::tcp::no_delay(true), ignored);
  const auto self = shared_from_this();
  const auto reader = [self] { return self->read(); };
  const auto writer = [self] { return self->write(); };
  asio::co_spawn(socket_.get_executor(), reader, rethrow);
  asio::co_spawn(socket_.get_executor(), writer, rethrow);
}

// ---- What the owner orders

void Connection::send(FramePointer frame) {
  if (closing_) return;
  const std::uint64_t waiting = bytes_queued_ - bytes_sent_;
  if (waiting + frame->size() > queue_limit(limits_, standing_)) {
    spdlog::info("connection {} is too slow: {} bytes wait", number(id_), waiting);
    // What waits will not be taken in time; the client resumes from the last entry that it has.
    while (queue_.size() > in_flight_) {
      bytes_queued_ -= queue_.back()->size();
      queue_.pop_back();
    }
    return end(lobby::GoodbyeReason::too_slow,
               "too much was waiting to be sent; watch again from the last entry that arrived");
  }
  if (queue_.empty()) progress_ = Clock::now();
  bytes_queued_ += frame->size();
  queue_.push_back(std::move(frame));
  wake_writer();
}

void Connection::report_drained() {
  drain_marks_.push_back(bytes_queued_);
  wake_writer();
}

void Connection::treat(hub::Standing standing) {
  standing_ = standing;
  decoder_.set_limit(standing == hub::Standing::stranger ? wire::max_hello_frame
                                                         : wire::max_request_frame);
}

void Connection::close() {
  if (closing_) return;
  closing_ = true;
  close_by_ = Clock::now() + limits_.close_deadline;
  pause_.cancel();
  wake_writer();
}

void Connection::end(lobby::GoodbyeReason reason, const std::string& what) {
  if (closing_) return;
  FramePointer frame = frame_of({}, lobby::Goodbye{reason, what});
  bytes_queued_ += frame->size();
  queue_.push_back(std::move(frame));
  close();
}

void Connection::abort() {
  closing_ = true;
  boost::system::error_code ignored;
  socket_.close(ignored);
  pause_.cancel();
  wake_writer();
}

void Connection::check(Clock::time_point now) {
  if (!socket_.is_open()) return;
  if (closing_) {
    if (now >= close_by_) abort();
    return;
  }
  if (!queue_.empty() && now - progress_ >= limits_.write_deadline) {
    spdlog::info("connection {} takes nothing any more", number(id_));
    return abort();
  }
  if (standing_ == hub::Standing::stranger && now - opened_ >= limits_.hello_deadline) {
    return end(lobby::GoodbyeReason::idle, "no good hello came in time");
  }
  if (now - heard_ >= limits_.idle_deadline) {
    end(lobby::GoodbyeReason::idle, "nothing was heard for too long; send a ping now and then");
  }
}

// ---- Reading

asio::awaitable<void> Connection::read() {
  while (socket_.is_open()) {
    const auto buffer = asio::buffer(input_);
    const auto [error, received] = co_await socket_.async_read_some(buffer, quietly);
    if (error) break;
    // While it closes, what still comes is read and dropped: unread bytes would make the system
    // reset the connection, and the last words would be lost.
    if (closing_) continue;
    std::span<const std::uint8_t> rest(input_.data(), received);
    while (!closing_) {
      auto taken = decoder_.take(rest);
      if (auto* too_long = std::get_if<wire::TooLong>(&taken)) {
        end(lobby::GoodbyeReason::bad_protocol,
            "a frame of " + std::to_string(too_long->announced) + " bytes; at most " +
                std::to_string(too_long->limit) + " are read");
      }
      const auto* body = std::get_if<wire::ByteVector>(&taken);
      if (body == nullptr) break;
      heard_ = Clock::now();
      co_await hold_back();
      if (!closing_) take_request(*body);
    }
  }
  abort();
  coroutine_ended();
}

/// Waits until the next request may be taken: one an interval on average, a burst of them after a
/// silence. Meanwhile nothing is read, so that whoever asks too fast waits in his own queue.
asio::awaitable<void> Connection::hold_back() {
  const auto interval = limits_.request_interval;
  next_request_ = std::max(next_request_, heard_ - interval * limits_.request_burst) + interval;
  if (next_request_ <= heard_) co_return;
  pause_.expires_at(next_request_);
  co_await pause_.async_wait(quietly);
  heard_ = Clock::now();
}

void Connection::take_request(const wire::ByteVector& body) {
  auto read = wire::read_asked(body);
  if (auto* asked = std::get_if<lobby::Asked>(&read))
    return reports_.asked(*this, std::move(*asked));
  const auto& [id, fault] = std::get<wire::Malformed>(read);
  const std::string what = fault.field + ": " + fault.what;
  spdlog::debug("connection {} asked wrongly: {}", number(id_), what);
  if (!id) return end(lobby::GoodbyeReason::bad_protocol, what);
  send(frame_of(*id, lobby::Refused{lobby::RefusalCode::bad_request, std::nullopt, what}));
}

// ---- Writing

asio::awaitable<void> Connection::write() {
  while (socket_.is_open()) {
    written(0);
    if (queue_.empty()) {
      if (closing_) break;
      co_await writable_.async_wait(quietly);
      continue;
    }
    const std::vector<asio::const_buffer> batch = next_batch();
    in_flight_ = batch.size();
    const auto [error, sent] = co_await socket_.async_write_some(batch, quietly);
    in_flight_ = 0;
    if (error) {
      abort();
      break;
    }
    written(sent);
  }
  boost::system::error_code ignored;
  socket_.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  coroutine_ended();
}

std::vector<asio::const_buffer> Connection::next_batch() {
  std::vector<asio::const_buffer> batch;
  std::size_t size = 0;
  for (const FramePointer& frame : queue_) {
    if (size >= limits_.write_batch || batch.size() == limits_.write_batch_frames) break;
    const std::size_t skipped = batch.empty() ? front_written_ : 0;
    batch.emplace_back(frame->data() + skipped, frame->size() - skipped);
    size += frame->size() - skipped;
  }
  return batch;
}

/// Takes off the queue what was sent, and reports what has drained. Safe at any time.
void Connection::written(std::size_t bytes) {
  if (bytes > 0) progress_ = Clock::now();
  bytes_sent_ += bytes;
  front_written_ += bytes;
  while (!queue_.empty() && front_written_ >= queue_.front()->size()) {
    front_written_ -= queue_.front()->size();
    queue_.pop_front();
  }
  while (!drain_marks_.empty() && drain_marks_.front() <= bytes_sent_) {
    drain_marks_.pop_front();
    if (!closing_) reports_.drained(*this);
  }
}

void Connection::wake_writer() {
  writable_.cancel();
}

void Connection::coroutine_ended() {
  if (--coroutines_ == 0) reports_.ended(*this);
}

}  // namespace breakshot::net
