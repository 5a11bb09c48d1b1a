#include "server/hub/upkeep.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "server/hub/play.hpp"
#include "server/hub/presence.hpp"
#include "server/hub/seating.hpp"

namespace breakshot::hub {
namespace {

std::string at(const record::Entry& entry, const std::string& what) {
  return "entry " + std::to_string(static_cast<std::uint32_t>(entry.seq)) + ": " + what;
}

/// Plays one stored entry again; why that is impossible, or nothing.
std::optional<std::string> replay(LiveMatch& match, const record::Entry& entry) {
  if (entry.seq != match.game->next) return at(entry, "is not the next one");
  if (record::digest_of(match.digest, entry) != entry.digest) {
    return at(entry, "its digest does not fit");
  }
  auto answer = match::apply(*match.game, {entry.author, entry.seq, entry.command});
  auto* accepted = std::get_if<match::Accepted>(&answer);
  if (!accepted) return at(entry, std::get<match::Refusal>(answer).what);
  if (accepted->outcome != entry.outcome) return at(entry, "has another outcome now");
  match.game = std::move(accepted->next);
  match.digest = entry.digest;
  return std::nullopt;
}

/// Plays a stored match again, up to where it was; why it cannot go on, or nothing. The random
/// stream depends on the secret and the contributions alone, so a shot that was not stored will
/// have the outcome that it would have had.
std::optional<std::string> replay(LiveMatch& match,
                                  const std::vector<ledger::EntryPointer>& entries) {
  const record::Header& header = *match.row.header;
  if (!record::can_simulate(header.physics)) {
    return "it was begun with version " + std::to_string(header.physics) +
           " of the physics; this server has " + record::simulated_versions();
  }
  if (match::commitment_of(match.secret) != header.commitment) {
    return "its secret is not the one committed to";
  }
  std::vector<match::Contribution> contributions;
  for (const record::Player& player : header.players) contributions.push_back(player.contribution);
  match.digest = record::digest_of(header);
  match.game =
      match::created(header.settings, match::seed_of(match.secret, contributions), header.physics);
  for (const ledger::EntryPointer& entry : entries) {
    if (auto fault = replay(match, *entry)) return fault;
  }
  if (match.game->next != match.row.progress.next) return "entries are missing";
  return std::nullopt;
}

void take_up(Moment& moment, ledger::LiveMatch kept) {
  LiveMatch match;
  match.row = std::move(kept.row);
  match.secret = kept.secret;
  const match::MatchId id = match.row.id;
  if (match.row.header) {
    if (auto fault = replay(match, kept.entries)) {
      moment.out.push_back(Note{MatchSetAside{id, std::move(*fault)}});
      return;
    }
  }
  const std::size_t recent = std::min(kept.entries.size(), moment.state.limits.recent_entries);
  match.recent.assign(kept.entries.end() - static_cast<std::ptrdiff_t>(recent), kept.entries.end());
  // The steady clock began anew; a date in the future, from a clock set back, counts as now.
  const std::int64_t age_ms = moment.now.unix_ms - match.row.created_unix_ms;
  match.created = moment.now.steady - Milliseconds(std::max<std::int64_t>(age_ms, 0));
  match.away_since.resize(match.row.seats.size());
  if (match.row.code) moment.state.codes[*match.row.code] = id;
  moment.out.push_back(Note{MatchRestored{id, match.row.progress.next}});
  const auto placed = moment.state.matches.emplace(id, std::move(match)).first;
  // Everyone is away since now: nobody loses a match because the server was down.
  note_presence(moment, placed->second);
}

}  // namespace

void restored(Moment& moment, ledger::Restored restored) {
  if (auto* damaged = std::get_if<ledger::DamagedMatch>(&restored)) {
    moment.out.push_back(Note{MatchSetAside{damaged->match, std::move(damaged->what)}});
    return;
  }
  take_up(moment, std::get<ledger::LiveMatch>(std::move(restored)));
}

void ticked(Moment& moment) {
  if (moment.state.stopping) return;
  for (auto& [id, match] : moment.state.matches) {
    if (match.changing) continue;
    if (match.game) {
      abandon_if_deserted(moment, match);
    } else if (moment.now.steady - match.created >= moment.state.limits.gathering_expires) {
      discard(moment, match, std::nullopt, "the match did not start in time");
    }
  }
}

}  // namespace breakshot::hub
