#include "tests/simulation/client.hpp"

#include <algorithm>

#include "tests/simulation/broken.hpp"

namespace breakshot::simulation {
namespace {

std::uint32_t number(match::Seq seq) {
  return static_cast<std::uint32_t>(seq);
}

/// Where a request begins to follow, if it does.
std::uint32_t from_of(const lobby::Request& request) {
  if (const auto* join = std::get_if<lobby::Join>(&request)) return number(join->from);
  if (const auto* watch = std::get_if<lobby::Watch>(&request)) return number(watch->from);
  if (const auto* fetch = std::get_if<lobby::Fetch>(&request)) return number(fetch->from);
  return 0;
}

/// One of those last heard of.
template <class Thing>
Thing lately(const std::vector<Thing>& heard, support::Chance& chance) {
  return heard[heard.size() - 1 - chance.below(std::min<std::size_t>(heard.size(), 8))];
}

}  // namespace

void Client::connected() {
  connected_ = true;
}

void Client::disconnected() {
  connected_ = false;
  welcomed_ = false;
  unanswered_.clear();
  follows_.clear();
}

// ---- Speaking

lobby::Asked Client::say(lobby::Request request) {
  const lobby::RequestId id{++last_request_};
  unanswered_[id] = {request, from_of(request)};
  return {id, std::move(request)};
}

std::optional<lobby::Asked> Client::speak(Gossip& gossip) {
  if (!connected_) return std::nullopt;
  if (!welcomed_ && chance_.below(10) != 0) {
    for (const auto& [id, open] : unanswered_) {
      if (std::holds_alternative<lobby::Hello>(open.request)) return std::nullopt;
    }
    return say(lobby::Hello{lobby::protocol_version, name_, token_});
  }
  if (unanswered_.size() > 6) return std::nullopt;
  return say(something(gossip));
}

lobby::Request Client::something(Gossip& gossip) {
  if (chance_.below(100) < 55) {
    if (auto request = command()) return *request;
  }
  switch (chance_.below(12)) {
    case 0:
      return wish();
    case 1:
      return lobby::List{chance_.one_of<lobby::Filter>(4), std::nullopt};
    case 2:
      return lobby::Ping{};
    default:
      if (auto request = about_a_match(gossip)) return *request;
      return wish();
  }
}

lobby::Request Client::wish() {
  if (wish_ && chance_.coin()) {
    wish_repeated_ = true;
    return *wish_;
  }
  lobby::Create create;
  const bool alone = chance_.below(4) == 0;
  create.game =
      alone || chance_.below(3) == 0 ? match::GameKind::practice : match::GameKind::eight_ball;
  create.seats = alone ? 1 : 2;
  create.is_private = chance_.below(3) == 0;
  if (chance_.below(4) == 0) return create;
  for (std::uint8_t& byte : create.key.emplace()) byte = static_cast<std::uint8_t>(chance_.bits());
  wish_ = create;
  wish_repeated_ = false;
  return create;
}

const Client::Known* Client::some_known() {
  std::vector<const Known*> some;
  for (const auto& [id, known] : known_) {
    const bool finished = known.last && known.last->status.stage == match::Stage::finished;
    if (!finished || chance_.below(10) == 0) some.push_back(&known);
  }
  return some.empty() ? nullptr : some[chance_.below(some.size())];
}

/// A match at which it sits and which is not finished; one that it follows and in which it is to do
/// something is preferred.
const Client::Known* Client::some_own() {
  std::vector<const Known*> own;
  for (const auto& [id, known] : known_) {
    const bool finished = known.last && known.last->status.stage == match::Stage::finished;
    if (!known.you || finished) continue;
    const std::size_t seat = rules::number(*known.you);
    const bool to_do = known.last ? known.last->status.game.turn == *known.you
                                  : !known.info.seats[seat].contributed;
    if (to_do && follows_.contains(id)) own.push_back(&known);
    if (chance_.below(20) == 0) own.push_back(&known);
  }
  return own.empty() ? nullptr : own[chance_.below(own.size())];
}

std::optional<lobby::Request> Client::about_a_match(Gossip& gossip) {
  std::optional<match::MatchId> id;
  std::optional<lobby::InviteCode> code;
  if (const Known* known = some_known(); known && chance_.coin()) {
    id = known->info.id;
  } else if (!gossip.codes.empty() && chance_.below(3) == 0) {
    code = lately(gossip.codes, chance_);
  } else if (!gossip.matches.empty()) {
    id = lately(gossip.matches, chance_);
  } else {
    return std::nullopt;
  }
  const auto known = id ? known_.find(*id) : known_.end();
  const std::uint32_t known_next = known == known_.end() ? 0 : known->second.next;
  const match::Seq from{chance_.coin() ? known_next
                                       : static_cast<std::uint32_t>(chance_.below(known_next + 1))};
  switch (chance_.below(12)) {
    case 0:
      return lobby::Fetch{id, code, from};
    case 1:
    case 2:
    case 3:
      return lobby::Watch{id, code, from};
    case 4:
      if (id && chance_.below(4) == 0) return lobby::Leave{*id};
      [[fallthrough]];
    case 5:
      if (id) return lobby::Claim{*id};
      [[fallthrough]];
    default: {
      // One's own seat again from where one was, a free seat from the beginning.
      const bool seated = known != known_.end() && known->second.you;
      return lobby::Join{id, code, seated ? from : match::Seq{}};
    }
  }
}

/// What a player at the table may see of it: enough to think of a command.
match::Match Client::as_seen(const Known& known) const {
  match::Match match;
  match.settings = known.info.settings;
  match.next = match::Seq{known.next};
  match.table = known.last->table;
  match.status = known.last->status;
  return match;
}

std::optional<lobby::Request> Client::command() {
  if (pending_ && chance_.below(10) != 0) {
    if (chance_.coin()) return std::nullopt;
    repeated_ = true;
    return *pending_;
  }
  const Known* known = some_own();
  if (!known) return std::nullopt;
  if (known->info.stage == match::Stage::gathering && !known->last) {
    for (const auto& [id, open] : unanswered_) {
      if (std::holds_alternative<lobby::Contribute>(open.request)) return std::nullopt;
    }
    return lobby::Contribute{known->info.id, chance_.bytes32()};
  }
  if (!known->last) return std::nullopt;
  const match::Match seen = as_seen(*known);
  lobby::Act act;
  act.match = known->info.id;
  act.expected = seen.next;
  act.id = match::CommandId{chance_.bits() | 1};
  if (chance_.below(60) == 0) {
    act.command = match::Concede{};
  } else {
    const bool sensible = chance_.below(8) != 0;
    // Now and then two at once, the second in the hope that the first succeeds.
    if (chance_.below(6) == 0) act.expected = match::Seq{known->next + 1};
    act.command = (sensible ? asks_.sensible(seen) : asks_.senseless(seen)).command;
  }
  pending_ = act;
  repeated_ = false;
  return act;
}

// ---- Hearing

void Client::hear(const lobby::Told& told, Gossip& gossip) {
  if (told.id == lobby::RequestId{}) return hear_unasked(told.answer);
  hear_answer(told.id, told.answer, gossip);
}

void Client::hear_unasked(const lobby::Answer& answer) {
  if (const auto* news = std::get_if<lobby::EntryNews>(&answer)) {
    const auto follow = follows_.find(news->match);
    require(follow != follows_.end(), "an entry was told to one who does not follow");
    require(number(news->entry->seq) == follow->second, "an entry came out of order");
    follow_on(*news);
  } else if (const auto* info = std::get_if<lobby::MatchNews>(&answer)) {
    require(follows_.contains(info->info.id), "news were told to one who does not follow");
    learn(*info);
  } else if (const auto* gone = std::get_if<lobby::MatchGone>(&answer)) {
    require(follows_.erase(gone->match) == 1, "an end was told to one who does not follow");
    known_.erase(gone->match);
  } else {
    require(std::holds_alternative<lobby::Goodbye>(answer), "an answer that nobody asked for");
  }
}

void Client::hear_answer(lobby::RequestId id, const lobby::Answer& answer, Gossip& gossip) {
  const auto open = unanswered_.find(id);
  require(open != unanswered_.end(), "a request was answered twice");
  if (std::holds_alternative<lobby::Fetch>(open->second.request)) {
    if (const auto* news = std::get_if<lobby::MatchNews>(&answer)) return learn(*news);
    if (const auto* news = std::get_if<lobby::EntryNews>(&answer)) {
      require(number(news->entry->seq) == open->second.next++, "a fetched entry is out of order");
      return learn(*news);
    }
    if (const auto* done = std::get_if<lobby::FetchDone>(&answer)) {
      require(number(done->next) == open->second.next, "a fetched record is not whole");
      ++counts_.fetched;
    }
  }
  const Open closed = std::move(open->second);
  unanswered_.erase(open);
  answered(closed, answer, gossip);
}

void Client::answered(const Open& open, const lobby::Answer& answer, Gossip& gossip) {
  if (const auto* create = std::get_if<lobby::Create>(&open.request)) came_of(*create, answer);
  if (const auto* refused = std::get_if<lobby::Refused>(&answer)) {
    ++counts_.refused;
    const auto* act = std::get_if<lobby::Act>(&open.request);
    const bool again = refused->code == lobby::RefusalCode::unavailable;
    if (act && act->id == (pending_ ? pending_->id : match::CommandId{}) && !again) {
      pending_.reset();
    }
    if (refused->code == lobby::RefusalCode::unknown_token) token_.reset();
  } else if (const auto* welcome = std::get_if<lobby::Welcome>(&answer)) {
    if (welcome->token) token_ = welcome->token;
    welcomed_ = true;
  } else if (const auto* news = std::get_if<lobby::MatchNews>(&answer)) {
    follows_[news->info.id] = open.next;
    learn(*news);
    if (!news->info.is_private) gossip.matches.push_back(news->info.id);
    if (news->info.code) gossip.codes.push_back(*news->info.code);
  } else if (const auto* entry = std::get_if<lobby::EntryNews>(&answer)) {
    const auto follow = follows_.find(entry->match);
    const bool awaited = follow != follows_.end() && number(entry->entry->seq) == follow->second;
    if (awaited) follow_on(*entry);
    if (const auto* act = std::get_if<lobby::Act>(&open.request)) {
      require(entry->entry->id == act->id && entry->entry->seq == act->expected,
              "a command was answered with another's entry");
      if (pending_ && pending_->id == act->id) {
        if (repeated_) ++counts_.repeats_answered;
        pending_.reset();
      }
    }
  } else if (std::holds_alternative<lobby::Done>(answer)) {
    if (const auto* leave = std::get_if<lobby::Leave>(&open.request)) follows_.erase(leave->match);
  }
}

void Client::came_of(const lobby::Create& create, const lobby::Answer& answer) {
  const auto* news = std::get_if<lobby::MatchNews>(&answer);
  if (news) {
    require(news->you == match::Seat{0}, "one who opened a match is not at its first seat");
    require(news->info.settings.game == create.game && news->info.is_private == create.is_private,
            "a match was opened that was not asked for");
  }
  const auto* refused = std::get_if<lobby::Refused>(&answer);
  const bool again = refused && refused->code == lobby::RefusalCode::unavailable;
  if (!wish_ || wish_->key != create.key || again) return;
  if (news && wish_repeated_) ++counts_.wishes_repeated;
  wish_.reset();
}

void Client::learn(const lobby::MatchNews& news) {
  Known& known = known_[news.info.id];
  known.info = news.info;
  known.you = news.you;
}

void Client::learn(const lobby::EntryNews& news) {
  const auto found = known_.find(news.match);
  if (found == known_.end() || number(news.entry->seq) < found->second.next) return;
  found->second.last = news.entry->outcome;
  found->second.next = number(news.entry->seq) + 1;
}

void Client::follow_on(const lobby::EntryNews& news) {
  learn(news);
  ++follows_.at(news.match);
  if (news.entry->outcome.status.stage == match::Stage::finished) follows_.erase(news.match);
}

}  // namespace breakshot::simulation
