#include "server/hub/hub.hpp"

#include <stdexcept>
#include <utility>

#include "server/hub/follow.hpp"
#include "server/hub/guests.hpp"
#include "server/hub/listing.hpp"
#include "server/hub/play.hpp"
#include "server/hub/requests.hpp"
#include "server/hub/seating.hpp"
#include "server/hub/upkeep.hpp"

namespace breakshot::hub {
namespace {

constexpr auto unavailable = lobby::RefusalCode::unavailable;

/// What was kept under a ticket. A ticket that is not under way would be a mistake of ours.
template <class Kept>
Kept taken(std::map<ledger::Ticket, Kept>& under_way, ledger::Ticket ticket) {
  auto node = under_way.extract(ticket);
  if (node.empty()) throw std::logic_error("a report for a ticket that is not under way");
  return std::move(node.mapped());
}

/// The match whose change was under way.
LiveMatch& changed(Moment& moment, match::MatchId id) {
  LiveMatch& match = moment.state.matches.at(id);
  match.changing = false;
  return match;
}

// ---- Stored

void stored(Moment& moment, StoringGuest storing) {
  guest_stored(moment, storing);
}
void stored(Moment& moment, StoringMatch storing) {
  match_stored(moment, std::move(storing));
}
void stored(Moment& moment, StoringSeats storing) {
  const match::MatchId id = storing.match;
  seats_stored(moment, changed(moment, id), std::move(storing));
  settle(moment, id);
}
void stored(Moment& moment, StoringEntry storing) {
  const match::MatchId id = storing.match;
  LiveMatch& match = changed(moment, id);
  if (!entry_stored(moment, match, std::move(storing))) return settle(moment, id);
  end_following(moment, match);
  remove_match(moment, id);
}
void stored(Moment& moment, StoringDiscard storing) {
  discard_stored(moment, changed(moment, storing.match), storing);
  remove_match(moment, storing.match);
}

// ---- Not stored

void not_stored(Moment& moment, const StoringGuest& storing) {
  guest_failed(moment, storing);
}
void not_stored(Moment& moment, const StoringMatch& storing) {
  match_failed(moment, storing);
}
void not_stored(Moment& moment, const StoringSeats& storing) {
  changed(moment, storing.match);
  seats_failed(moment, storing);
  settle(moment, storing.match);
}
void not_stored(Moment& moment, const StoringEntry& storing) {
  changed(moment, storing.match);
  entry_failed(moment, storing);
  settle(moment, storing.match);
}
void not_stored(Moment& moment, const StoringDiscard& storing) {
  changed(moment, storing.match);
  discard_failed(moment, storing);
  settle(moment, storing.match);
}

// ---- Loaded

void loaded(Moment& moment, const LoadingGuest& loading, const ledger::Found& found) {
  guest_loaded(moment, loading, std::get<ledger::FoundGuest>(found));
}
void loaded(Moment& moment, const LoadingMatch& loading, const ledger::Found& found) {
  match_loaded(moment, loading, std::get<ledger::FoundMatch>(found));
}
void loaded(Moment& moment, const LoadingEntry& loading, const ledger::Found& found) {
  entry_loaded(moment, loading, std::get<ledger::FoundEntries>(found));
}
void loaded(Moment& moment, const LoadingList& loading, const ledger::Found& found) {
  list_loaded(moment, loading, std::get<ledger::FoundMatches>(found));
}
void loaded(Moment& moment, const LoadingBatch& loading, const ledger::Found& found) {
  batch_loaded(moment, loading, std::get<ledger::FoundEntries>(found));
}

void not_loaded(Moment& moment, const LoadingGuest& loading) {
  guest_load_failed(moment, loading);
}
void not_loaded(Moment& moment, const LoadingMatch& loading) {
  refuse(moment, loading.asker, unavailable, "the match could not be looked up");
}
void not_loaded(Moment& moment, const LoadingEntry& loading) {
  refuse(moment, loading.asker, unavailable, "the entry cannot be read now");
}
void not_loaded(Moment& moment, const LoadingList& loading) {
  refuse(moment, loading.asker, unavailable, "the matches could not be looked up");
}
void not_loaded(Moment& moment, const LoadingBatch& loading) {
  batch_failed(moment, loading);
}

// ---- Inputs

void take(Moment& moment, ledger::Stored report) {
  std::visit([&](auto storing) { stored(moment, std::move(storing)); },
             taken(moment.state.storing, report.ticket));
}
void take(Moment& moment, ledger::StoreFailed report) {
  moment.out.push_back(Note{StoreRefused{std::move(report.why)}});
  std::visit([&](const auto& storing) { not_stored(moment, storing); },
             taken(moment.state.storing, report.ticket));
}
void take(Moment& moment, const ledger::Loaded& report) {
  std::visit([&](const auto& loading) { loaded(moment, loading, report.found); },
             taken(moment.state.loading, report.ticket));
}
void take(Moment& moment, ledger::LoadFailed report) {
  moment.out.push_back(Note{StoreRefused{std::move(report.why)}});
  std::visit([&](const auto& loading) { not_loaded(moment, loading); },
             taken(moment.state.loading, report.ticket));
}
void take(Moment& moment, ledger::Report report) {
  std::visit([&](auto& kind) { take(moment, std::move(kind)); }, report);
}
void take(Moment& moment, Opened input) {
  opened(moment, input.connection);
}
void take(Moment& moment, Asked input) {
  asked(moment, std::move(input));
}
void take(Moment& moment, Drained input) {
  drained(moment, input.connection);
}
void take(Moment& moment, Closed input) {
  closed(moment, input.connection);
}
void take(Moment& moment, ledger::Restored input) {
  restored(moment, std::move(input));
}
void take(Moment& moment, Tick) {
  ticked(moment);
}
void take(Moment& moment, Stopping) {
  moment.state.stopping = true;
}

/// Once nothing is being stored any more, nobody waits for an answer that may still come.
void stop_when_idle(Moment& moment) {
  if (!moment.state.stopping || moment.state.stopped || !moment.state.storing.empty()) return;
  for (const auto& [id, connection] : moment.state.connections) {
    if (connection.closing) continue;
    say_goodbye(moment, id, lobby::GoodbyeReason::stopping, "the server is stopping");
  }
  moment.state.stopped = true;
  moment.out.push_back(Stopped{});
}

}  // namespace

Hub::Hub(std::string version, const Limits& limits) : state_(std::make_unique<State>()) {
  state_->version = std::move(version);
  state_->limits = limits;
}
Hub::~Hub() = default;
Hub::Hub(Hub&&) noexcept = default;
Hub& Hub::operator=(Hub&&) noexcept = default;

Outputs Hub::step(Input input, Now now) {
  Moment moment{*state_, now, {}};
  std::visit([&](auto& kind) { take(moment, std::move(kind)); }, input);
  stop_when_idle(moment);
  return std::move(moment.out);
}

}  // namespace breakshot::hub
