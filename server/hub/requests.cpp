#include "server/hub/requests.hpp"

#include <optional>
#include <string>
#include <utility>

#include "common/lobby/code.hpp"
#include "server/hub/follow.hpp"
#include "server/hub/guests.hpp"
#include "server/hub/listing.hpp"
#include "server/hub/play.hpp"
#include "server/hub/presence.hpp"
#include "server/hub/seating.hpp"
#include "server/hub/view.hpp"
#include "server/hub/watching.hpp"

namespace breakshot::hub {
namespace {

using Code = lobby::RefusalCode;

/// How a request names its match.
struct Name {
  std::optional<match::MatchId> id;
  std::optional<std::string> code;
};

Name name_in(const lobby::Request& request) {
  return std::visit(
      [](const auto& asked) -> Name {
        if constexpr (requires { asked.code; }) {
          return {asked.match, asked.code};
        } else if constexpr (requires { asked.match; }) {
          return {asked.match, std::nullopt};
        } else {
          return {};
        }
      },
      request);
}

bool is_change(const lobby::Request& request) {
  return !std::holds_alternative<lobby::Watch>(request) &&
         !std::holds_alternative<lobby::Fetch>(request);
}

LiveMatch* visible_live(Moment& moment, const Ask& ask, const Name& name) {
  std::optional<match::MatchId> id = name.id;
  if (!id && name.code) {
    const auto found = moment.state.codes.find(*name.code);
    if (found != moment.state.codes.end()) id = found->second;
  }
  LiveMatch* match = id ? live_match(moment.state, *id) : nullptr;
  return match && may_see(match->row, ask.guest.id, name.code) ? match : nullptr;
}

void refuse_unseen(Moment& moment, const Ask& ask, bool by_code) {
  refuse(moment, ask.asker, Code::no_such_match, "there is no such match");
  Connection* connection = open_connection(moment.state, ask.asker.connection);
  if (by_code && ++connection->wrong_codes >= moment.state.limits.wrong_codes_per_connection) {
    dismiss(moment, ask.asker.connection, lobby::GoodbyeReason::too_many,
            "too many wrong invite codes");
  }
}

/// What is wrong with a request before any match is looked at, or nothing.
std::optional<std::string> fault_of(const lobby::Request& request) {
  const Name name = name_in(request);
  if (!name.id && !name.code) return "match: name one by its id or by its invite code";
  const auto* act = std::get_if<lobby::Act>(&request);
  if (!act) return std::nullopt;
  if (act->id == match::CommandId{}) return "id: 0 is no command's id; choose one at random";
  if (std::holds_alternative<match::Start>(act->command) ||
      std::holds_alternative<match::Abandoned>(act->command)) {
    return "command: starting and abandoning are up to the server";
  }
  return std::nullopt;
}

void on_live(Moment& moment, const Ask& ask, LiveMatch& match, lobby::Request request) {
  if (is_change(request) && match.changing) {
    const std::size_t limit = moment.state.limits.asks_per_match;
    if (match.waiting.size() >= limit) {
      return refuse(moment, ask.asker, Code::too_many,
                    std::to_string(limit) + " requests wait for this match, the limit");
    }
    match.waiting.push_back({ask.asker, std::move(request)});
    return;
  }
  if (const auto* join_ = std::get_if<lobby::Join>(&request)) join(moment, ask, match, *join_);
  if (const auto* watch_ = std::get_if<lobby::Watch>(&request)) watch(moment, ask, match, *watch_);
  if (const auto* fetch_ = std::get_if<lobby::Fetch>(&request)) fetch(moment, ask, match, *fetch_);
  if (const auto* share = std::get_if<lobby::Contribute>(&request)) {
    contribute(moment, ask, match, *share);
  }
  if (const auto* act_ = std::get_if<lobby::Act>(&request)) act(moment, ask, match, *act_);
  if (std::holds_alternative<lobby::Claim>(request)) claim(moment, ask, match);
  if (std::holds_alternative<lobby::Leave>(request)) leave(moment, ask, match);
}

void on_stored(Moment& moment, const Ask& ask, const ledger::MatchRow& row,
               const lobby::Request& request) {
  if (const auto* join = std::get_if<lobby::Join>(&request)) {
    return rejoin_stored(moment, ask, row, *join);
  }
  if (const auto* watch = std::get_if<lobby::Watch>(&request)) {
    return watch_stored(moment, ask, row, watch->from);
  }
  if (const auto* fetch_ = std::get_if<lobby::Fetch>(&request)) {
    return fetch_stored(moment, ask, row, fetch_->from);
  }
  const auto seat = seat_of(row.seats, ask.guest.id);
  if (!seat) return refuse(moment, ask.asker, Code::not_seated, "you do not sit at this match");
  if (row.progress.stage != match::Stage::finished) {
    return refuse(moment, ask.asker, Code::unavailable, "the match cannot go on now");
  }
  const auto* act = std::get_if<lobby::Act>(&request);
  if (act && act->expected < row.progress.next) return look_up(moment, ask, *seat, *act);
  if (act) {
    return finish(
        moment, ask.asker,
        lobby::Refused{Code::command, match::RefusalCode::finished, "the match is finished"});
  }
  refuse(moment, ask.asker, Code::wrong_stage, "the match is finished");
}

void on_match(Moment& moment, const Ask& ask, lobby::Request request) {
  if (const auto fault = fault_of(request)) {
    return refuse(moment, ask.asker, Code::bad_request, *fault);
  }
  Name name = name_in(request);
  if (name.code) {
    const auto meant = lobby::code_of(*name.code);
    if (!meant) return refuse_unseen(moment, ask, true);
    name.code = meant;
  }
  if (LiveMatch* match = visible_live(moment, ask, name)) {
    return on_live(moment, ask, *match, std::move(request));
  }
  load(moment, ledger::FindMatch{name.id, name.code}, LoadingMatch{ask.asker, std::move(request)});
}

/// Leaving works without the code of a match that is followed, and is never refused: it tells
/// nothing about whether there is such a match.
void on_leave(Moment& moment, const Ask& ask, const lobby::Leave& asked) {
  LiveMatch* match = live_match(moment.state, asked.match);
  if (match && seat_of(match->row.seats, ask.guest.id)) {
    return on_live(moment, ask, *match, asked);
  }
  unfollow(moment, ask.asker.connection, asked.match);
  finish(moment, ask.asker, lobby::Done{});
}

void carry_out(Moment& moment, const Asker& asker, lobby::Request request, const Entropy& entropy) {
  if (moment.state.stopping) {
    return refuse(moment, asker, Code::unavailable, "the server is stopping");
  }
  if (const auto* greeting = std::get_if<lobby::Hello>(&request)) {
    return hello(moment, asker, *greeting, entropy);
  }
  if (std::holds_alternative<lobby::Ping>(request)) return finish(moment, asker, lobby::Done{});
  const ledger::Guest* guest = guest_of(moment.state, asker.connection);
  if (!guest) return refuse(moment, asker, Code::hello_first, "say hello first");
  const Ask ask{asker, *guest};
  if (const auto* wish = std::get_if<lobby::Create>(&request)) {
    return create(moment, ask, *wish, entropy);
  }
  if (const auto* filter = std::get_if<lobby::List>(&request)) return list(moment, ask, *filter);
  if (const auto* parting = std::get_if<lobby::Leave>(&request)) {
    return on_leave(moment, ask, *parting);
  }
  on_match(moment, ask, std::move(request));
}

/// A request that has waited has its turn, if somebody still waits for the answer. Only requests
/// that need no entropy wait.
void resume(Moment& moment, Waiting waiting) {
  if (!open_connection(moment.state, waiting.asker.connection)) return;
  carry_out(moment, waiting.asker, std::move(waiting.request), Entropy{});
}

}  // namespace

void asked(Moment& moment, Asked asked) {
  Connection* connection = open_connection(moment.state, asked.connection);
  if (!connection) return;
  const Asker asker{asked.connection, asked.asked.id};
  const std::size_t limit = moment.state.limits.asks_per_connection;
  ++connection->pending;
  if (connection->pending > limit) {
    return refuse(moment, asker, Code::too_many,
                  std::to_string(limit) + " requests of yours are not answered yet, the limit");
  }
  carry_out(moment, asker, std::move(asked.asked.request), asked.entropy);
}

void match_loaded(Moment& moment, LoadingMatch loading, const ledger::FoundMatch& found) {
  const ledger::Guest* guest = guest_of(moment.state, loading.asker.connection);
  if (!guest) return;
  const Ask ask{loading.asker, *guest};
  Name name = name_in(loading.request);
  if (name.code) name.code = lobby::code_of(*name.code);
  if (LiveMatch* match = visible_live(moment, ask, name)) {
    return on_live(moment, ask, *match, std::move(loading.request));
  }
  if (!found.row || !may_see(*found.row, ask.guest.id, name.code)) {
    return refuse_unseen(moment, ask, name.code.has_value());
  }
  on_stored(moment, ask, *found.row, loading.request);
}

void settle(Moment& moment, match::MatchId id) {
  LiveMatch* match = live_match(moment.state, id);
  while (match && !match->changing && !match->waiting.empty()) {
    Waiting next = std::move(match->waiting.front());
    match->waiting.pop_front();
    resume(moment, std::move(next));
    match = live_match(moment.state, id);
  }
}

void remove_match(Moment& moment, match::MatchId id) {
  auto removed = moment.state.matches.extract(id);
  if (removed.mapped().row.code) moment.state.codes.erase(*removed.mapped().row.code);
  for (Waiting& waiting : removed.mapped().waiting) resume(moment, std::move(waiting));
}

}  // namespace breakshot::hub
