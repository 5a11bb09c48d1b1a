// A match as far as its follower has been told.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client_cli/online/connection.hpp"
#include "common/lobby/lobby.hpp"
#include "common/match/match.hpp"
#include "common/record/record.hpp"

namespace breakshot::client {

struct MatchView {
  lobby::MatchInfo info;
  std::optional<match::Seat> you;
  std::optional<record::Header> header;
  EntryPtr last;            ///< the newest entry
  match::Seq next{};        ///< the number of the entry after it
  std::string gone;         ///< why the match is no more, if it never started; else empty
  std::uint32_t shots = 0;  ///< taken so far
  unsigned shots_dry = 0;   ///< shots since the last one that pocketed a ball
};

/// What the answer to Create, Join or Watch shows.
MatchView view_of(const lobby::MatchNews& news);
/// The view after some news. Entries must come in order, from the first on.
void take(MatchView& view, const News& news);

match::Stage stage_of(const MatchView& view);
bool has_free_seat(const lobby::MatchInfo& info);
/// There is nothing more to come: the match has finished, or is gone without having started.
bool is_over(const MatchView& view);
/// The match runs and asks something of the follower.
bool is_my_turn(const MatchView& view);
/// A player of the running match other than the follower is away.
bool opponent_is_away(const MatchView& view);
/// The number of entries that there were when the match was asked for has been told.
bool is_up_to_date(const MatchView& view);

/// What people call the player of a seat: the name, or "seat 2" where nobody sits.
std::string name_of(const MatchView& view, match::Seat seat);

}  // namespace breakshot::client
