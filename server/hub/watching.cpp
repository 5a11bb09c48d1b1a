#include "server/hub/watching.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "server/hub/follow.hpp"
#include "server/hub/presence.hpp"
#include "server/hub/view.hpp"

namespace breakshot::hub {
namespace {

using Code = lobby::RefusalCode;

std::size_t spectators_besides(State& state, const LiveMatch& match, ConnectionId id) {
  const auto count =
      std::count_if(match.followers.begin(), match.followers.end(), [&](const auto& follower) {
        const ledger::Guest* guest = guest_of(state, follower.first);
        return follower.first != id && guest && !seat_of(match.row.seats, guest->id);
      });
  return static_cast<std::size_t>(count);
}

/// Begins to tell a record, once its header may be told.
void begin_fetch(Moment& moment, const Ask& ask, const ledger::MatchRow& row, lobby::MatchNews news,
                 match::Seq from) {
  if (!row.header) {
    return refuse(moment, ask.asker, Code::wrong_stage,
                  "the match has not started: there is no record yet");
  }
  if (const auto fault = place_fault(row, from)) {
    return refuse(moment, ask.asker, Code::bad_request, *fault);
  }
  tell(moment, {ask.asker.connection}, ask.asker.request, std::move(news));
  read_out(moment, ask.asker, row.id, from, row.progress.next);
  serve(moment, ask.asker.connection);
}

}  // namespace

std::optional<std::string> place_fault(const ledger::MatchRow& row, match::Seq from) {
  if (from <= row.progress.next) return std::nullopt;
  return "from: the match has only " +
         std::to_string(static_cast<std::uint32_t>(row.progress.next)) + " entries";
}

void refuse_following(Moment& moment, const Asker& asker) {
  refuse(moment, asker, Code::too_many,
         "a connection follows at most " +
             std::to_string(moment.state.limits.follows_per_connection) + " matches");
}

void watch(Moment& moment, const Ask& ask, LiveMatch& match, const lobby::Watch& watch) {
  const ConnectionId connection = ask.asker.connection;
  if (const auto fault = place_fault(match.row, watch.from)) {
    return refuse(moment, ask.asker, Code::bad_request, *fault);
  }
  if (!may_follow(moment.state, connection, match.row.id)) {
    return refuse_following(moment, ask.asker);
  }
  const std::size_t limit = moment.state.limits.spectators_per_match;
  if (!seat_of(match.row.seats, ask.guest.id) &&
      spectators_besides(moment.state, match, connection) >= limit) {
    return refuse(moment, ask.asker, Code::too_many,
                  "the match has " + std::to_string(limit) + " spectators, its limit");
  }
  follow(moment, connection, match, watch.from);
  update_presence(moment, match, connection);
  finish(moment, ask.asker, news_of(moment, match, ask.guest.id));
  serve(moment, connection);
}

void fetch(Moment& moment, const Ask& ask, const LiveMatch& match, const lobby::Fetch& fetch) {
  begin_fetch(moment, ask, match.row, news_of(moment, match, ask.guest.id), fetch.from);
}

void rejoin_stored(Moment& moment, const Ask& ask, const ledger::MatchRow& row,
                   const lobby::Join& join) {
  if (!seat_of(row.seats, ask.guest.id)) {
    return refuse(moment, ask.asker, Code::wrong_stage, "the match takes no more players");
  }
  watch_stored(moment, ask, row, join.from);
}

void watch_stored(Moment& moment, const Ask& ask, const ledger::MatchRow& row, match::Seq from) {
  if (const auto fault = place_fault(row, from)) {
    return refuse(moment, ask.asker, Code::bad_request, *fault);
  }
  if (!may_follow(moment.state, ask.asker.connection, row.id)) {
    return refuse_following(moment, ask.asker);
  }
  follow_stored(moment, ask.asker.connection, row, from);
  finish(moment, ask.asker, news_of(row, ask.guest.id));
  serve(moment, ask.asker.connection);
}

void fetch_stored(Moment& moment, const Ask& ask, const ledger::MatchRow& row, match::Seq from) {
  begin_fetch(moment, ask, row, news_of(row, ask.guest.id), from);
}

}  // namespace breakshot::hub
