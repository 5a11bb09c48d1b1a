// A thread with a queue: carries out what it is given, in order, as much at a time as has come.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace breakshot::store {

template <class Work>
class Worker {
 public:
  /// `carry_out` is called on the thread with at least one and at most `most` pieces of work. It
  /// must not throw.
  Worker(std::size_t most, std::function<void(std::vector<Work>)> carry_out)
      : most_(most), carry_out_(std::move(carry_out)), thread_([this] { loop(); }) {}

  /// Waits until everything that was given is carried out.
  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void give(Work work) {
    {
      const std::lock_guard lock(mutex_);
      queue_.push_back(std::move(work));
    }
    changed_.notify_one();
  }

 private:
  void loop() {
    while (true) {
      std::vector<Work> group;
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return ending_ || !queue_.empty(); });
        if (queue_.empty()) return;
        while (!queue_.empty() && group.size() < most_) {
          group.push_back(std::move(queue_.front()));
          queue_.pop_front();
        }
      }
      carry_out_(std::move(group));
    }
  }

  const std::size_t most_;
  const std::function<void(std::vector<Work>)> carry_out_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Work> queue_;
  bool ending_ = false;
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace breakshot::store
