// A real match, played by players who do legal things at random, from a seed: what the record, the
// store and the wire are tested with.
#pragma once

#include <stdexcept>

#include "common/match/match.hpp"
#include "common/physics/angle.hpp"
#include "common/physics/table.hpp"
#include "common/record/record.hpp"
#include "tests/support/arbitrary_record.hpp"

namespace breakshot::support {

class PlayedMatch {
 public:
  PlayedMatch(std::uint64_t seed, match::GameKind game, std::uint8_t seats,
              const physics::Preset& preset = physics::presets().front(),
              std::uint32_t physics = physics::physics_version)
      : random_(seed), match_(begin(game, seats, preset, physics)) {
    add({}, match::Start{});
  }

  const match::Match& match() const { return match_; }
  /// The record so far: without the secret until the match is finished.
  const record::Record& record() const { return record_; }

  /// One command of the player whose turn it is.
  void step() {
    const rules::GameStatus& game = match_.status.game;
    const match::Author author{game.turn};
    if (!game.options.empty()) {
      add(author, match::Choose{game.options[random_.below(game.options.size())]});
    } else if (game.ball_in_hand != rules::BallInHand::none && random_.coin()) {
      try_to(author, match::Place{rules::cue_ball, somewhere()});
    } else {
      try_to(author, shot());
    }
  }

  /// Plays so many commands, then gives up.
  void play(int commands) {
    for (int i = 0; i < commands && running(); ++i) step();
    for (std::uint8_t seat = 0; running(); ++seat) add({rules::Seat{seat}}, match::Concede{});
  }

  bool running() const { return match_.status.stage == match::Stage::running; }

  /// Does what must be allowed.
  void add(const match::Author& author, const match::Command& command) {
    if (const auto refusal = try_to(author, command)) {
      throw std::logic_error("a played match was refused a command: " + refusal->what);
    }
  }

 private:
  match::Match begin(match::GameKind game, std::uint8_t seats, const physics::Preset& preset,
                     std::uint32_t physics) {
    record::Header& header = record_.header;
    header.physics = physics;
    header.id = match::MatchId{random_.below(1'000'000)};
    header.settings = {std::string(preset.name), preset.scene, game, seats, 1};
    std::vector<match::Contribution> contributions;
    for (std::uint8_t seat = 0; seat < seats; ++seat) {
      contributions.push_back(random_.bytes<32>());
      header.players.push_back({"player " + std::to_string(seat), contributions.back()});
    }
    secret_ = random_.bytes<32>();
    header.commitment = match::commitment_of(secret_);
    return match::created(header.settings, match::seed_of(secret_, contributions), physics);
  }

  std::optional<match::Refusal> try_to(const match::Author& author, const match::Command& command) {
    auto answer = match::apply(match_, {author, match_.next, command});
    if (const auto* refusal = std::get_if<match::Refusal>(&answer)) return *refusal;
    auto& accepted = std::get<match::Accepted>(answer);
    record::Entry entry;
    entry.seq = match_.next;
    entry.author = author;
    entry.id = match::CommandId{1 + random_.below(1'000'000)};
    entry.command = command;
    entry.outcome = std::move(accepted.outcome);
    match_ = std::move(accepted.next);
    if (!running()) entry.secret = secret_;
    const auto& entries = record_.entries;
    entry.digest = record::digest_of(
        entries.empty() ? record::digest_of(record_.header) : entries.back().digest, entry);
    record_.entries.push_back(std::move(entry));
    return std::nullopt;
  }

  double within(double half) {
    return half * (static_cast<double>(random_.below(2001)) / 1000 - 1);
  }

  physics::Vec2 somewhere() {
    const physics::Bed& bed = record_.header.settings.scene.bed;
    return {within(bed.length_m.value() / 2), within(bed.width_m.value() / 2)};
  }

  match::Command shot() {
    const rules::GameStatus& game = match_.status.game;
    match::Shoot shoot{physics::direction_of(within(physics::pi)), 1 + within(0.9), {}};
    const physics::Motion& motion = match_.settings.scene.bed.motion;
    if (std::holds_alternative<physics::Spinning>(motion) && random_.coin()) {
      shoot.tip = {within(0.35), within(0.35)};
    }
    if (game.breaking) {
      shoot.direction = physics::direction_of(within(0.02));
      shoot.speed_m_s = random_.coin() ? 8 : 1;  // the slow one is no legal break
    } else if (match_.settings.game == match::GameKind::eight_ball) {
      shoot.call = call();
    }
    return shoot;
  }

  rules::Call call() {
    const auto& balls = match_.table.balls;
    const physics::BallId ball = balls[random_.below(balls.size())].id;
    if (ball == rules::cue_ball) return {std::nullopt, std::nullopt, true};
    return {ball, physics::PocketId(random_.below(6)), false};
  }

  Arbitrary random_;
  match::Secret secret_{};
  record::Record record_;
  match::Match match_;
};

}  // namespace breakshot::support
