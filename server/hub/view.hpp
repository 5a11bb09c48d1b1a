// A match as somebody may see it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/hub/moment.hpp"

namespace breakshot::hub {

std::optional<match::Seat> seat_of(const ledger::Seats& seats, const ledger::GuestId& guest);

/// A private match is seen by those who sit at it and those who have its code. A code that is given
/// must be the right one.
bool may_see(const ledger::MatchRow& row, const ledger::GuestId& guest,
             const std::optional<std::string>& code);

/// A match that is not live, as `viewer` sees it.
lobby::MatchInfo info_of(const ledger::MatchRow& row, const ledger::GuestId& viewer);
/// A live match, as `viewer` sees it.
lobby::MatchInfo info_of(const Moment& moment, const LiveMatch& match,
                         const ledger::GuestId& viewer);

lobby::MatchNews news_of(const ledger::MatchRow& row, const ledger::GuestId& viewer);
lobby::MatchNews news_of(const Moment& moment, const LiveMatch& match,
                         const ledger::GuestId& viewer);

/// Tells all followers how the match stands, but not `except`, who is told otherwise.
void tell_news(Moment& moment, const LiveMatch& match,
               const std::optional<ConnectionId>& except = std::nullopt);

}  // namespace breakshot::hub
