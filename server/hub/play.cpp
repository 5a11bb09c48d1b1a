#include "server/hub/play.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "server/hub/follow.hpp"
#include "server/hub/presence.hpp"
#include "server/hub/view.hpp"

namespace breakshot::hub {
namespace {

using Code = lobby::RefusalCode;

/// An accepted command as the entry that it becomes, but for its digest. The last one of a match
/// reveals the secret.
record::Entry entry_of(const match::Secret& secret, const match::Ask& ask, match::CommandId id,
                       match::Outcome outcome) {
  record::Entry entry;
  entry.seq = ask.expected;
  entry.author = ask.author;
  entry.id = id;
  entry.command = ask.command;
  entry.outcome = std::move(outcome);
  if (entry.outcome.status.stage == match::Stage::finished) entry.secret = secret;
  return entry;
}

Played played(const hash::Digest& before, record::Entry entry, match::Match game) {
  entry.digest = record::digest_of(before, entry);
  return {std::make_shared<const record::Entry>(std::move(entry)), std::move(game)};
}

/// A command of the server's; that it is refused would be a mistake of ours.
Played played_by_server(const match::Match& game, const hash::Digest& before,
                        const match::Secret& secret, const match::Command& command) {
  const match::Ask ask{{}, game.next, command};
  auto answer = match::apply(game, ask);
  if (const auto* refusal = std::get_if<match::Refusal>(&answer)) {
    throw std::logic_error("a command of the server's was refused: " + refusal->what);
  }
  auto& accepted = std::get<match::Accepted>(answer);
  return played(before, entry_of(secret, ask, {}, std::move(accepted.outcome)),
                std::move(accepted.next));
}

void store_entry(Moment& moment, LiveMatch& match, const std::optional<Asker>& asker,
                 Played played) {
  match.changing = true;
  ledger::Batch batch = {ledger::AppendEntry{match.row.id, played.entry}};
  store(moment, std::move(batch), StoringEntry{match.row.id, asker, std::move(played)});
}

/// The match moves on: what was played is stored.
void advance(Moment& moment, LiveMatch& match, Played played) {
  match.row.progress = ledger::progress_after(*played.entry);
  match.digest = played.entry->digest;
  match.game = std::move(played.game);
  match.recent.push_back(std::move(played.entry));
  if (match.recent.size() > moment.state.limits.recent_entries) match.recent.pop_front();
}

/// Answers a command whose sequence number has been played: with the entry, if it is that command.
void answer_with(Moment& moment, const Asker& asker, match::Seat seat, const lobby::Act& act,
                 const ledger::EntryPointer& entry) {
  if (entry->id == act.id && entry->author.seat == seat) {
    return answer_with_entry(moment, asker, act.match, entry);
  }
  finish(moment, asker,
         lobby::Refused{Code::command, match::RefusalCode::wrong_sequence,
                        "the match has moved on: another command is entry " +
                            std::to_string(static_cast<std::uint32_t>(act.expected))});
}

std::vector<match::Seat> seats_in(const LiveMatch& match) {
  std::vector<match::Seat> seats;
  for (std::size_t seat = 0; seat < match.row.seats.size(); ++seat) {
    seats.push_back(match::Seat{static_cast<std::uint8_t>(seat)});
  }
  return seats;
}

/// The seat, other than `besides`, whose player has been away for the longest time.
std::optional<match::Seat> longest_away(const LiveMatch& match,
                                        const std::optional<match::Seat>& besides) {
  std::optional<match::Seat> longest;
  for (const match::Seat seat : seats_in(match)) {
    const auto& since = match.away_since[rules::number(seat)];
    if (!since || seat == besides || has_left(match, seat)) continue;
    if (!longest || *since < *match.away_since[rules::number(*longest)]) longest = seat;
  }
  return longest;
}

Milliseconds away_for(const Moment& moment, const LiveMatch& match, match::Seat seat) {
  return moment.now.steady - *match.away_since[rules::number(seat)];
}

}  // namespace

bool has_left(const LiveMatch& match, match::Seat seat) {
  const auto* practice = match.game ? std::get_if<rules::Practice>(&match.game->game) : nullptr;
  return practice && practice->left[rules::number(seat)];
}

Played start_of(const match::Settings& settings, const physics::Seed& seed,
                const hash::Digest& header, const match::Secret& secret) {
  return played_by_server(match::created(settings, seed), header, secret, match::Start{});
}

void begin(Moment& moment, LiveMatch& match, Begun begun) {
  match.row.header = std::move(begun.header);
  moment.out.push_back(Note{MatchStarted{match.row.id}});
  advance(moment, match, std::move(begun.played));
  tell_news(moment, match);
  announce(moment, match, std::nullopt);
}

void act(Moment& moment, const Ask& ask, LiveMatch& match, const lobby::Act& act) {
  const auto seat = seat_of(match.row.seats, ask.guest.id);
  if (!seat) return refuse(moment, ask.asker, Code::not_seated, "you do not sit at this match");
  if (!match.game) return refuse(moment, ask.asker, Code::wrong_stage, "the match has not started");
  if (act.expected < match.game->next) return look_up(moment, ask, *seat, act);
  const bool concedes = std::holds_alternative<match::Concede>(act.command);
  const std::size_t limit = moment.state.limits.entries_per_match;
  if (static_cast<std::uint32_t>(match.game->next) >= limit && !concedes) {
    return refuse(
        moment, ask.asker, Code::too_many,
        "the match has " + std::to_string(limit) + " entries, its limit: it can only be conceded");
  }
  const match::Ask command{{*seat}, act.expected, act.command};
  auto answer = match::apply(*match.game, command);
  if (const auto* refusal = std::get_if<match::Refusal>(&answer)) {
    return finish(moment, ask.asker, lobby::Refused{Code::command, refusal->code, refusal->what});
  }
  auto& accepted = std::get<match::Accepted>(answer);
  record::Entry entry = entry_of(match.secret, command, act.id, std::move(accepted.outcome));
  if (const auto fault = record::fault_of(*match.row.header, entry)) {
    return refuse(moment, ask.asker, Code::bad_request, *fault);
  }
  store_entry(moment, match, ask.asker,
              played(match.digest, std::move(entry), std::move(accepted.next)));
}

void claim(Moment& moment, const Ask& ask, LiveMatch& match) {
  const auto seat = seat_of(match.row.seats, ask.guest.id);
  if (!seat) return refuse(moment, ask.asker, Code::not_seated, "you do not sit at this match");
  if (!match.game) return refuse(moment, ask.asker, Code::wrong_stage, "the match has not started");
  const auto vanished = longest_away(match, seat);
  const Milliseconds needed = moment.state.limits.claim_after;
  const Milliseconds away = vanished ? away_for(moment, match, *vanished) : Milliseconds{};
  if (!vanished || away < needed) {
    const auto seconds = [](Milliseconds time) {
      return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(time).count()) + " s";
    };
    return refuse(moment, ask.asker, Code::too_early,
                  vanished ? "the opponent has been away for " + seconds(away) + ", not yet for " +
                                 seconds(needed)
                           : "nobody is away");
  }
  store_entry(
      moment, match, ask.asker,
      played_by_server(*match.game, match.digest, match.secret, match::Abandoned{*vanished}));
}

