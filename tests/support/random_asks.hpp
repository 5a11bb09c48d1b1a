// Asks at random, from a seed: some that a player would make, some that nobody should.
#pragma once

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "common/match/match.hpp"
#include "common/rules/groups.hpp"

namespace breakshot::support {

class RandomAsks {
 public:
  explicit RandomAsks(std::uint64_t seed) : random_(seed) {}

  /// What the player at the table might well do, or now and then the other one; mostly accepted.
  match::Ask sensible(const match::Match& match) {
    const rules::GameStatus& game = match.status.game;
    const match::Author shooter{game.turn};
    if (below(200) == 0) return {any_seat(match), match.next, match::Concede{}};
    if (below(30) == 0) return {any_seat(match), match.next, match::AgreeRerack{}};
    if (!game.options.empty()) {
      return {shooter, match.next, match::Choose{game.options[below(game.options.size())]}};
    }
    if (game.ball_in_hand != rules::BallInHand::none && below(3) == 0) {
      return {shooter, match.next, match::Place{rules::cue_ball, on_bed()}};
    }
    return {shooter, match.next, shot_at_a_target(match)};
  }

  /// Anything whatever: wrong authors, wrong numbers, wrong moments and wrong values.
  match::Ask senseless(const match::Match& match) {
    match::Author author;
    if (below(5) != 0) author.seat = match::Seat{static_cast<std::uint8_t>(below(4))};
    const auto next = static_cast<std::uint32_t>(match.next);
    const std::uint32_t expected = below(5) != 0 ? next : static_cast<std::uint32_t>(random_());
    return {author, match::Seq{expected}, any_command()};
  }

  std::uint64_t below(std::uint64_t end) { return random_() % end; }

 private:
  /// In [low, high).
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  physics::Vec2 on_bed() { return {between(-1.2, 1.2), between(-0.6, 0.6)}; }

  match::Author any_seat(const match::Match& match) {
    return {match::Seat{static_cast<std::uint8_t>(below(match.settings.seats))}};
  }

  match::Shoot shot_at_a_target(const match::Match& match) {
    const rules::GameStatus& game = match.status.game;
    const auto targets = rules::targets(game, match.table);
    const bool calls = match.settings.game == match::GameKind::eight_ball && !game.breaking;
    match::Shoot shoot;
    physics::Vec2 aim = on_bed();
    if (!targets.empty()) {
      const physics::BallId target = targets[below(targets.size())];
      aim = rules::find(match.table, target)->position +
            physics::Vec2{between(-0.04, 0.04), between(-0.04, 0.04)};
      const auto pocket = static_cast<std::uint8_t>(below(6));
      if (calls) shoot.call = {target, physics::PocketId{pocket}, false};
    }
    if (calls && below(10) == 0) shoot.call = {{}, {}, true};
    const physics::Vec2 line = aim - rules::find(match.table, rules::cue_ball)->position;
    shoot.direction = line / physics::length(line);
    shoot.speed_m_s = game.breaking ? between(2, 12) : between(0.3, 6);
    return shoot;
  }

  double any_number() {
    static constexpr double awkward[] = {0.0,
                                         -0.0,
                                         1.0,
                                         -1.0,
                                         1e308,
                                         std::numeric_limits<double>::denorm_min(),
                                         std::numeric_limits<double>::infinity(),
                                         std::numeric_limits<double>::quiet_NaN()};
    return below(3) == 0 ? awkward[below(std::size(awkward))] : between(-1.5, 1.5);
  }
  physics::Vec2 any_vector() { return {any_number(), any_number()}; }
  physics::BallId any_ball() { return physics::BallId{static_cast<std::uint32_t>(below(18))}; }

  match::Command any_command() {
    switch (below(7)) {
      case 0:
        return match::Start{};
      case 1:
        return match::Place{any_ball(), any_vector()};
      case 2: {
        match::Shoot shoot{any_vector(), 10 * any_number(), {}};
        if (below(2) == 0) shoot.direction = {1, 0};
        if (below(2) == 0) shoot.call.ball = any_ball();
        if (below(2) == 0)
          shoot.call.pocket = physics::PocketId{static_cast<std::uint8_t>(below(8))};
        shoot.call.safety = below(2) == 0;
        return shoot;
      }
      case 3:
        return match::Choose{rules::Option{static_cast<std::uint8_t>(below(8))}};
      case 4:
        return below(50) == 0 ? match::Command{match::Concede{}} : match::Command{match::Start{}};
      case 5:
        return match::AgreeRerack{};
      default:
        if (below(50) != 0) return match::Abandoned{match::Seat{200}};
        return match::Abandoned{match::Seat{static_cast<std::uint8_t>(below(3))}};
    }
  }

  std::mt19937_64 random_;
};

}  // namespace breakshot::support
