// A hub without sockets: connections are inboxes, the store is memory, the clock is a number. By
// default everything that the hub orders is done at once; a test that wants to stand in between
// holds the store or the connections and lets go itself.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "server/hub/hub.hpp"
#include "tests/support/memory_store.hpp"

namespace breakshot::support {

using std::chrono::milliseconds;

class HubRig {
 public:
  explicit HubRig(const hub::Limits& limits = {}, Kept kept = {})
      : hub_("test", limits),
        store_([this](ledger::Report report) { step(std::move(report)); }, std::move(kept)) {
    store_.restore([this](ledger::Restored restored) { step(std::move(restored)); });
  }

  // ---- The world

  hub::Now now{milliseconds(1'000'000), 1'700'000'000'000};
  bool hold_store = false;   ///< orders wait for store().work()
  bool hold_drains = false;  ///< ReportDrained waits for drain()

  MemoryStore& store() { return store_; }
  const Kept& kept() const { return store_.kept(); }

  void pass(milliseconds time) {
    now.steady += time;
    now.unix_ms += time.count();
  }
  void tick() { step(hub::Tick{}); }
  void settle() {
    while (store_.work()) {
    }
  }
  void let_store_go() {
    hold_store = false;
    settle();
  }

  // ---- Connections

  hub::ConnectionId open() {
    const hub::ConnectionId id{++last_connection_};
    step(hub::Opened{id});
    return id;
  }
  void close(hub::ConnectionId id) { step(hub::Closed{id}); }
  void drain(hub::ConnectionId id) {
    if (draining_.erase(id) > 0) step(hub::Drained{id});
  }
  bool is_draining(hub::ConnectionId id) const { return draining_.contains(id); }
  bool is_closing(hub::ConnectionId id) const { return closing_.contains(id); }
  hub::Standing standing(hub::ConnectionId id) const {
    const auto found = standings_.find(id);
    return found == standings_.end() ? hub::Standing::stranger : found->second;
  }

  /// Sends a request; the answer is read with `answer`.
  lobby::RequestId ask(hub::ConnectionId id, lobby::Request request) {
    const lobby::RequestId request_id{++last_request_};
    hub::Entropy entropy{};
    for (auto& byte : entropy) byte = static_cast<std::uint8_t>(random_());
    step(hub::Asked{id, {request_id, std::move(request)}, entropy});
    return request_id;
  }

  /// Everything that the connection was told, in order.
  const std::vector<std::shared_ptr<const lobby::Told>>& inbox(hub::ConnectionId id) {
    return inboxes_[id];
  }
  void forget(hub::ConnectionId id) { inboxes_[id].clear(); }

  /// The answers of one kind that the connection was told, asked for or not.
  template <class Kind>
  std::vector<Kind> told(hub::ConnectionId id) {
    std::vector<Kind> found;
    for (const auto& told : inboxes_[id]) {
      if (const auto* answer = std::get_if<Kind>(&told->answer)) found.push_back(*answer);
    }
    return found;
  }

  /// Everything that was told under a request's id, in order.
  std::vector<lobby::Answer> answers(hub::ConnectionId id, lobby::RequestId request) {
    std::vector<lobby::Answer> found;
    for (const auto& told : inboxes_[id]) {
      if (told->id == request) found.push_back(told->answer);
    }
    return found;
  }
  /// The answer of a request that has exactly one, and of this kind.
  template <class Kind>
  Kind answer(hub::ConnectionId id, lobby::RequestId request) {
    const auto found = answers(id, request);
    if (found.size() != 1) {
      throw std::runtime_error("the request has " + std::to_string(found.size()) + " answers");
    }
    if (const auto* kind = std::get_if<Kind>(&found.front())) return *kind;
    const auto* refused = std::get_if<lobby::Refused>(&found.front());
    throw std::runtime_error("the answer is of another kind" +
                             (refused ? ": refused, " + refused->what : std::string()));
  }
  /// Asks and reads the one answer.
  template <class Kind>
  Kind get(hub::ConnectionId id, lobby::Request request) {
    return answer<Kind>(id, ask(id, std::move(request)));
  }
  lobby::RefusalCode refusal(hub::ConnectionId id, lobby::Request request) {
    return get<lobby::Refused>(id, std::move(request)).code;
  }

  // ---- What the hub put out

  template <class Kind>
  std::vector<Kind> notes() const {
    std::vector<Kind> found;
    for (const hub::Note& note : notes_) {
      if (const auto* kind = std::get_if<Kind>(&note)) found.push_back(*kind);
    }
    return found;
  }
  bool stopped() const { return stopped_; }
  std::size_t loads() const { return loads_; }

  void step(hub::Input input) {
    inputs_.push_back(std::move(input));
    if (stepping_) return;
    stepping_ = true;
    while (!inputs_.empty()) {
      hub::Input next = std::move(inputs_.front());
      inputs_.pop_front();
      for (hub::Output& output : hub_.step(std::move(next), now)) {
        std::visit([&](auto& kind) { carry_out(std::move(kind)); }, output);
      }
      while (!hold_store && inputs_.empty() && store_.work()) {
      }
    }
    stepping_ = false;
  }

 private:
  void carry_out(hub::Tell tell) {
    for (const hub::ConnectionId id : tell.to) {
      if (!closing_.contains(id)) inboxes_[id].push_back(tell.told);
    }
  }
  void carry_out(hub::ReportDrained report) {
    if (hold_drains) {
      draining_.insert(report.connection);
    } else {
      inputs_.push_back(hub::Drained{report.connection});
    }
  }
  void carry_out(hub::Close close) { closing_.insert(close.connection); }
  void carry_out(hub::Treat treat) { standings_[treat.connection] = treat.as; }
  void carry_out(hub::Append append) { store_.append(append.ticket, std::move(append.batch)); }
  void carry_out(hub::Load load) {
    ++loads_;
    store_.load(load.ticket, std::move(load.query));
  }
  void carry_out(hub::Note note) { notes_.push_back(std::move(note)); }
  void carry_out(hub::Stopped) { stopped_ = true; }

  hub::Hub hub_;
  MemoryStore store_;
  std::mt19937_64 random_{1};
  std::uint64_t last_connection_ = 0;
  std::uint32_t last_request_ = 0;
  std::deque<hub::Input> inputs_;
  bool stepping_ = false;
  std::map<hub::ConnectionId, std::vector<std::shared_ptr<const lobby::Told>>> inboxes_;
  std::map<hub::ConnectionId, hub::Standing> standings_;
  std::set<hub::ConnectionId> closing_;
  std::set<hub::ConnectionId> draining_;
  std::vector<hub::Note> notes_;
  std::size_t loads_ = 0;
  bool stopped_ = false;
};

}  // namespace breakshot::support
