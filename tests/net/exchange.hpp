// A switchboard on a thread of its own, with nobody behind it but the test.
#pragma once

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <condition_variable>
#include <deque>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <variant>

#include "server/net/switchboard.hpp"
#include "tests/support/line_client.hpp"

namespace breakshot::net {

using support::LineClient;
using support::patience;

/// Limits that no test reaches by accident, however slow the machine is.
inline Limits patient_limits() {
  Limits limits;
  limits.hello_deadline = limits.idle_deadline = limits.write_deadline = std::chrono::hours(1);
  limits.close_deadline = patience;
  limits.check_interval = std::chrono::milliseconds(5);
  return limits;
}

class Exchange {
 public:
  explicit Exchange(const Limits& limits = patient_limits())
      : board_(context_, "127.0.0.1", 0, limits, [this](Heard heard) { keep(std::move(heard)); }),
        thread_([this] { context_.run(); }) {}
  ~Exchange() {
    context_.stop();
    thread_.join();
  }

  std::uint16_t port() const { return board_.port(); }

  /// Does something on the switchboard's thread, to its end.
  template <class Act>
  void order(Act act) {
    std::promise<void> done;
    boost::asio::post(context_, [&] {
      act(board_);
      done.set_value();
    });
    done.get_future().get();
  }
  void tell(std::vector<hub::ConnectionId> to, lobby::Answer answer) {
    const lobby::Told told{{}, std::move(answer)};
    order([&](Switchboard& board) { board.tell(to, told); });
  }

  /// The next that is heard, which must be a `What` and come in time.
  template <class What>
  What hear() {
    std::unique_lock lock(mutex_);
    if (!news_.wait_for(lock, patience, [this] { return !heard_.empty(); })) {
      throw std::runtime_error("nothing was heard");
    }
    Heard next = std::move(heard_.front());
    heard_.pop_front();
    if (auto* what = std::get_if<What>(&next)) return std::move(*what);
    throw std::runtime_error("something else was heard: " + std::to_string(next.index()));
  }
  bool silent() {
    const std::lock_guard lock(mutex_);
    return heard_.empty();
  }
  /// From now on whoever connects has this standing at once, before any deadline is looked at.
  void welcome_as(hub::Standing standing) {
    order([&](Switchboard&) { newcomers_ = standing; });
  }
  /// Waits for a new connection.
  hub::ConnectionId opened() { return hear<hub::Opened>().connection; }

 private:
  void keep(Heard heard) {
    if (const auto* opened = std::get_if<hub::Opened>(&heard)) {
      board_.treat(opened->connection, newcomers_);
    }
    const std::lock_guard lock(mutex_);
    heard_.push_back(std::move(heard));
    news_.notify_one();
  }

  std::mutex mutex_;
  std::condition_variable news_;
  std::deque<Heard> heard_;
  hub::Standing newcomers_ = hub::Standing::stranger;  ///< the switchboard's thread's
  boost::asio::io_context context_;
  Switchboard board_;
  std::thread thread_;
};

/// News of about 100 kB, told apart by their numbers.
inline lobby::EntryNews big_news(std::uint32_t seq) {
  record::Entry entry;
  entry.seq = match::Seq{seq};
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const double x = 0.1 + i;
    entry.outcome.table.balls.push_back({physics::BallId{i}, {x, x}, {x, x}, {x, 0, 0}});
  }
  entry.outcome.status.score = {0, 0};
  return {match::MatchId{1}, std::make_shared<const record::Entry>(std::move(entry))};
}
inline std::uint32_t seq_of(const lobby::EntryNews& news) {
  return static_cast<std::uint32_t>(news.entry->seq);
}

}  // namespace breakshot::net
