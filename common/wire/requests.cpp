// What clients ask.
#include <google/protobuf/arena.h>

#include <variant>

#include "breakshot/v1/session.pb.h"
#include "common/lobby/code.hpp"
#include "common/lobby/name.hpp"
#include "common/wire/check.hpp"
#include "common/wire/matches.hpp"
#include "common/wire/message.hpp"
#include "common/wire/translate.hpp"

namespace breakshot::wire {
namespace {

static_assert(v1::Filter_MAX == static_cast<int>(lobby::Filter::finished) + 1);

// ---- Writing

/// Join, Watch and Fetch name a match in the same way.
template <class Request, class Message>
void write_target(const Request& request, Message& message) {
  if (request.match) message.set_match(static_cast<std::uint64_t>(*request.match));
  if (request.code) message.set_code(*request.code);
  message.set_from(static_cast<std::uint32_t>(request.from));
}

struct RequestWriter {
  v1::ClientToServer& message;

  void operator()(const lobby::Hello& hello) const {
    v1::Hello& said = *message.mutable_hello();
    said.set_version(hello.version);
    said.set_name(hello.name);
    if (hello.token) said.set_token(hello.token->data(), hello.token->size());
  }
  void operator()(const lobby::Create& create) const {
    v1::Create& said = *message.mutable_create();
    said.set_preset(create.preset);
    said.set_game(enum_of<v1::GameKind>(create.game));
    said.set_seats(create.seats);
    said.set_race_to(create.race_to);
    said.set_is_private(create.is_private);
    if (create.key) said.set_key(create.key->data(), create.key->size());
  }
  void operator()(const lobby::Join& join) const { write_target(join, *message.mutable_join()); }
  void operator()(const lobby::Watch& watch) const {
    write_target(watch, *message.mutable_watch());
  }
  void operator()(const lobby::List& list) const {
    v1::List& said = *message.mutable_list();
    said.set_filter(enum_of<v1::Filter>(list.filter));
    if (!list.after) return;
    said.mutable_after()->set_created_unix_ms(list.after->created_unix_ms);
    said.mutable_after()->set_match(static_cast<std::uint64_t>(list.after->match));
  }
  void operator()(const lobby::Fetch& fetch) const {
    write_target(fetch, *message.mutable_fetch());
  }
  void operator()(const lobby::Contribute& contribute) const {
    v1::Contribute& said = *message.mutable_contribute();
    said.set_match(static_cast<std::uint64_t>(contribute.match));
    said.set_contribution(contribute.contribution.data(), contribute.contribution.size());
  }
  void operator()(const lobby::Act& act) const {
    v1::Act& said = *message.mutable_act();
    said.set_match(static_cast<std::uint64_t>(act.match));
    said.set_expected(static_cast<std::uint32_t>(act.expected));
    said.set_id(static_cast<std::uint64_t>(act.id));
    write(act.command, *said.mutable_command());
  }
  void operator()(const lobby::Claim& claim) const {
    message.mutable_claim()->set_match(static_cast<std::uint64_t>(claim.match));
  }
  void operator()(const lobby::Leave& leave) const {
    message.mutable_leave()->set_match(static_cast<std::uint64_t>(leave.match));
  }
  void operator()(const lobby::Ping&) const { message.mutable_ping(); }
};

// ---- Reading

template <class Request, class Message>
Request read_target(const Message& message, const Where& at) {
  Request request;
  if (message.has_match()) request.match = match::MatchId{message.match()};
  if (!message.code().empty()) {
    request.code = lobby::code_of(message.code());
    if (!request.code) {
      Where(at, "code").refuse("is no invite code; those have 10 letters and digits, without U");
    }
  }
  if (!request.match && !request.code) {
    at.refuse("names no match; its id or its code must be given");
  }
  request.from = match::Seq{message.from()};
  return request;
}

lobby::Hello read(const v1::Hello& message, const Where& at) {
  if (const auto fault = lobby::name_fault(message.name())) Where(at, "name").refuse(*fault);
  return {message.version(), message.name(), optional_bytes32(message.token(), Where(at, "token"))};
}

lobby::Create read(const v1::Create& message, const Where& at) {
  const Where game(at, "game");
  return {preset(message.preset(), Where(at, "preset")),
          enumerated<match::GameKind>(message.game(), v1::GameKind_MAX, game),
          seat_count(message.seats(), Where(at, "seats")),
          message.race_to(),
          message.is_private(),
          optional_bytes16(message.key(), Where(at, "key"))};
}

lobby::List read(const v1::List& message, const Where& at) {
  lobby::List list;
  const Where filter(at, "filter");
  list.filter = enumerated<lobby::Filter>(message.filter(), v1::Filter_MAX, filter);
  if (message.has_after()) {
    list.after =
        lobby::Position{message.after().created_unix_ms(), match::MatchId{message.after().match()}};
  }
  return list;
}

lobby::Contribute read(const v1::Contribute& message, const Where& at) {
  return {match::MatchId{message.match()},
          bytes32(message.contribution(), Where(at, "contribution"))};
}

lobby::Act read(const v1::Act& message, const Where& at) {
  lobby::Act act;
  act.match = match::MatchId{message.match()};
  act.expected = match::Seq{message.expected()};
  act.id = match::CommandId{message.id()};
  if (message.id() == 0) Where(at, "id").refuse("is 0 or missing; it must be a random number");
  const Where command(at, "command");
  act.command = read(message.command(), command);
  if (std::holds_alternative<match::Start>(act.command) ||
      std::holds_alternative<match::Abandoned>(act.command)) {
    command.refuse("is one of the server's; players place, shoot, choose, concede or agree");
  }
  return act;
}

lobby::Request read_request(const v1::ClientToServer& message, const Where& at) {
  using Kind = v1::ClientToServer::RequestCase;
  switch (message.request_case()) {
    case Kind::kHello:
      return read(message.hello(), Where(at, "hello"));
    case Kind::kCreate:
      return read(message.create(), Where(at, "create"));
    case Kind::kJoin:
      return read_target<lobby::Join>(message.join(), Where(at, "join"));
    case Kind::kWatch:
      return read_target<lobby::Watch>(message.watch(), Where(at, "watch"));
    case Kind::kList:
      return read(message.list(), Where(at, "list"));
    case Kind::kFetch:
      return read_target<lobby::Fetch>(message.fetch(), Where(at, "fetch"));
    case Kind::kContribute:
      return read(message.contribute(), Where(at, "contribute"));
    case Kind::kAct:
      return read(message.act(), Where(at, "act"));
    case Kind::kClaim:
      return lobby::Claim{match::MatchId{message.claim().match()}};
    case Kind::kLeave:
      return lobby::Leave{match::MatchId{message.leave().match()}};
    case Kind::kPing:
      return lobby::Ping{};
    case Kind::REQUEST_NOT_SET:
      break;
  }
  Where(at, "request").refuse("is missing, or one that this version of the protocol does not know");
  return lobby::Ping{};
}

}  // namespace

ByteVector frame_of(const lobby::Asked& asked) {
  v1::ClientToServer message;
  message.set_request_id(static_cast<std::uint32_t>(asked.id));
  std::visit(RequestWriter{message}, asked.request);
  return frame_of_message(message);
}

std::variant<lobby::Asked, Malformed> read_asked(hash::Bytes body) {
  google::protobuf::Arena arena;
  auto& message = *google::protobuf::Arena::CreateMessage<v1::ClientToServer>(&arena);
  if (auto fault = parse(body, message)) return Malformed{std::nullopt, *std::move(fault)};
  const lobby::RequestId id{message.request_id()};
  std::optional<physics::Fault> fault;
  const Where top(fault);
  if (message.request_id() == 0) {
    Where(top, "request_id").refuse("is 0 or missing; that stands for what nobody asked for");
  }
  lobby::Asked asked{id, read_request(message, top)};
  if (fault) return Malformed{id, *std::move(fault)};
  return asked;
}

}  // namespace breakshot::wire
