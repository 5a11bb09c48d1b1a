// A whole server without sockets, its clients, and everything that goes wrong between them, from
// one seed: messages take their time, connections break, the store fails, the server crashes and
// starts again from what was stored.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "server/hub/hub.hpp"
#include "tests/simulation/client.hpp"
#include "tests/simulation/witness.hpp"
#include "tests/support/memory_store.hpp"

namespace breakshot::simulation {

class World {
 public:
  World(std::uint64_t seed, std::size_t clients);

  /// So many things happen, one at a time, faults among them.
  void live(std::size_t steps);
  /// Nothing goes wrong any more and everything that is under way arrives.
  void calm_down();
  /// What must hold when all is calm.
  void check() const;

  struct Totals {
    std::size_t crashes = 0;
    std::size_t store_failures = 0;
    std::size_t disconnects = 0;
    std::size_t finished = 0;
    std::size_t entries = 0;
    std::size_t entries_told = 0;
    std::size_t outcomes_repeated = 0;
    std::size_t repeats_answered = 0;
    std::size_t wishes_repeated = 0;
    std::size_t fetched = 0;
    std::size_t refused = 0;
  };
  Totals totals() const;
  /// Of everything that the hub put out: the same seed gives the same.
  hash::Digest trace() const { return trace_; }

 private:
  struct DrainMark {};
  struct Link {
    std::size_t client = 0;
    std::deque<lobby::Asked> up;
    std::deque<std::variant<std::shared_ptr<const lobby::Told>, DrainMark>> down;
    bool closing = false;  ///< the hub closes it when `down` is empty
  };
  using Links = std::map<hub::ConnectionId, Link>;

  void start();
  void crash();
  void step(hub::Input input);
  void carry_out(hub::Tell tell);
  void carry_out(hub::ReportDrained report);
  void carry_out(hub::Close close);
  void carry_out(const hub::Treat&) {}
  void carry_out(hub::Append append);
  void carry_out(hub::Load load);
  void carry_out(const hub::Note& note);
  void carry_out(const hub::Stopped&) {}
  void trace(const hub::Output& output);

  void something_happens();
  bool something_arrives();
  void connect_or_speak();
  bool carry_up(Links::iterator link);
  bool carry_down(Links::iterator link);
  bool work_store();
  bool report();
  bool close_one();
  void cut(Links::iterator link);
  void pass_time();
  Links::iterator some_link();
  bool one_in(std::size_t times);
  std::optional<ledger::GuestId> guest_at(hub::ConnectionId id) const;

  support::Chance chance_;
  std::vector<Client> clients_;
  Gossip gossip_;
  Witness witness_;
  hub::Limits limits_;
  hub::Now now_{std::chrono::milliseconds(0), 1'700'000'000'000};
  std::optional<hub::Hub> hub_;
  std::unique_ptr<support::MemoryStore> store_;
  std::deque<ledger::Report> reports_;
  Links links_;
  std::map<hub::ConnectionId, ledger::GuestId> welcomed_;
  std::deque<hub::ConnectionId> broken_;  ///< links that the hub does not know to be gone yet
  std::uint64_t last_connection_ = 0;
  hash::Digest trace_{};
  Totals totals_;
};

}  // namespace breakshot::simulation
