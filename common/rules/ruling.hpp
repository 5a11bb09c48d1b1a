// The vocabulary of rulings: what a player calls, what a game asks of whom, and what a shot meant.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/physics/ball.hpp"

namespace breakshot::rules {

/// A player's place at the table: 0 is the one who created the match.
enum class Seat : std::uint8_t {};
constexpr std::uint8_t number(Seat seat) {
  return static_cast<std::uint8_t>(seat);
}

inline constexpr physics::BallId cue_ball{0};
inline constexpr physics::BallId eight_ball_id{8};

/// What the shooter announces: a ball and a pocket, or `safety`, never both; and nothing at all
/// where the game asks for no call (the break, practice).
struct Call {
  std::optional<physics::BallId> ball;
  std::optional<physics::PocketId> pocket;
  bool safety = false;  ///< the turn passes after a legal shot, whatever is pocketed

  friend bool operator==(const Call&, const Call&) = default;
};

/// Where the shooter may place the cue ball.
enum class BallInHand : std::uint8_t { none, behind_head_string, anywhere };

enum class Group : std::uint8_t { none, solids, stripes };

/// Ways to break the rules that a planar table can show. The order is that of the record.
enum class Foul : std::uint8_t {
  scratch,             ///< the cue ball was pocketed
  no_contact,          ///< the cue ball hit no ball
  wrong_ball_first,    ///< the first ball hit was not one of the shooter's
  no_rail,             ///< after the contact no ball was pocketed and none reached a cushion
  behind_head_string,  ///< bad play from behind the head string
};

/// Choices that the rules give a player. The order is that of the record.
enum class Option : std::uint8_t {
  accept_table,  ///< shoot from the position as it is
  ball_in_hand_behind_head_string,
  rerack_and_break,  ///< the chooser breaks
  rerack_opponent_breaks,
  spot_eight,  ///< after the 8 on the break: spot it and go on
  /// All balls that may be hit first lie behind the head string, and so must the cue ball: the one
  /// nearest the string is spotted.
  spot_nearest_ball,
};

/// How a rack (one game of a race) was decided.
enum class RackEnd : std::uint8_t {
  eight_pocketed,      ///< legally: won
  foul_on_eight,       ///< pocketed the 8 with a foul: lost
  eight_too_early,     ///< before the group was cleared, or with its last ball: lost
  eight_wrong_pocket,  ///< in a pocket that was not called: lost
};

/// What one shot meant, in the order in which a referee would say it.
struct Ruling {
  std::vector<Foul> fouls;
  std::vector<physics::BallId> pocketed;  ///< in order, the cue ball included
  std::vector<physics::BallId> spotted;   ///< put back on the table by the rules
  std::optional<Group> group_won;         ///< the shooter's from now on
  std::optional<Seat> rack_winner;
  std::optional<RackEnd> rack_end;
  bool illegal_break = false;  ///< nothing pocketed and fewer than four balls to cushions

  friend bool operator==(const Ruling&, const Ruling&) = default;
};

/// What a game knows between shots, as anyone may see it.
struct GameStatus {
  Seat turn{};            ///< who is to shoot or choose
  bool breaking = false;  ///< the next shot is a break
  BallInHand ball_in_hand = BallInHand::none;
  std::vector<Option> options;  ///< what `turn` must choose from first; empty when it is to shoot
  std::vector<Group> groups;    ///< by seat; none on an open table

  friend bool operator==(const GameStatus&, const GameStatus&) = default;
};

}  // namespace breakshot::rules
