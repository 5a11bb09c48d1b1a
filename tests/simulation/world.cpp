#include "tests/simulation/world.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

#include "tests/simulation/aftermath.hpp"
#include "tests/simulation/broken.hpp"

namespace breakshot::simulation {
namespace {

/// Small enough that the worlds run into them.
hub::Limits tight_limits() {
  hub::Limits limits;
  limits.connections = 8;
  limits.asks_per_connection = 6;
  limits.follows_per_connection = 3;
  limits.live_matches = 7;
  limits.live_matches_per_guest = 3;
  limits.spectators_per_match = 2;
  limits.entries_per_match = 40;
  limits.asks_per_match = 3;
  limits.recent_entries = 3;
  limits.batch_bytes = 4000;
  limits.gathering_expires = std::chrono::minutes(40);
  limits.claim_after = std::chrono::minutes(3);
  limits.deserted_ends = std::chrono::minutes(30);
  return limits;
}

}  // namespace

World::World(std::uint64_t seed, std::size_t clients) : chance_(seed), limits_(tight_limits()) {
  for (std::size_t i = 0; i < clients; ++i) {
    clients_.emplace_back("Guest " + std::to_string(i), chance_.bits());
  }
  store_ = std::make_unique<support::MemoryStore>(
      [this](ledger::Report report) { reports_.push_back(std::move(report)); });
  start();
}

// ---- The server

void World::start() {
  hub_.emplace("simulated", limits_);
  std::vector<ledger::Restored> kept;
  store_->restore([&](ledger::Restored one) { kept.push_back(std::move(one)); });
  for (ledger::Restored& one : kept) step(std::move(one));
}

/// The process is gone, at any point of its work: what it had ordered is stored up to some order,
/// and what the store had to say about it is never heard.
void World::crash() {
  ++totals_.crashes;
  while (chance_.coin() && work_store()) {
  }
  hub_.reset();
  for (const auto& [id, link] : links_) clients_[link.client].disconnected();
  links_.clear();
  broken_.clear();
  welcomed_.clear();
  reports_.clear();
  support::Kept kept = store_->kept();
  store_ = std::make_unique<support::MemoryStore>(
      [this](ledger::Report report) { reports_.push_back(std::move(report)); }, std::move(kept));
  start();
}

void World::step(hub::Input input) {
  for (hub::Output& output : hub_->step(std::move(input), now_)) {
    trace(output);
    std::visit([&](auto& kind) { carry_out(std::move(kind)); }, output);
  }
}

void World::trace(const hub::Output& output) {
  std::string line(trace_.begin(), trace_.end());
  line += std::to_string(output.index());
  if (const auto* tell = std::get_if<hub::Tell>(&output)) {
    for (const auto to : tell->to) line += ' ' + std::to_string(static_cast<std::uint64_t>(to));
    line += ' ' + std::to_string(tell->told->answer.index());
    if (const auto* news = std::get_if<lobby::EntryNews>(&tell->told->answer)) {
      line.append(news->entry->digest.begin(), news->entry->digest.end());
    }
  }
  trace_ = hash::sha256(hash::bytes_of(line));
}

void World::carry_out(hub::Tell tell) {
  for (const hub::ConnectionId id : tell.to) {
    if (std::holds_alternative<lobby::Welcome>(tell.told->answer)) {
      // The witness knows a guest by the token that the client has or is about to be told.
      const auto link = links_.find(id);
      const auto& fresh = std::get<lobby::Welcome>(tell.told->answer).token;
      if (link != links_.end()) {
        const auto& token = fresh ? fresh : clients_[link->second.client].token();
        welcomed_[id] = {hash::sha256(*token)};
      }
    }
    witness_.told(store_->kept(), guest_at(id).value_or(ledger::GuestId{}), tell.told->answer);
    const auto link = links_.find(id);
    if (link != links_.end()) link->second.down.push_back(tell.told);
  }
}

void World::carry_out(hub::ReportDrained report) {
  const auto link = links_.find(report.connection);
  if (link != links_.end()) link->second.down.push_back(DrainMark{});
}

void World::carry_out(hub::Close close) {
  const auto link = links_.find(close.connection);
  if (link != links_.end()) link->second.closing = true;
}

void World::carry_out(hub::Append append) {
  witness_.appended(store_->kept(), append.batch);
  store_->append(append.ticket, std::move(append.batch));
}

void World::carry_out(hub::Load load) {
  store_->load(load.ticket, std::move(load.query));
}

void World::carry_out(const hub::Note& note) {
  if (std::holds_alternative<hub::StoreRefused>(note)) ++totals_.store_failures;
  require(!std::holds_alternative<hub::MatchSetAside>(note), sentence_of(note));
}

std::optional<ledger::GuestId> World::guest_at(hub::ConnectionId id) const {
  const auto found = welcomed_.find(id);
  if (found == welcomed_.end()) return std::nullopt;
  return found->second;
}

// ---- What happens

void World::live(std::size_t steps) {
  for (std::size_t i = 0; i < steps; ++i) something_happens();
}

void World::something_happens() {
  if (one_in(2500)) return crash();
  if (one_in(500) && !links_.empty()) return cut(some_link());
  if (one_in(300)) {
    return store_->fail(1 + chance_.below(3), "the simulated disk is full");
  }
  if (one_in(40)) return pass_time();
  if (one_in(4)) return connect_or_speak();
  something_arrives();
}

void World::connect_or_speak() {
  const std::size_t number = chance_.below(clients_.size());
  Client& client = clients_[number];
  if (!client.is_connected()) {
    const hub::ConnectionId id{++last_connection_};
    links_[id].client = number;
    client.connected();
    return step(hub::Opened{id});
  }
  for (auto& [id, link] : links_) {
    if (link.client != number || link.closing) continue;
    if (auto asked = client.speak(gossip_)) link.up.push_back(std::move(*asked));
  }
}

bool World::one_in(std::size_t times) {
  return chance_.below(times) == 0;
}

World::Links::iterator World::some_link() {
  return std::next(links_.begin(), static_cast<std::ptrdiff_t>(chance_.below(links_.size())));
}

/// One of the things that are under way, each as likely as the others. Whether there was any.
bool World::something_arrives() {
  std::vector<std::function<bool()>> under_way = {[this] { return work_store(); }};
  if (!reports_.empty()) under_way.push_back([this] { return report(); });
  if (!broken_.empty()) under_way.push_back([this] { return close_one(); });
  for (auto link = links_.begin(); link != links_.end(); ++link) {
    if (!link->second.up.empty()) under_way.push_back([this, link] { return carry_up(link); });
    if (!link->second.down.empty() || link->second.closing) {
      under_way.push_back([this, link] { return carry_down(link); });
    }
  }
  return under_way[chance_.below(under_way.size())]();
}

bool World::carry_up(Links::iterator link) {
  if (link->second.up.empty()) return false;
  hub::Asked asked{link->first, std::move(link->second.up.front()), {}};
  link->second.up.pop_front();
  for (auto& byte : asked.entropy) byte = static_cast<std::uint8_t>(chance_.bits());
  std::visit(
      [&](const auto& request) {
        if constexpr (requires { request.code; }) {
          const auto guest = guest_at(link->first);
          if (request.code && guest) witness_.shown(*guest, *request.code);
        }
      },
      asked.asked.request);
  step(std::move(asked));
  return true;
}

bool World::carry_down(Links::iterator link) {
  const hub::ConnectionId id = link->first;
  Link& carried = link->second;
  if (carried.down.empty()) {
    if (!carried.closing) return false;
    cut(link);
    return true;
  }
  const auto next = std::move(carried.down.front());
  carried.down.pop_front();
  if (const auto* told = std::get_if<std::shared_ptr<const lobby::Told>>(&next)) {
    clients_[carried.client].hear(**told, gossip_);
  } else {
    step(hub::Drained{id});
  }
  return true;
}

bool World::work_store() {
  if (!store_->work()) return false;
  witness_.stored(store_->kept());
  return true;
}

bool World::report() {
  if (reports_.empty()) return false;
  ledger::Report next = std::move(reports_.front());
  reports_.pop_front();
  step(std::move(next));
  return true;
}

/// The connection breaks: what was under way is lost, and the hub hears of it later.
void World::cut(Links::iterator link) {
  ++totals_.disconnects;
  clients_[link->second.client].disconnected();
  broken_.push_back(link->first);
  links_.erase(link);
}

bool World::close_one() {
  if (broken_.empty()) return false;
  const hub::ConnectionId id = broken_.front();
  broken_.pop_front();
  step(hub::Closed{id});
  welcomed_.erase(id);
  return true;
}

void World::pass_time() {
  const std::int64_t longest_ms = one_in(20) ? 15 * 60'000 : 20'000;
  const auto time = static_cast<std::int64_t>(chance_.below(static_cast<std::size_t>(longest_ms)));
  now_.steady += std::chrono::milliseconds(time);
  now_.unix_ms += time;
  step(hub::Tick{});
}

// ---- The end

void World::calm_down() {
  store_->fail(0, "");
  const auto is_idle = [](const auto& link) {
    return link.second.up.empty() && link.second.down.empty() && !link.second.closing;
  };
  while (work_store() || !reports_.empty() || !broken_.empty() ||
         !std::all_of(links_.begin(), links_.end(), is_idle)) {
    something_arrives();
  }
}

void World::check() const {
  const support::Kept& kept = store_->kept();
  witness_.nothing_lost(kept);
  for (const auto& [id, link] : links_) {
    const Client& client = clients_[link.client];
    require(client.unanswered() == 0, "a request was never answered");
    for (const auto& [match, next] : client.follows()) {
      const auto& row = kept.matches.at(match).row;
      require(next == static_cast<std::uint32_t>(row.progress.next),
              "a follower was not told everything");
    }
  }
  check_records(kept);
  check_restart(kept, limits_, now_);
}

World::Totals World::totals() const {
  Totals totals = totals_;
  totals.entries_told = witness_.entries_told();
  totals.outcomes_repeated = witness_.outcomes_repeated();
  for (const auto& [id, match] : store_->kept().matches) {
    totals.finished += match.row.progress.stage == match::Stage::finished ? 1 : 0;
    totals.entries += match.entries.size();
  }
  for (const Client& client : clients_) {
    totals.repeats_answered += client.counts().repeats_answered;
    totals.wishes_repeated += client.counts().wishes_repeated;
    totals.fetched += client.counts().fetched;
    totals.refused += client.counts().refused;
  }
  return totals;
}

}  // namespace breakshot::simulation