void abandon_if_deserted(Moment& moment, LiveMatch& match) {
  const Milliseconds needed = moment.state.limits.deserted_ends;
  for (const match::Seat seat : seats_in(match)) {
    if (has_left(match, seat)) continue;
    const auto& since = match.away_since[rules::number(seat)];
    if (!since || moment.now.steady - *since < needed) return;
  }
  if (const auto seat = longest_away(match, std::nullopt)) {
    store_entry(moment, match, std::nullopt,
                played_by_server(*match.game, match.digest, match.secret, match::Abandoned{*seat}));
  }
}

bool entry_stored(Moment& moment, LiveMatch& match, StoringEntry storing) {
  advance(moment, match, std::move(storing.played));
  announce(moment, match, storing.asker);
  const ledger::Progress& progress = match.row.progress;
  if (progress.stage != match::Stage::finished) return false;
  moment.out.push_back(Note{MatchFinished{match.row.id, progress.winner, *progress.end}});
  return true;
}

void entry_failed(Moment& moment, const StoringEntry& storing) {
  if (!storing.asker) return;  // the server's own: the next tick tries again
  refuse(moment, *storing.asker, Code::unavailable,
         "the command could not be stored; send it again");
}

void look_up(Moment& moment, const Ask& ask, match::Seat seat, const lobby::Act& act) {
  if (const LiveMatch* match = live_match(moment.state, act.match)) {
    const auto found = std::find_if(match->recent.begin(), match->recent.end(),
                                    [&](const auto& entry) { return entry->seq == act.expected; });
    if (found != match->recent.end()) return answer_with(moment, ask.asker, seat, act, *found);
  }
  load(moment, ledger::FindEntries{act.match, act.expected, 1}, LoadingEntry{ask.asker, seat, act});
}

void entry_loaded(Moment& moment, const LoadingEntry& loading, const ledger::FoundEntries& found) {
  if (found.entries.empty()) {
    return refuse(moment, loading.asker, Code::unavailable, "the entry cannot be read now");
  }
  answer_with(moment, loading.asker, loading.seat, loading.act, found.entries.front());
}

}  // namespace breakshot::hub
