#include "client_cli/online/match_view.hpp"

#include <algorithm>
#include <variant>

namespace breakshot::client {
namespace {

void take(MatchView& view, const lobby::MatchNews& news) {
  view.info = news.info;
  view.you = news.you;
  if (news.header) view.header = news.header;
}

void take(MatchView& view, const EntryPtr& entry) {
  view.last = entry;
  view.next = match::Seq{static_cast<std::uint32_t>(entry->seq) + 1};
  if (!entry->outcome.shot) return;
  ++view.shots;
  const bool pocketed = entry->outcome.ruling && !entry->outcome.ruling->pocketed.empty();
  view.shots_dry = pocketed ? 0 : view.shots_dry + 1;
}

void take(MatchView& view, const lobby::MatchGone& gone) {
  view.gone = gone.what.empty() ? "it is no more" : gone.what;
}

}  // namespace

MatchView view_of(const lobby::MatchNews& news) {
  MatchView view;
  take(view, news);
  return view;
}

void take(MatchView& view, const News& news) {
  std::visit([&](const auto& one) { take(view, one); }, news);
}

match::Stage stage_of(const MatchView& view) {
  // The entries are newer than the last news of the seats.
  return view.last ? view.last->outcome.status.stage : match::Stage::gathering;
}

bool has_free_seat(const lobby::MatchInfo& info) {
  return std::any_of(info.seats.begin(), info.seats.end(),
                     [](const lobby::SeatInfo& seat) { return seat.name.empty(); });
}

bool is_over(const MatchView& view) {
  return !view.gone.empty() || stage_of(view) == match::Stage::finished;
}

bool is_my_turn(const MatchView& view) {
  return view.you && stage_of(view) == match::Stage::running &&
         view.last->outcome.status.game.turn == *view.you;
}

bool opponent_is_away(const MatchView& view) {
  if (stage_of(view) != match::Stage::running) return false;
  for (std::size_t i = 0; i < view.info.seats.size(); ++i) {
    const lobby::SeatInfo& seat = view.info.seats[i];
    const bool mine = view.you && rules::number(*view.you) == i;
    if (!mine && !seat.name.empty() && !seat.present) return true;
  }
  return false;
}

bool is_up_to_date(const MatchView& view) {
  return view.next >= view.info.next;
}

std::string name_of(const MatchView& view, match::Seat seat) {
  const std::size_t index = rules::number(seat);
  if (index < view.info.seats.size() && !view.info.seats[index].name.empty()) {
    return view.info.seats[index].name;
  }
  return "seat " + std::to_string(index + 1);
}

}  // namespace breakshot::client
