// Players at a table of a hub without sockets: what most tests begin with.
#pragma once

#include <string>
#include <utility>

#include "tests/support/hub_rig.hpp"

namespace breakshot::hub {

using support::HubRig;
using support::milliseconds;

struct Player {
  ConnectionId connection{};
  lobby::Token token{};
  std::string name;
};

/// Few entries in memory, few in a batch.
inline Limits small_batches() {
  Limits limits;
  limits.recent_entries = 3;
  limits.batch_bytes = 1500;
  return limits;
}

/// A new guest.
inline Player meet(HubRig& rig, const std::string& name) {
  const ConnectionId connection = rig.open();
  const auto welcome =
      rig.get<lobby::Welcome>(connection, lobby::Hello{lobby::protocol_version, name, {}});
  return {connection, welcome.token.value(), name};
}

/// The same guest on a new connection.
inline Player again(HubRig& rig, const Player& player) {
  const ConnectionId connection = rig.open();
  rig.get<lobby::Welcome>(connection,
                          lobby::Hello{lobby::protocol_version, player.name, player.token});
  return {connection, player.token, player.name};
}

inline lobby::Create eight_ball(bool is_private = false) {
  return {"", match::GameKind::eight_ball, 2, 1, is_private, std::nullopt};
}
inline lobby::Create practice(std::uint8_t seats = 1, bool is_private = false) {
  return {"", match::GameKind::practice, seats, 1, is_private, std::nullopt};
}

inline lobby::MatchInfo create(HubRig& rig, const Player& player, const lobby::Create& create) {
  return rig.get<lobby::MatchNews>(player.connection, create).info;
}

inline lobby::Join join(match::MatchId match) {
  return {match, std::nullopt, {}};
}
inline lobby::Watch watch(match::MatchId match, std::uint32_t from = 0) {
  return {match, std::nullopt, match::Seq{from}};
}
inline lobby::Fetch fetch(match::MatchId match, std::uint32_t from = 0) {
  return {match, std::nullopt, match::Seq{from}};
}

inline match::Contribution share(std::uint8_t of) {
  match::Contribution contribution{};
  contribution.fill(of);
  return contribution;
}

inline void contribute(HubRig& rig, const Player& player, match::MatchId match,
                       std::uint8_t of = 1) {
  rig.get<lobby::Done>(player.connection, lobby::Contribute{match, share(of)});
}

/// A match of 8-ball that has started: entry 0 is stored, seat 0 is to break.
struct Table {
  Player first;
  Player second;
  match::MatchId match{};
};
inline Table sit_down(HubRig& rig, const lobby::Create& wish = eight_ball()) {
  Table table{meet(rig, "Ada"), meet(rig, "Bob"), {}};
  const lobby::MatchInfo info = create(rig, table.first, wish);
  table.match = info.id;
  rig.get<lobby::MatchNews>(table.second.connection, lobby::Join{info.id, info.code, {}});
  contribute(rig, table.first, info.id, 1);
  contribute(rig, table.second, info.id, 2);
  return table;
}

/// A practice of one that has started.
struct Alone {
  Player player;
  match::MatchId match{};
};
inline Alone practise(HubRig& rig, const std::string& name = "Ada", bool is_private = false) {
  Alone alone{meet(rig, name), {}};
  alone.match = create(rig, alone.player, practice(1, is_private)).id;
  contribute(rig, alone.player, alone.match);
  return alone;
}

inline match::Command a_break() {
  return match::Shoot{{1, 0}, 8.0, {}};
}
/// Puts the cue ball somewhere; a different place for each number below 100.
inline match::Command a_place(std::uint32_t number) {
  return match::Place{rules::cue_ball, {-0.9, -0.4 + 0.008 * number}};
}

inline lobby::Act act(match::MatchId match, std::uint32_t expected, std::uint64_t id,
                      const match::Command& command) {
  return {match, match::Seq{expected}, match::CommandId{id}, command};
}

inline lobby::Refused refused(HubRig& rig, const Player& player, lobby::Request request) {
  return rig.get<lobby::Refused>(player.connection, std::move(request));
}

/// The numbers of the entries that a connection was told, in order, whether asked for or not.
inline std::vector<std::uint32_t> told_entries(HubRig& rig, const Player& player) {
  std::vector<std::uint32_t> numbers;
  for (const auto& news : rig.told<lobby::EntryNews>(player.connection)) {
    numbers.push_back(static_cast<std::uint32_t>(news.entry->seq));
  }
  return numbers;
}

/// 0 to end - 1.
inline std::vector<std::uint32_t> up_to(std::uint32_t end, std::uint32_t from = 0) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t number = from; number < end; ++number) numbers.push_back(number);
  return numbers;
}

/// Plays so many entries more of a practice that has `next` entries.
inline void play(HubRig& rig, const Alone& alone, std::uint32_t next, std::uint32_t entries) {
  for (std::uint32_t i = next; i < next + entries; ++i) {
    rig.get<lobby::EntryNews>(alone.player.connection, act(alone.match, i, i, a_place(i % 100)));
  }
}

}  // namespace breakshot::hub
