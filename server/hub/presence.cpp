#include "server/hub/presence.hpp"

#include <algorithm>

#include "server/hub/view.hpp"

namespace breakshot::hub {

bool note_presence(Moment& moment, LiveMatch& match) {
  bool changed = false;
  for (std::size_t seat = 0; seat < match.row.seats.size(); ++seat) {
    const auto& sitter = match.row.seats[seat];
    const auto online =
        sitter ? moment.state.online.find(sitter->guest) : moment.state.online.end();
    const bool present =
        online != moment.state.online.end() && match.followers.contains(online->second);
    auto& since = match.away_since[seat];
    if (!sitter || present) {
      changed = changed || since;
      since.reset();
    } else if (!since) {
      changed = true;
      since = moment.now.steady;
    }
  }
  return changed;
}

void update_presence(Moment& moment, LiveMatch& match, const std::optional<ConnectionId>& except) {
  if (note_presence(moment, match)) tell_news(moment, match, except);
}

void update_standing(Moment& moment, ConnectionId id) {
  const ledger::Guest* guest = guest_of(moment.state, id);
  if (!guest) return;
  const auto& follows = open_connection(moment.state, id)->follows;
  const bool plays = std::any_of(follows.begin(), follows.end(), [&](const auto& followed) {
    const LiveMatch* match = live_match(moment.state, followed.first);
    return match && match->followers.contains(id) && seat_of(match->row.seats, guest->id);
  });
  stand(moment, id, plays ? Standing::player : Standing::guest);
}

}  // namespace breakshot::hub
