// What clients are told.
#include <google/protobuf/arena.h>

#include <memory>
#include <stdexcept>
#include <variant>

#include "breakshot/v1/session.pb.h"
#include "common/lobby/code.hpp"
#include "common/lobby/name.hpp"
#include "common/wire/check.hpp"
#include "common/wire/matches.hpp"
#include "common/wire/message.hpp"
#include "common/wire/records.hpp"
#include "common/wire/translate.hpp"

namespace breakshot::wire {
namespace {

// Those of this file hide the room's otherwise.
using wire::read;
using wire::write;

static_assert(v1::RefusalCode_MAX == static_cast<int>(lobby::RefusalCode::command) + 1);
static_assert(v1::CommandRefusal_MAX == static_cast<int>(match::RefusalCode::finished) + 1);
static_assert(v1::GoodbyeReason_MAX == static_cast<int>(lobby::GoodbyeReason::bad_protocol) + 1);

// ---- Writing

void write(const lobby::MatchInfo& info, v1::MatchInfo& message) {
  message.set_match(static_cast<std::uint64_t>(info.id));
  write(info.settings, *message.mutable_settings());
  message.set_commitment(info.commitment.data(), info.commitment.size());
  message.set_created_unix_ms(info.created_unix_ms);
  message.set_stage(enum_of<v1::Stage>(info.stage));
  for (const lobby::SeatInfo& seat : info.seats) {
    v1::SeatInfo& said = *message.add_seats();
    said.set_name(seat.name);
    said.set_contributed(seat.contributed);
    said.set_present(seat.present);
    said.set_away_ms(seat.away_ms);
  }
  for (const std::uint32_t racks : info.score) message.add_score(racks);
  message.set_next(static_cast<std::uint32_t>(info.next));
  if (info.winner) message.set_winner(number(*info.winner));
  if (info.end) message.set_end(enum_of<v1::MatchEnd>(*info.end));
  message.set_is_private(info.is_private);
  if (info.code) message.set_code(*info.code);
}

struct AnswerWriter {
  v1::ServerToClient& message;

