// Who is who: connections come and go, guests are known by their token.
#pragma once

#include <string>

#include "server/hub/moment.hpp"

namespace breakshot::hub {

void opened(Moment& moment, ConnectionId id);
void closed(Moment& moment, ConnectionId id);

void hello(Moment& moment, const Asker& asker, const lobby::Hello& hello, const Entropy& entropy);
void guest_stored(Moment& moment, const StoringGuest& storing);
void guest_failed(Moment& moment, const StoringGuest& storing);
void guest_loaded(Moment& moment, const LoadingGuest& loading, const ledger::FoundGuest& found);
void guest_load_failed(Moment& moment, const LoadingGuest& loading);

/// Tells Goodbye, closes, and lets go of everything that the connection held.
void dismiss(Moment& moment, ConnectionId id, lobby::GoodbyeReason reason, std::string what);

}  // namespace breakshot::hub
