#include "server/hub/view.hpp"

#include <algorithm>

namespace breakshot::hub {

std::optional<match::Seat> seat_of(const ledger::Seats& seats, const ledger::GuestId& guest) {
  const auto found = std::find_if(seats.begin(), seats.end(), [&](const auto& sitter) {
    return sitter && sitter->guest == guest;
  });
  if (found == seats.end()) return std::nullopt;
  return match::Seat{static_cast<std::uint8_t>(found - seats.begin())};
}

bool may_see(const ledger::MatchRow& row, const ledger::GuestId& guest,
             const std::optional<std::string>& code) {
  if (code) return row.code == code;
  return !row.code || seat_of(row.seats, guest);
}

lobby::MatchInfo info_of(const ledger::MatchRow& row, const ledger::GuestId& viewer) {
  lobby::MatchInfo info;
  info.id = row.id;
  info.settings = row.settings;
  info.commitment = row.commitment;
  info.created_unix_ms = row.created_unix_ms;
  info.stage = row.progress.stage;
  for (const auto& sitter : row.seats) {
    lobby::SeatInfo seat;
    if (sitter) {
      seat.name = sitter->name;
      seat.contributed = sitter->contribution.has_value();
    }
    info.seats.push_back(seat);
  }
  info.score = row.progress.score;
  info.next = row.progress.next;
  info.winner = row.progress.winner;
  info.end = row.progress.end;
  info.is_private = row.code.has_value();
  if (seat_of(row.seats, viewer)) info.code = row.code;
  return info;
}

lobby::MatchInfo info_of(const Moment& moment, const LiveMatch& match,
                         const ledger::GuestId& viewer) {
  lobby::MatchInfo info = info_of(match.row, viewer);
  for (std::size_t seat = 0; seat < info.seats.size(); ++seat) {
    const auto& since = match.away_since[seat];
    info.seats[seat].present = match.row.seats[seat] && !since;
    if (since) info.seats[seat].away_ms = (moment.now.steady - *since).count();
  }
  return info;
}

lobby::MatchNews news_of(const ledger::MatchRow& row, const ledger::GuestId& viewer) {
  return {info_of(row, viewer), seat_of(row.seats, viewer), row.header};
}

lobby::MatchNews news_of(const Moment& moment, const LiveMatch& match,
                         const ledger::GuestId& viewer) {
  return {info_of(moment, match, viewer), seat_of(match.row.seats, viewer), match.row.header};
}

void tell_news(Moment& moment, const LiveMatch& match, const std::optional<ConnectionId>& except) {
  std::vector<ConnectionId> spectators;
  for (const auto& [connection, reader] : match.followers) {
    const ledger::Guest* guest = guest_of(moment.state, connection);
    if (connection == except || !guest) continue;
    if (seat_of(match.row.seats, guest->id)) {
      tell(moment, {connection}, {}, news_of(moment, match, guest->id));
    } else {
      spectators.push_back(connection);
    }
  }
  // All spectators see the same: what a guest who is nobody would see.
  if (!spectators.empty()) tell(moment, spectators, {}, news_of(moment, match, ledger::GuestId{}));
}

}  // namespace breakshot::hub
