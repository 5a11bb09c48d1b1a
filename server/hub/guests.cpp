#include "server/hub/guests.hpp"

#include <algorithm>
#include <utility>

#include "common/lobby/name.hpp"
#include "server/hub/follow.hpp"

namespace breakshot::hub {
namespace {

constexpr auto unavailable = lobby::RefusalCode::unavailable;

ledger::GuestId id_of(const lobby::Token& token) {
  return {hash::sha256(token)};
}

void let_go(Moment& moment, ConnectionId id) {
  const auto found = moment.state.connections.find(id);
  if (found == moment.state.connections.end()) return;
  if (const auto& guest = found->second.guest) {
    const auto online = moment.state.online.find(guest->id);
    if (online != moment.state.online.end() && online->second == id) {
      moment.state.online.erase(online);
    }
  }
  stop_reading(moment, id);
}

void welcome(Moment& moment, const Asker& asker, const ledger::Guest& guest,
             const std::optional<lobby::Token>& token) {
  Connection* connection = open_connection(moment.state, asker.connection);
  if (!connection) return;
  const auto other = moment.state.online.find(guest.id);
  if (other != moment.state.online.end()) {
    dismiss(moment, other->second, lobby::GoodbyeReason::taken_over,
            "you have connected again from elsewhere");
  }
  connection->greeting = false;
  connection->guest = guest;
  moment.state.online[guest.id] = asker.connection;
  moment.out.push_back(Note{GuestCame{asker.connection, guest.name, token.has_value()}});
  stand(moment, asker.connection, Standing::guest);
  finish(moment, asker,
         lobby::Welcome{guest.name, token, moment.state.version,
                        moment.state.limits.claim_after.count()});
}

void refuse_greeting(Moment& moment, const Asker& asker, lobby::RefusalCode code,
                     std::string what) {
  if (Connection* connection = open_connection(moment.state, asker.connection)) {
    connection->greeting = false;
  }
  refuse(moment, asker, code, std::move(what));
}

}  // namespace

void dismiss(Moment& moment, ConnectionId id, lobby::GoodbyeReason reason, std::string what) {
  say_goodbye(moment, id, reason, std::move(what));
  let_go(moment, id);
}

void opened(Moment& moment, ConnectionId id) {
  const std::size_t limit = moment.state.limits.connections;
  if (moment.state.connections.size() >= limit) {
    return say_goodbye(moment, id, lobby::GoodbyeReason::too_many,
                       "the server has " + std::to_string(limit) + " connections, its limit");
  }
  if (moment.state.stopping) {
    return say_goodbye(moment, id, lobby::GoodbyeReason::stopping, "the server is stopping");
  }
  moment.state.connections.emplace(id, Connection{});
}

void closed(Moment& moment, ConnectionId id) {
  // It is gone from the index of open connections before others are told that its guest is away.
  if (Connection* connection = open_connection(moment.state, id)) connection->closing = true;
  let_go(moment, id);
  moment.state.connections.erase(id);
}

void hello(Moment& moment, const Asker& asker, const lobby::Hello& hello, const Entropy& entropy) {
  Connection& connection = *open_connection(moment.state, asker.connection);
  if (hello.version != lobby::protocol_version) {
    const std::string what = "this server speaks version " +
                             std::to_string(lobby::protocol_version) + " of the protocol";
    refuse(moment, asker, lobby::RefusalCode::unsupported_version, what);
    return dismiss(moment, asker.connection, lobby::GoodbyeReason::bad_protocol, what);
  }
  if (connection.guest || connection.greeting) {
    return refuse(moment, asker, lobby::RefusalCode::bad_request,
                  "a connection says hello only once");
  }
  if (const auto fault = lobby::name_fault(hello.name)) {
    return refuse(moment, asker, lobby::RefusalCode::bad_request, "name: " + *fault);
  }
  connection.greeting = true;
  if (hello.token) {
    return load(moment, ledger::FindGuest{id_of(*hello.token)}, LoadingGuest{asker, hello});
  }
  lobby::Token token{};
  std::copy_n(entropy.begin(), token.size(), token.begin());
  const ledger::Guest guest{id_of(token), hello.name};
  store(moment, {ledger::PutGuest{guest}}, StoringGuest{asker, guest, token});
}

void guest_stored(Moment& moment, const StoringGuest& storing) {
  welcome(moment, storing.asker, storing.guest, storing.token);
}

void guest_failed(Moment& moment, const StoringGuest& storing) {
  refuse_greeting(moment, storing.asker, unavailable, "the guest could not be stored");
}

void guest_loaded(Moment& moment, const LoadingGuest& loading, const ledger::FoundGuest& found) {
  if (!open_connection(moment.state, loading.asker.connection)) return;
  if (!found.guest) {
    return refuse_greeting(moment, loading.asker, lobby::RefusalCode::unknown_token,
                           "no guest has this token");
  }
  if (found.guest->name == loading.hello.name) {
    return welcome(moment, loading.asker, *found.guest, std::nullopt);
  }
  const ledger::Guest renamed{found.guest->id, loading.hello.name};
  store(moment, {ledger::PutGuest{renamed}}, StoringGuest{loading.asker, renamed, std::nullopt});
}

void guest_load_failed(Moment& moment, const LoadingGuest& loading) {
  refuse_greeting(moment, loading.asker, unavailable, "the guest could not be looked up");
}

}  // namespace breakshot::hub