  void operator()(const lobby::Welcome& welcome) const {
    v1::Welcome& said = *message.mutable_welcome();
    said.set_name(welcome.name);
    if (welcome.token) said.set_token(welcome.token->data(), welcome.token->size());
    said.set_server(welcome.server);
    said.set_claim_after_ms(welcome.claim_after_ms);
  }
  void operator()(const lobby::Refused& refused) const {
    v1::Refused& said = *message.mutable_refused();
    said.set_code(enum_of<v1::RefusalCode>(refused.code));
    if (refused.detail) said.set_detail(enum_of<v1::CommandRefusal>(*refused.detail));
    said.set_what(refused.what);
  }
  void operator()(const lobby::MatchNews& news) const {
    v1::MatchNews& said = *message.mutable_match_news();
    write(news.info, *said.mutable_info());
    if (news.you) said.set_you(number(*news.you));
    if (news.header) write(*news.header, *said.mutable_header());
  }
  void operator()(const lobby::EntryNews& news) const {
    if (!news.entry) throw std::logic_error("news of no entry");
    v1::EntryNews& said = *message.mutable_entry_news();
    said.set_match(static_cast<std::uint64_t>(news.match));
    write(*news.entry, *said.mutable_entry());
  }
  void operator()(const lobby::MatchGone& gone) const {
    v1::MatchGone& said = *message.mutable_match_gone();
    said.set_match(static_cast<std::uint64_t>(gone.match));
    said.set_what(gone.what);
  }
  void operator()(const lobby::Listing& listing) const {
    v1::Listing& said = *message.mutable_listing();
    for (const lobby::MatchInfo& info : listing.matches) write(info, *said.add_matches());
    said.set_more(listing.more);
  }
  void operator()(const lobby::FetchDone& done) const {
    v1::FetchDone& said = *message.mutable_fetch_done();
    said.set_match(static_cast<std::uint64_t>(done.match));
    said.set_next(static_cast<std::uint32_t>(done.next));
  }
  void operator()(const lobby::Done&) const { message.mutable_done(); }
  void operator()(const lobby::Goodbye& goodbye) const {
    v1::Goodbye& said = *message.mutable_goodbye();
    said.set_reason(enum_of<v1::GoodbyeReason>(goodbye.reason));
    said.set_what(goodbye.what);
  }
};

// ---- Reading

std::int64_t duration_ms(std::int64_t value, const Where& at) {
  if (value >= 0) return value;
  at.refuse("is " + std::to_string(value) + "; a duration is not negative");
  return 0;
}

lobby::SeatInfo read(const v1::SeatInfo& message, const Where& at) {
  if (!message.name().empty()) {
    if (const auto fault = lobby::name_fault(message.name())) Where(at, "name").refuse(*fault);
  }
  return {message.name(), message.contributed(), message.present(),
          duration_ms(message.away_ms(), Where(at, "away_ms"))};
}

lobby::MatchInfo read(const v1::MatchInfo& message, const Where& at) {
  lobby::MatchInfo info;
  info.id = match::MatchId{message.match()};
  info.settings = read(message.settings(), Where(at, "settings"));
  info.commitment = bytes32(message.commitment(), Where(at, "commitment"));
  info.created_unix_ms = message.created_unix_ms();
  info.stage = enumerated<match::Stage>(message.stage(), v1::Stage_MAX, Where(at, "stage"));
  if (message.seats_size() != info.settings.seats) {
    Where(at, "seats").refuse("must have one value a seat of the settings");
  }
  for (int i = 0; i < message.seats_size() && at.good(); ++i) {
    info.seats.push_back(read(message.seats(i), Where(at, "seats", i)));
  }
  check_per_seat(message.score_size(), Where(at, "score"));
  info.score.assign(message.score().begin(), message.score().end());
  info.next = match::Seq{message.next()};
  if (message.has_winner()) info.winner = seat(message.winner(), Where(at, "winner"));
  info.end = match_end(message.end(), Where(at, "end"));
  info.is_private = message.is_private();
  if (!message.code().empty()) {
    info.code = lobby::code_of(message.code());
    if (!info.code) Where(at, "code").refuse("is no invite code");
  }
  return info;
}

lobby::Welcome read(const v1::Welcome& message, const Where& at) {
  if (const auto fault = lobby::name_fault(message.name())) Where(at, "name").refuse(*fault);
  return {message.name(), optional_bytes32(message.token(), Where(at, "token")),
          text(message.server(), Where(at, "server")),
          duration_ms(message.claim_after_ms(), Where(at, "claim_after_ms"))};
}

lobby::Refused read(const v1::Refused& message, const Where& at) {
  lobby::Refused refused;
  const Where code(at, "code");
  refused.code = enumerated<lobby::RefusalCode>(message.code(), v1::RefusalCode_MAX, code);
  if (message.detail() != v1::COMMAND_REFUSAL_UNSPECIFIED) {
    const Where detail(at, "detail");
    refused.detail =
        enumerated<match::RefusalCode>(message.detail(), v1::CommandRefusal_MAX, detail);
  }
  refused.what = text(message.what(), Where(at, "what"));
  return refused;
}

lobby::MatchNews read(const v1::MatchNews& message, const Where& at) {
  lobby::MatchNews news;
  news.info = read(message.info(), Where(at, "info"));
  if (message.has_you()) news.you = seat(message.you(), Where(at, "you"));
  if (message.has_header()) news.header = read(message.header(), Where(at, "header"));
  return news;
}

lobby::EntryNews read(const v1::EntryNews& message, const Where& at) {
  auto entry = std::make_shared<record::Entry>(read(message.entry(), Where(at, "entry")));
  return {match::MatchId{message.match()}, std::move(entry)};
}

lobby::Listing read(const v1::Listing& message, const Where& at) {
  lobby::Listing listing;
  if (message.matches_size() > static_cast<int>(lobby::page_size)) {
    Where(at, "matches").refuse("has more than 50 values");
  }
  for (int i = 0; i < message.matches_size() && at.good(); ++i) {
    listing.matches.push_back(read(message.matches(i), Where(at, "matches", i)));
  }
  listing.more = message.more();
  return listing;
}

lobby::Goodbye read(const v1::Goodbye& message, const Where& at) {
  const Where reason(at, "reason");
  return {enumerated<lobby::GoodbyeReason>(message.reason(), v1::GoodbyeReason_MAX, reason),
          text(message.what(), Where(at, "what"))};
}

lobby::Answer read_answer(const v1::ServerToClient& message, const Where& at) {
  using Kind = v1::ServerToClient::AnswerCase;
  switch (message.answer_case()) {
    case Kind::kWelcome:
      return read(message.welcome(), Where(at, "welcome"));
    case Kind::kRefused:
      return read(message.refused(), Where(at, "refused"));
    case Kind::kMatchNews:
      return read(message.match_news(), Where(at, "match_news"));
    case Kind::kEntryNews:
      return read(message.entry_news(), Where(at, "entry_news"));
    case Kind::kMatchGone: {
      const Where gone(at, "match_gone");
      return lobby::MatchGone{match::MatchId{message.match_gone().match()},
                              text(message.match_gone().what(), Where(gone, "what"))};
    }
    case Kind::kListing:
      return read(message.listing(), Where(at, "listing"));
    case Kind::kFetchDone:
      return lobby::FetchDone{match::MatchId{message.fetch_done().match()},
                              match::Seq{message.fetch_done().next()}};
    case Kind::kDone:
      return lobby::Done{};
    case Kind::kGoodbye:
      return read(message.goodbye(), Where(at, "goodbye"));
    case Kind::ANSWER_NOT_SET:
      break;
  }
  Where(at, "answer").refuse("is missing, or one that this version of the protocol does not know");
  return lobby::Done{};
}

}  // namespace

ByteVector frame_of(const lobby::Told& told) {
  google::protobuf::Arena arena;
  auto& message = *google::protobuf::Arena::CreateMessage<v1::ServerToClient>(&arena);
  message.set_request_id(static_cast<std::uint32_t>(told.id));
  std::visit(AnswerWriter{message}, told.answer);
  return frame_of_message(message);
}

std::variant<lobby::Told, Malformed> read_told(hash::Bytes body) {
  google::protobuf::Arena arena;
  auto& message = *google::protobuf::Arena::CreateMessage<v1::ServerToClient>(&arena);
  if (auto fault = parse(body, message)) return Malformed{std::nullopt, *std::move(fault)};
  const lobby::RequestId id{message.request_id()};
  std::optional<physics::Fault> fault;
  lobby::Told told{id, read_answer(message, Where(fault))};
  if (fault) return Malformed{id, *std::move(fault)};
  return told;
}

}  // namespace breakshot::wire
