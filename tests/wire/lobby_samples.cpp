// Random requests and answers.
#include <memory>
#include <stdexcept>
#include <string_view>

#include "common/physics/table.hpp"
#include "tests/wire/samples.hpp"

namespace breakshot::wire::samples {
namespace {

match::MatchId random_match_id(Chance& chance) {
  return match::MatchId{chance.bits()};
}

std::string random_text(Chance& chance) {
  return chance.coin() ? std::string() : random_name(chance) + ' ' + random_name(chance);
}

std::string random_code(Chance& chance) {
  static constexpr std::string_view digits = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
  std::string code;
  while (code.size() < lobby::invite_code_length) code += digits[chance.below(digits.size())];
  return code;
}

lobby::CreationKey random_key(Chance& chance) {
  lobby::CreationKey key{};
  for (std::uint8_t& byte : key) byte = static_cast<std::uint8_t>(chance.bits());
  return key;
}

lobby::MatchInfo random_info(Chance& chance) {
  lobby::MatchInfo info;
  info.id = random_match_id(chance);
  info.settings = random_settings(chance);
  info.commitment = chance.bytes32();
  info.created_unix_ms = static_cast<std::int64_t>(chance.bits());
  info.stage = chance.one_of<match::Stage>(3);
  for (std::size_t i = 0; i < info.settings.seats; ++i) {
    info.seats.push_back({chance.coin() ? random_name(chance) : std::string(), chance.coin(),
                          chance.coin(), static_cast<std::int64_t>(chance.bits() >> 1)});
  }
  info.score = chance.some(8, [](Chance& c) { return c.u32(); });
  info.next = random_seq(chance);
  info.winner = chance.maybe(random_seat);
  info.end = random_end(chance);
  info.is_private = chance.coin();
  info.code = chance.maybe(random_code);
  return info;
}

template <class Request>
Request random_target(Chance& chance) {
  Request request;
  const std::size_t which = chance.below(3);
  if (which != 0) request.match = random_match_id(chance);
  if (which != 1) request.code = random_code(chance);
  request.from = random_seq(chance);
  return request;
}

}  // namespace

lobby::Request random_request(Chance& chance, std::size_t index) {
  switch (index) {
    case 0:
      return lobby::Hello{chance.u32(), random_name(chance),
                          chance.maybe([](Chance& c) { return c.bytes32(); })};
    case 1:
      return lobby::Create{std::string(physics::presets().front().name),
                           chance.one_of<match::GameKind>(2),
                           static_cast<std::uint8_t>(1 + chance.below(8)),
                           chance.u32(),
                           chance.coin(),
                           chance.maybe(random_key)};
    case 2:
      return random_target<lobby::Join>(chance);
    case 3:
      return random_target<lobby::Watch>(chance);
    case 4:
      return lobby::List{
          chance.one_of<lobby::Filter>(4), chance.maybe([](Chance& c) {
            return lobby::Position{static_cast<std::int64_t>(c.bits()), random_match_id(c)};
          })};
    case 5:
      return random_target<lobby::Fetch>(chance);
    case 6:
      return lobby::Contribute{random_match_id(chance), chance.bytes32()};
    case 7:
      return lobby::Act{random_match_id(chance), random_seq(chance),
                        match::CommandId{chance.bits() | 1},
                        random_command(chance, 1 + chance.below(5))};
    case 8:
      return lobby::Claim{random_match_id(chance)};
    case 9:
      return lobby::Leave{random_match_id(chance)};
    case 10:
      return lobby::Ping{};
    default:
      throw std::logic_error("no such request");
  }
}

lobby::Answer random_answer(Chance& chance, std::size_t index) {
  switch (index) {
    case 0:
      return lobby::Welcome{random_name(chance),
                            chance.maybe([](Chance& c) { return c.bytes32(); }),
                            random_text(chance), static_cast<std::int64_t>(chance.bits() >> 1)};
    case 1:
      return lobby::Refused{chance.one_of<lobby::RefusalCode>(12),
                            chance.maybe([](Chance& c) { return c.one_of<match::RefusalCode>(6); }),
                            random_text(chance)};
    case 2:
      return lobby::MatchNews{random_info(chance), chance.maybe(random_seat),
                              chance.maybe(random_header)};
    case 3:
      return lobby::EntryNews{random_match_id(chance),
                              std::make_shared<const record::Entry>(random_entry(chance))};
    case 4:
      return lobby::MatchGone{random_match_id(chance), random_text(chance)};
    case 5:
      return lobby::Listing{chance.some(5, random_info), chance.coin()};
    case 6:
      return lobby::FetchDone{random_match_id(chance), random_seq(chance)};
    case 7:
      return lobby::Done{};
    case 8:
      return lobby::Goodbye{chance.one_of<lobby::GoodbyeReason>(6), random_text(chance)};
    default:
      throw std::logic_error("no such answer");
  }
}

}  // namespace breakshot::wire::samples
