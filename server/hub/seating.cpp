#include "server/hub/seating.hpp"

#include <algorithm>
#include <utility>

#include "common/physics/table.hpp"
#include "server/hub/creation.hpp"
#include "server/hub/follow.hpp"
#include "server/hub/play.hpp"
#include "server/hub/presence.hpp"
#include "server/hub/view.hpp"
#include "server/hub/watching.hpp"

namespace breakshot::hub {
namespace {

using Code = lobby::RefusalCode;

/// Bytes of a request's entropy: an id, a secret, an invite code.
constexpr std::size_t secret_at = sizeof(match::MatchId);
constexpr std::size_t code_at = secret_at + std::tuple_size_v<match::Secret>;
static_assert(code_at + lobby::invite_code_length <= std::tuple_size_v<Entropy>);

match::MatchId id_from(const Entropy& entropy) {
  std::uint64_t id = 0;
  for (std::size_t i = 0; i < sizeof id; ++i) id |= std::uint64_t{entropy[i]} << (8 * i);
  return match::MatchId{id};
}

match::Secret secret_from(const Entropy& entropy) {
  match::Secret secret{};
  std::copy_n(entropy.begin() + secret_at, secret.size(), secret.begin());
  return secret;
}

lobby::InviteCode code_from(const Entropy& entropy) {
  constexpr std::string_view crockford = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
  lobby::InviteCode code;
  for (std::size_t i = 0; i < lobby::invite_code_length; ++i) {
    code += crockford[entropy[code_at + i] % crockford.size()];
  }
  return code;
}

/// Matches open or running at which the guest sits or is about to.
std::size_t matches_of(const State& state, const ledger::GuestId& guest) {
  auto count = std::count_if(state.matches.begin(), state.matches.end(), [&](const auto& match) {
    const auto seat = seat_of(match.second.row.seats, guest);
    return seat && !has_left(match.second, *seat);
  });
  for (const auto& [ticket, storing] : state.storing) {
    const auto* created = std::get_if<StoringMatch>(&storing);
    const auto* seats = std::get_if<StoringSeats>(&storing);
    const bool joins = seats && seats->cause == StoringSeats::Cause::join;
    if (created && seat_of(created->match.row.seats, guest)) ++count;
    if (joins && seat_of(seats->seats, guest) &&
        !seat_of(state.matches.at(seats->match).row.seats, guest)) {
      ++count;
    }
  }
  return static_cast<std::size_t>(count);
}

std::size_t all_matches(const State& state) {
  const auto created = std::count_if(
      state.storing.begin(), state.storing.end(),
      [](const auto& storing) { return std::holds_alternative<StoringMatch>(storing.second); });
  return state.matches.size() + static_cast<std::size_t>(created);
}

/// Why the guest may not sit at one more match, or nothing.
std::optional<std::string> too_many_matches(const State& state, const ledger::GuestId& guest) {
  const std::size_t limit = state.limits.live_matches_per_guest;
  if (matches_of(state, guest) < limit) return std::nullopt;
  return "you sit at " + std::to_string(limit) + " matches that are not finished, the limit";
}

std::variant<match::Settings, std::string> settings_of(const lobby::Create& create) {
  const auto& presets = physics::presets();
  const auto preset =
      create.preset.empty()
          ? presets.begin()
          : std::find_if(presets.begin(), presets.end(),
                         [&](const physics::Preset& p) { return p.name == create.preset; });
  if (preset == presets.end()) {
    std::string names;
    for (const physics::Preset& p : presets) names.append(names.empty() ? "" : ", ").append(p.name);
    return "preset: there is none of this name; there are " + names;
  }
  match::Settings settings{std::string(preset->name), preset->scene, create.game, create.seats,
                           create.race_to};
  const auto faults = match::faults_of(settings);
  if (!faults.empty()) return faults.front().field + ": " + faults.front().what;
  return settings;
}

void unreserve(Moment& moment, const Asker& asker) {
  if (Connection* connection = open_connection(moment.state, asker.connection)) {
    --connection->joining;
  }
}

/// Follows from a seat that is taken already.
void sit_down(Moment& moment, const Ask& ask, LiveMatch& match, match::Seq from) {
  const ConnectionId connection = ask.asker.connection;
  follow(moment, connection, match, from);
  update_presence(moment, match, connection);
  finish(moment, ask.asker, news_of(moment, match, ask.guest.id));
  serve(moment, connection);
}

/// The start of a match at which everyone has contributed; nothing while somebody has not.
std::optional<Begun> begun_with(const LiveMatch& match, const ledger::Seats& seats) {
  Begun begun;
  begun.header.id = match.row.id;
  begun.header.created_unix_ms = match.row.created_unix_ms;
  begun.header.settings = match.row.settings;
  begun.header.commitment = match.row.commitment;
  std::vector<match::Contribution> contributions;
  for (const auto& sitter : seats) {
    if (!sitter || !sitter->contribution) return std::nullopt;
    begun.header.players.push_back({sitter->name, *sitter->contribution});
    contributions.push_back(*sitter->contribution);
  }
  const physics::Seed seed = match::seed_of(match.secret, contributions);
  begun.played = start_of(match.row.settings, seed, record::digest_of(begun.header), match.secret);
  return begun;
}

}  // namespace

void create(Moment& moment, const Ask& ask, const lobby::Create& create, const Entropy& entropy) {
  if (create_again(moment, ask, create)) return;
  auto settings = settings_of(create);
  if (const auto* fault = std::get_if<std::string>(&settings)) {
    return refuse(moment, ask.asker, Code::bad_request, *fault);
  }
  if (const auto fault = too_many_matches(moment.state, ask.guest.id)) {
    return refuse(moment, ask.asker, Code::too_many, *fault);
  }
  if (const std::size_t limit = moment.state.limits.live_matches;
      all_matches(moment.state) >= limit) {
    return refuse(
        moment, ask.asker, Code::too_many,
        "the server has " + std::to_string(limit) + " open and running matches, its limit");
  }
  const match::MatchId id = id_from(entropy);
  if (!may_follow(moment.state, ask.asker.connection, id)) {
    return refuse_following(moment, ask.asker);
  }
  LiveMatch match;
  match.secret = secret_from(entropy);
  match.created = moment.now.steady;
  if (create.key) match.creation = Creation{ask.guest.id, create};
  match.row.id = id;
  match.row.settings = std::get<match::Settings>(std::move(settings));
  match.row.commitment = match::commitment_of(match.secret);
  match.row.created_unix_ms = moment.now.unix_ms;
  if (create.is_private) match.row.code = code_from(entropy);
  match.row.seats.resize(create.seats);
  match.row.seats.front() = ledger::Sitter{ask.guest.id, ask.guest.name, std::nullopt};
  match.row.progress.score.resize(create.seats);
  match.away_since.resize(create.seats);
  ++open_connection(moment.state, ask.asker.connection)->joining;
  ledger::Batch batch = {ledger::CreateMatch{match.row, match.secret}};
  store(moment, std::move(batch), StoringMatch{ask.asker, std::move(match), {}});
}

void match_stored(Moment& moment, StoringMatch storing) {
  const match::MatchId id = storing.match.row.id;
  LiveMatch& match = moment.state.matches.emplace(id, std::move(storing.match)).first->second;
  if (match.row.code) moment.state.codes[*match.row.code] = id;
  moment.out.push_back(Note{MatchOpened{id}});
  unreserve(moment, storing.asker);
  if (const ledger::Guest* guest = guest_of(moment.state, storing.asker.connection)) {
    sit_down(moment, {storing.asker, *guest}, match, match::Seq{});
  }
  for (const Asker& asker : storing.again) come_back(moment, asker, match);
  note_presence(moment, match);
}

void match_failed(Moment& moment, const StoringMatch& storing) {
  const std::string what = "the match could not be stored";
  unreserve(moment, storing.asker);
  refuse(moment, storing.asker, Code::unavailable, what);
  for (const Asker& asker : storing.again) refuse(moment, asker, Code::unavailable, what);
}

void join(Moment& moment, const Ask& ask, LiveMatch& match, const lobby::Join& join) {
  if (const auto fault = place_fault(match.row, join.from)) {
    return refuse(moment, ask.asker, Code::bad_request, *fault);
  }
  const bool seated = seat_of(match.row.seats, ask.guest.id).has_value();
  ledger::Seats seats = match.row.seats;
  const auto free = std::find(seats.begin(), seats.end(), std::nullopt);
  if (!seated && free == seats.end()) {
    return refuse(moment, ask.asker, Code::match_full, "every seat is taken; you may watch");
  }
  if (!may_follow(moment.state, ask.asker.connection, match.row.id)) {
    return refuse_following(moment, ask.asker);
  }
  if (seated) return sit_down(moment, ask, match, join.from);
  if (const auto fault = too_many_matches(moment.state, ask.guest.id)) {
    return refuse(moment, ask.asker, Code::too_many, *fault);
  }
  *free = ledger::Sitter{ask.guest.id, ask.guest.name, std::nullopt};
  ++open_connection(moment.state, ask.asker.connection)->joining;
  match.changing = true;
  store(moment, {ledger::PutSeats{match.row.id, seats}},
        StoringSeats{StoringSeats::Cause::join, match.row.id, ask.asker, seats, std::nullopt});
}

void contribute(Moment& moment, const Ask& ask, LiveMatch& match,
                const lobby::Contribute& contribute) {
  const auto seat = seat_of(match.row.seats, ask.guest.id);
  if (!seat) return refuse(moment, ask.asker, Code::not_seated, "you do not sit at this match");
  ledger::Seats seats = match.row.seats;
  auto& own = seats[rules::number(*seat)]->contribution;
  if (own == contribute.contribution) return finish(moment, ask.asker, lobby::Done{});
  if (own) {
    return refuse(moment, ask.asker, Code::wrong_stage, "you have contributed already");
  }
  own = contribute.contribution;
  auto begun = begun_with(match, seats);
  ledger::Batch batch = {ledger::PutSeats{match.row.id, seats}};
  if (begun) {
    batch.push_back(ledger::PutHeader{begun->header});
    batch.push_back(ledger::AppendEntry{match.row.id, begun->played.entry});
  }
  match.changing = true;
  store(moment, std::move(batch),
        StoringSeats{StoringSeats::Cause::contribute, match.row.id, ask.asker, std::move(seats),
                     std::move(begun)});
}

void leave(Moment& moment, const Ask& ask, LiveMatch& match) {
  const auto seat = seat_of(match.row.seats, ask.guest.id);
  if (!seat || match.row.header) {
    unfollow(moment, ask.asker.connection, match.row.id);
    update_presence(moment, match);
    return finish(moment, ask.asker, lobby::Done{});
  }
  // Who gives up the seat knew of it: the next match with the same key is another one.
  if (match.creation && match.creation->guest == ask.guest.id) match.creation.reset();
  ledger::Seats seats = match.row.seats;
  seats[rules::number(*seat)].reset();
  if (std::all_of(seats.begin(), seats.end(), [](const auto& sitter) { return !sitter; })) {
    return discard(moment, match, ask.asker, "everyone has left");
  }
  match.changing = true;
  store(moment, {ledger::PutSeats{match.row.id, seats}},
        StoringSeats{StoringSeats::Cause::leave, match.row.id, ask.asker, seats, std::nullopt});
}

void seats_stored(Moment& moment, LiveMatch& match, StoringSeats storing) {
  const ConnectionId connection = storing.asker.connection;
  match.row.seats = std::move(storing.seats);
  switch (storing.cause) {
    case StoringSeats::Cause::join: {
      unreserve(moment, storing.asker);
      const ledger::Guest* guest = guest_of(moment.state, connection);
      if (guest) follow(moment, connection, match, match::Seq{});
      note_presence(moment, match);
      if (guest) finish(moment, storing.asker, news_of(moment, match, guest->id));
      tell_news(moment, match, connection);
      return serve(moment, connection);
    }
    case StoringSeats::Cause::contribute:
      finish(moment, storing.asker, lobby::Done{});
      if (!storing.begun) return tell_news(moment, match);
      return begin(moment, match, std::move(*storing.begun));
    case StoringSeats::Cause::leave:
      unfollow(moment, connection, match.row.id);
      note_presence(moment, match);
      finish(moment, storing.asker, lobby::Done{});
      return tell_news(moment, match);
  }
}

void seats_failed(Moment& moment, const StoringSeats& storing) {
  if (storing.cause == StoringSeats::Cause::join) unreserve(moment, storing.asker);
  refuse(moment, storing.asker, Code::unavailable, "the change could not be stored");
}

void discard(Moment& moment, LiveMatch& match, const std::optional<Asker>& asker, std::string why) {
  match.changing = true;
  store(moment, {ledger::DiscardMatch{match.row.id}},
        StoringDiscard{match.row.id, asker, std::move(why)});
}

void discard_stored(Moment& moment, LiveMatch& match, const StoringDiscard& storing) {
  if (storing.asker) unfollow(moment, storing.asker->connection, match.row.id);
  std::vector<ConnectionId> followers;
  for (const auto& [connection, reader] : match.followers) followers.push_back(connection);
  for (const ConnectionId connection : followers) unfollow(moment, connection, match.row.id);
  if (storing.asker) finish(moment, *storing.asker, lobby::Done{});
  tell(moment, followers, {}, lobby::MatchGone{match.row.id, storing.why});
  moment.out.push_back(Note{MatchDiscarded{match.row.id}});
}

void discard_failed(Moment& moment, const StoringDiscard& storing) {
  if (!storing.asker) return;  // it has expired: the next tick tries again
  refuse(moment, *storing.asker, Code::unavailable, "the change could not be stored");
}

}  // namespace breakshot::hub
