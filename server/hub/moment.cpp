#include "server/hub/moment.hpp"

namespace breakshot::hub {

Connection* open_connection(State& state, ConnectionId id) {
  const auto found = state.connections.find(id);
  return found == state.connections.end() || found->second.closing ? nullptr : &found->second;
}

const ledger::Guest* guest_of(State& state, ConnectionId id) {
  const Connection* connection = open_connection(state, id);
  return connection && connection->guest ? &*connection->guest : nullptr;
}

LiveMatch* live_match(State& state, match::MatchId id) {
  const auto found = state.matches.find(id);
  return found == state.matches.end() ? nullptr : &found->second;
}

void tell(Moment& moment, std::vector<ConnectionId> to, lobby::RequestId id, lobby::Answer answer) {
  if (to.empty()) return;
  auto told = std::make_shared<const lobby::Told>(lobby::Told{id, std::move(answer)});
  moment.out.push_back(Tell{std::move(to), std::move(told)});
}

void finish(Moment& moment, const Asker& asker, lobby::Answer answer) {
  Connection* connection = open_connection(moment.state, asker.connection);
  if (!connection) return;
  --connection->pending;
  tell(moment, {asker.connection}, asker.request, std::move(answer));
}

void refuse(Moment& moment, const Asker& asker, lobby::RefusalCode code, std::string what) {
  finish(moment, asker, lobby::Refused{code, std::nullopt, std::move(what)});
}

void say_goodbye(Moment& moment, ConnectionId id, lobby::GoodbyeReason reason, std::string what) {
  tell(moment, {id}, {}, lobby::Goodbye{reason, std::move(what)});
  moment.out.push_back(Close{id});
  if (Connection* connection = open_connection(moment.state, id)) connection->closing = true;
}

ledger::Ticket next_ticket(State& state) {
  return ledger::Ticket{++state.last_ticket};
}

void store(Moment& moment, ledger::Batch batch, Storing storing) {
  const ledger::Ticket ticket = next_ticket(moment.state);
  moment.state.storing.emplace(ticket, std::move(storing));
  moment.out.push_back(Append{ticket, std::move(batch)});
}

void load(Moment& moment, ledger::Query query, Loading loading) {
  const ledger::Ticket ticket = next_ticket(moment.state);
  moment.state.loading.emplace(ticket, std::move(loading));
  moment.out.push_back(Load{ticket, std::move(query)});
}

void stand(Moment& moment, ConnectionId id, Standing as) {
  Connection* connection = open_connection(moment.state, id);
  if (!connection || connection->standing == as) return;
  connection->standing = as;
  moment.out.push_back(Treat{id, as});
}

}  // namespace breakshot::hub
