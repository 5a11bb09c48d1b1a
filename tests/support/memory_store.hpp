// A store in memory that fails when it is told to. What it has committed is a value: copy it, and
// there is what a server finds that starts after a crash.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "server/ledger/ledger.hpp"
#include "server/store/store.hpp"

namespace breakshot::support {

/// Everything that is committed.
struct Kept {
  struct Match {
    ledger::MatchRow row;
    match::Secret secret{};
    std::vector<ledger::EntryPointer> entries;
  };
  std::map<ledger::GuestId, ledger::Guest> guests;
  std::map<match::MatchId, Match> matches;

  /// Carries out a batch as a whole; why it cannot be, or nothing.
  std::optional<std::string> apply(const ledger::Batch& batch) {
    Kept next = *this;
    for (const ledger::Change& change : batch) {
      const auto fault = std::visit([&](const auto& kind) { return next.change(kind); }, change);
      if (fault) return fault;
    }
    *this = std::move(next);
    return std::nullopt;
  }

  ledger::Found answer(const ledger::Query& query) const {
    return std::visit([&](const auto& kind) -> ledger::Found { return found(kind); }, query);
  }

  void restore(const std::function<void(ledger::Restored)>& give) const {
    for (const auto& [id, match] : matches) {
      if (match.row.progress.stage == match::Stage::finished) continue;
      give(ledger::LiveMatch{match.row, match.secret, match.entries});
    }
  }

 private:
  using Fault = std::optional<std::string>;

  Match* gathering(match::MatchId id) {
    const auto found = matches.find(id);
    if (found == matches.end() || found->second.row.header) return nullptr;
    return &found->second;
  }

  Fault change(const ledger::PutGuest& put) {
    guests[put.guest.id] = put.guest;
    return std::nullopt;
  }
  Fault change(const ledger::CreateMatch& create) {
    if (matches.contains(create.row.id)) return "there is a match of this id";
    for (const auto& [id, match] : matches) {
      if (match.row.code && match.row.code == create.row.code)
        return "there is a match of this code";
    }
    matches[create.row.id] = {create.row, create.secret, {}};
    return std::nullopt;
  }
  Fault change(const ledger::PutSeats& put) {
    Match* match = gathering(put.match);
    if (!match) return "there is no such match whose seats may change";
    match->row.seats = put.seats;
    return std::nullopt;
  }
  Fault change(const ledger::PutHeader& put) {
    Match* match = gathering(put.header.id);
    if (!match) return "there is no such match that may start";
    match->row.header = put.header;
    return std::nullopt;
  }
  Fault change(const ledger::AppendEntry& append) {
    const auto found = matches.find(append.match);
    if (found == matches.end() || !found->second.row.header ||
        found->second.row.progress.next != append.entry->seq) {
      return "the entry is not the next one of its match";
    }
    found->second.entries.push_back(append.entry);
    found->second.row.progress = ledger::progress_after(*append.entry);
    return std::nullopt;
  }
  Fault change(const ledger::DiscardMatch& discard) {
    if (!gathering(discard.match)) return "there is no such match that has not started";
    matches.erase(discard.match);
    return std::nullopt;
  }

  ledger::Found found(const ledger::FindGuest& query) const {
    const auto guest = guests.find(query.id);
    if (guest == guests.end()) return ledger::FoundGuest{};
    return ledger::FoundGuest{guest->second};
  }
  ledger::Found found(const ledger::FindMatch& query) const {
    for (const auto& [id, match] : matches) {
      const bool by_id = !query.id || *query.id == id;
      const bool by_code = !query.code || query.code == match.row.code;
      if ((query.id || query.code) && by_id && by_code) return ledger::FoundMatch{match.row};
    }
    return ledger::FoundMatch{};
  }
  ledger::Found found(const ledger::ListMatches& query) const {
    const auto position = [](const ledger::MatchRow& row) {
      return std::pair(row.created_unix_ms, row.id);
    };
    ledger::FoundMatches result;
    for (const auto& [id, match] : matches) {
      const bool seated =
          std::any_of(match.row.seats.begin(), match.row.seats.end(),
                      [&](const auto& sitter) { return sitter && sitter->guest == query.guest; });
      const bool finished = match.row.progress.stage == match::Stage::finished;
      const bool wanted = query.which == ledger::ListMatches::Which::mine
                              ? seated
                              : finished && (seated || !match.row.code);
      const bool late =
          query.after &&
          position(match.row) >= std::pair(query.after->created_unix_ms, query.after->match);
      if (wanted && !late) result.rows.push_back(match.row);
    }
    std::sort(result.rows.begin(), result.rows.end(),
              [&](const auto& a, const auto& b) { return position(a) > position(b); });
    if (result.rows.size() > query.count) result.rows.resize(query.count);
    return result;
  }
  ledger::Found found(const ledger::FindEntries& query) const {
    ledger::FoundEntries result;
    const auto match = matches.find(query.match);
    if (match == matches.end()) return result;
    std::size_t bytes = 0;
    for (const ledger::EntryPointer& entry : match->second.entries) {
      if (entry->seq < query.from) continue;
      if (!result.entries.empty() && bytes >= query.bytes) break;
      bytes += record::encode(*entry).size();
      result.entries.push_back(entry);
    }
    return result;
  }
};

/// Carries out nothing by itself: `work` does, on the thread that calls it.
class MemoryStore final : public store::Store {
 public:
  explicit MemoryStore(store::Reporter reporter, Kept kept = {})
      : kept_(std::move(kept)), reporter_(std::move(reporter)) {}

  void append(ledger::Ticket ticket, ledger::Batch batch) override {
    orders_.push_back({ticket, std::move(batch)});
  }
  void load(ledger::Ticket ticket, ledger::Query query) override {
    orders_.push_back({ticket, std::move(query)});
  }
  void restore(const std::function<void(ledger::Restored)>& give) override { kept_.restore(give); }

  /// So many of the next orders fail.
  void fail(std::size_t orders, std::string why) {
    failures_ = orders;
    why_ = std::move(why);
  }

  /// Carries out the oldest order; whether there was one.
  bool work() {
    if (orders_.empty()) return false;
    const Order order = std::move(orders_.front());
    orders_.pop_front();
    const bool failing = failures_ > 0;
    if (failing) --failures_;
    if (const auto* batch = std::get_if<ledger::Batch>(&order.what)) {
      const auto fault = failing ? why_ : kept_.apply(*batch);
      if (fault) {
        reporter_(ledger::StoreFailed{order.ticket, *fault});
      } else {
        reporter_(ledger::Stored{order.ticket});
      }
    } else if (failing) {
      reporter_(ledger::LoadFailed{order.ticket, *why_});
    } else {
      const auto& query = std::get<ledger::Query>(order.what);
      reporter_(ledger::Loaded{order.ticket, kept_.answer(query)});
    }
    return true;
  }

  const Kept& kept() const { return kept_; }

 private:
  struct Order {
    ledger::Ticket ticket{};
    std::variant<ledger::Batch, ledger::Query> what;
  };

  Kept kept_;
  store::Reporter reporter_;
  std::deque<Order> orders_;
  std::size_t failures_ = 0;
  std::optional<std::string> why_;
};

}  // namespace breakshot::support
