// One small record, made by hand, in which every kind of command and event and most of the optional
// fields occur. Its bytes are the format's golden fixture and must never change by accident. What
// happens in it is no real game.
#pragma once

#include "common/record/record.hpp"

namespace breakshot::record {

template <std::size_t N>
std::array<std::uint8_t, N> counted_bytes(std::uint8_t first) {
  std::array<std::uint8_t, N> bytes{};
  for (std::size_t i = 0; i < N; ++i) bytes[i] = static_cast<std::uint8_t>(first + i);
  return bytes;
}

inline physics::Scene fixed_scene() {
  physics::Scene scene;
  scene.gravity_m_s2 = 9.81;
  scene.bed = {physics::Straight{}, 2.3368, 1.1684};
  physics::FreeCushions cushions;
  cushions.segments.push_back({{1, -1}, {1, 1}, physics::Mirror{}});
  cushions.segments.push_back({{1, 1}, {-1, 1}, physics::CushionRestitution{0.85, 0.9, 1e-3}});
  scene.cushions = cushions;
  scene.pockets = physics::StandardPockets{};
  scene.ball_ball = physics::BallRestitution{};
  scene.perturbation = physics::Perturbation{0.001, 0.002};
  return scene;
}

inline Header fixed_header() {
  Header header;
  header.physics = 1;
  header.id = match::MatchId{0x0123456789abcdef};
  header.created_unix_ms = 1'700'000'000'000;
  header.settings = {"paper", fixed_scene(), match::GameKind::eight_ball, 2, 3};
  header.players = {{"Ada", counted_bytes<32>(0x10)}, {"Zoë", counted_bytes<32>(0x30)}};
  header.commitment = counted_bytes<32>(0x50);
  return header;
}

inline match::Status fixed_status() {
  match::Status status;
  status.stage = match::Stage::running;
  status.rack = 1;
  status.score = {1, 2};
  status.game.turn = rules::Seat{1};
  status.game.groups = {rules::Group::solids, rules::Group::stripes};
  status.rerack_agreed = {false, true};
  return status;
}

inline physics::State fixed_table() {
  return {{{physics::BallId{0}, {-0.5842, 0.25}, {}, {}},
           {physics::BallId{9}, {0.5842, -0.125}, {0.5, 0}, {1, 2, 3}}}};
}

inline physics::Shot fixed_shot() {
  const physics::BallId cue{0}, object{9};
  physics::Shot shot;
  shot.events = {physics::Struck{0, cue},
                 physics::BallBall{0.5, 0, cue, object},
                 physics::BallCushion{0.75, 1, object, physics::CushionId{1}},
                 physics::BallPocket{1.25, 0, object, physics::PocketId{4}},
                 physics::Rolls{1.5, cue},
                 physics::Rests{2, cue}};
  shot.segments = {
      {cue, physics::Phase::slide, 0, {-0.5842, 0.25}, {3, 0.5}, {-1.962, -0.327}},
      {object, physics::Phase::rest, 0, {0.5842, -0.125}, {}, {}},
      {cue, physics::Phase::slide, 0.5, {0.5, 0.25}, {1, 0}, {-1.962, 0}},
      {object, physics::Phase::slide, 0.5, {0.5842, -0.125}, {2, 0}, {-1.962, 0}},
      {object, physics::Phase::pocketed, 1.25, {1.1684, -0.5842}, {}, {}},
      {cue, physics::Phase::roll, 1.5, {0.75, 0.25}, {0.05, 0}, {-0.0981, 0}},
      {cue, physics::Phase::rest, 2, {0.75, 0.25}, {}, {}},
  };
  shot.end_s = 2;
  return shot;
}

inline match::Outcome fixed_outcome() {
  return {std::nullopt, std::nullopt, fixed_table(), fixed_status()};
}

inline rules::Ruling fixed_ruling() {
  rules::Ruling ruling;
  ruling.fouls = {rules::Foul::scratch, rules::Foul::no_rail};
  ruling.pocketed = {physics::BallId{9}, physics::BallId{0}};
  ruling.spotted = {physics::BallId{8}};
  ruling.group_won = rules::Group::stripes;
  ruling.rack_winner = rules::Seat{1};
  ruling.rack_end = rules::RackEnd::foul_on_eight;
  ruling.illegal_break = true;
  return ruling;
}

inline Record fixed_record() {
  Record record{fixed_header(), {}};
  const std::vector<std::pair<match::Author, match::Command>> asks{
      {{}, match::Start{}},
      {{rules::Seat{0}}, match::Place{physics::BallId{0}, {-0.75, 0.125}}},
      {{rules::Seat{0}},
       match::Shoot{{0.6, -0.8}, 3.5, {physics::BallId{9}, physics::PocketId{4}, true}}},
      {{rules::Seat{1}}, match::Choose{rules::Option::spot_eight}},
      {{rules::Seat{1}}, match::AgreeRerack{}},
      {{rules::Seat{1}}, match::Concede{}},
      {{}, match::Abandoned{rules::Seat{1}}},
  };
  hash::Digest before = digest_of(record.header);
  for (const auto& [author, command] : asks) {
    Entry entry;
    entry.seq = match::Seq{static_cast<std::uint32_t>(record.entries.size())};
    entry.author = author;
    entry.id = match::CommandId{0xfedcba9876543210 + record.entries.size()};
    entry.command = command;
    entry.outcome = fixed_outcome();
    if (std::holds_alternative<match::Shoot>(command)) {
      entry.outcome.shot = fixed_shot();
      entry.outcome.ruling = fixed_ruling();
      entry.outcome.status.game.breaking = true;
      entry.outcome.status.game.ball_in_hand = rules::BallInHand::anywhere;
      entry.outcome.status.game.options = {rules::Option::accept_table,
                                           rules::Option::rerack_and_break};
    }
    if (std::holds_alternative<match::Abandoned>(command)) {
      entry.outcome.status.stage = match::Stage::finished;
      entry.outcome.status.winner = rules::Seat{0};
      entry.outcome.status.end = match::MatchEnd::abandoned;
      entry.secret = counted_bytes<32>(0x70);
    }
    entry.digest = before = digest_of(before, entry);
    record.entries.push_back(entry);
  }
  return record;
}

}  // namespace breakshot::record
