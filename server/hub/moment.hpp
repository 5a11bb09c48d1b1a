// One step under way: the state, the time, and what has been put out so far; and the ways to put
// something out.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "server/hub/state.hpp"

namespace breakshot::hub {

struct Moment {
  State& state;
  Now now;
  Outputs out;
};

/// Whose request it is. The guest is known: it comes after Welcome.
struct Ask {
  Asker asker;
  ledger::Guest guest;
};

/// The connection, unless it is gone or going.
Connection* open_connection(State& state, ConnectionId id);
/// The guest of an open connection, after Welcome.
const ledger::Guest* guest_of(State& state, ConnectionId id);

/// The match with this id that is not finished.
LiveMatch* live_match(State& state, match::MatchId id);

/// Says something that is not the end of an answer.
void tell(Moment& moment, std::vector<ConnectionId> to, lobby::RequestId id, lobby::Answer answer);
/// Gives a request its one answer.
void finish(Moment& moment, const Asker& asker, lobby::Answer answer);
void refuse(Moment& moment, const Asker& asker, lobby::RefusalCode code, std::string what);
/// Tells Goodbye and closes. What the connection did for its guest is undone by the caller.
void say_goodbye(Moment& moment, ConnectionId id, lobby::GoodbyeReason reason, std::string what);

ledger::Ticket next_ticket(State& state);
void store(Moment& moment, ledger::Batch batch, Storing storing);
void load(Moment& moment, ledger::Query query, Loading loading);

/// Puts out a change of a connection's standing.
void stand(Moment& moment, ConnectionId id, Standing as);

}  // namespace breakshot::hub
