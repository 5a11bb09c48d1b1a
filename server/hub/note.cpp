#include "server/hub/note.hpp"

#include <array>
#include <span>

#include "common/hash/hash.hpp"

namespace breakshot::hub {
namespace {

std::string name_of(match::MatchId id) {
  const auto value = static_cast<std::uint64_t>(id);
  std::array<std::uint8_t, 8> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::uint8_t>(value >> (8 * (bytes.size() - 1 - i)));
  }
  return "match " + hash::hex_of(bytes);
}

std::string sentence(const GuestCame& note) {
  return "connection " + std::to_string(static_cast<std::uint64_t>(note.connection)) + " is " +
         (note.is_new ? "the new guest " : "the guest ") + note.name;
}
std::string sentence(const MatchOpened& note) {
  return name_of(note.match) + " is open";
}
std::string sentence(const MatchStarted& note) {
  return name_of(note.match) + " has started";
}
std::string sentence(const MatchFinished& note) {
  const std::string how = note.end == match::MatchEnd::race_won   ? "by the race"
                          : note.end == match::MatchEnd::conceded ? "conceded"
                                                                  : "abandoned";
  const std::string winner =
      note.winner ? ", won by seat " + std::to_string(rules::number(*note.winner)) : "";
  return name_of(note.match) + " is finished, " + how + winner;
}
std::string sentence(const MatchDiscarded& note) {
  return name_of(note.match) + " was discarded before it started";
}
std::string sentence(const MatchRestored& note) {
  return name_of(note.match) + " goes on at entry " +
         std::to_string(static_cast<std::uint32_t>(note.next));
}
std::string sentence(const MatchSetAside& note) {
  return name_of(note.match) + " cannot go on: " + note.why;
}
std::string sentence(const StoreRefused& note) {
  return "the store failed: " + note.why;
}

}  // namespace

bool is_alarming(const Note& note) {
  return std::holds_alternative<MatchSetAside>(note) || std::holds_alternative<StoreRefused>(note);
}

std::string sentence_of(const Note& note) {
  return std::visit([](const auto& n) { return sentence(n); }, note);
}

}  // namespace breakshot::hub
