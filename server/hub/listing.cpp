#include "server/hub/listing.hpp"

#include <algorithm>
#include <tuple>

#include "server/hub/view.hpp"

namespace breakshot::hub {
namespace {

/// Whether a match stands after a position in the order of listings: newest first, and among equals
/// the greater id first.
bool stands_after(const ledger::MatchRow& row, const lobby::Position& position) {
  return std::tie(row.created_unix_ms, row.id) < std::tie(position.created_unix_ms, position.match);
}

/// One page; what was found beyond it only says that there is more.
lobby::Listing page_of(std::vector<lobby::MatchInfo> found) {
  lobby::Listing listing;
  listing.more = found.size() > lobby::page_size;
  if (listing.more) found.resize(lobby::page_size);
  listing.matches = std::move(found);
  return listing;
}

lobby::Listing live_page(const Moment& moment, const Ask& ask, const lobby::List& list) {
  const match::Stage stage =
      list.filter == lobby::Filter::open ? match::Stage::gathering : match::Stage::running;
  std::vector<const LiveMatch*> found;
  for (const auto& [id, match] : moment.state.matches) {
    if (match.row.progress.stage != stage) continue;
    if (!may_see(match.row, ask.guest.id, std::nullopt)) continue;
    if (list.after && !stands_after(match.row, *list.after)) continue;
    found.push_back(&match);
  }
  const std::size_t wanted = std::min(found.size(), lobby::page_size + 1);
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(wanted), found.end(),
                    [](const LiveMatch* a, const LiveMatch* b) {
                      return stands_after(b->row, {a->row.created_unix_ms, a->row.id});
                    });
  found.resize(wanted);
  std::vector<lobby::MatchInfo> infos;
  for (const LiveMatch* match : found) infos.push_back(info_of(moment, *match, ask.guest.id));
  return page_of(std::move(infos));
}

}  // namespace

void list(Moment& moment, const Ask& ask, const lobby::List& list) {
  if (list.filter == lobby::Filter::open || list.filter == lobby::Filter::running) {
    return finish(moment, ask.asker, live_page(moment, ask, list));
  }
  ledger::ListMatches query;
  query.which = list.filter == lobby::Filter::mine ? ledger::ListMatches::Which::mine
                                                   : ledger::ListMatches::Which::finished;
  query.guest = ask.guest.id;
  if (list.after) query.after = ledger::Place{list.after->created_unix_ms, list.after->match};
  query.count = lobby::page_size + 1;
  load(moment, query, LoadingList{ask.asker});
}

void list_loaded(Moment& moment, const LoadingList& loading, const ledger::FoundMatches& found) {
  const ledger::Guest* guest = guest_of(moment.state, loading.asker.connection);
  if (!guest) return;
  std::vector<lobby::MatchInfo> infos;
  for (const ledger::MatchRow& row : found.rows) {
    // Memory knows who is present.
    const LiveMatch* live = live_match(moment.state, row.id);
    infos.push_back(live ? info_of(moment, *live, guest->id) : info_of(row, guest->id));
  }
  finish(moment, loading.asker, page_of(std::move(infos)));
}

}  // namespace breakshot::hub
