// Whose turn it is. A match is a value and a fold over commands: apply(match, ask) gives the next
// match and what happened, or says why not. No input or output, no clock, no entropy of its own.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/hash/hash.hpp"
#include "common/physics/event.hpp"
#include "common/physics/perturbation.hpp"
#include "common/physics/scene.hpp"
#include "common/physics/simulate.hpp"
#include "common/rules/eight_ball.hpp"
#include "common/rules/practice.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::match {

using rules::Seat;

enum class MatchId : std::uint64_t {};
/// Number of an entry: 0 is the start, then one a command.
enum class Seq : std::uint32_t {};
/// Chosen at random by the client: the same id is the same command, sent again.
enum class CommandId : std::uint64_t {};

using Secret = std::array<std::uint8_t, 32>;
using Contribution = std::array<std::uint8_t, 32>;

enum class GameKind : std::uint8_t { eight_ball, practice };

inline constexpr std::uint32_t max_race_to = 100;
inline constexpr std::size_t max_practice_seats = 8;

/// What a match is, fixed when it is created.
struct Settings {
  std::string preset;  ///< the name of the scene, for people
  physics::Scene
      scene;  ///< the scene itself: the record does not depend on what a name means later
  GameKind game = GameKind::eight_ball;
  std::uint8_t seats = 2;     ///< 2 in 8-ball, 1 to 8 in practice
  std::uint32_t race_to = 1;  ///< racks to win, [1, 100]; 1 in practice

  friend bool operator==(const Settings&, const Settings&) = default;
};

std::vector<physics::Fault> faults_of(const Settings& settings);

// ---- Commands

/// The server's, once every seat has contributed: derives the seed and racks the balls.
struct Start {
  friend bool operator==(const Start&, const Start&) = default;
};
/// Puts a ball in hand on the table. Only the cue ball, except in practice.
struct Place {
  physics::BallId ball = rules::cue_ball;
  physics::Vec2 position;  ///< m
  friend bool operator==(const Place&, const Place&) = default;
};
struct Shoot {
  physics::Vec2 direction;  ///< unit vector
  double speed_m_s = 0;     ///< (0, max_shot_speed_m_s]
  rules::Call call;
  physics::Tip tip{};  ///< within physics::miscue_offset; the centre where balls have no spin
  friend bool operator==(const Shoot&, const Shoot&) = default;
};
struct Choose {
  rules::Option option{};
  friend bool operator==(const Choose&, const Choose&) = default;
};
/// 8-ball: the match is lost. Practice: the seat leaves, and the match ends, without a winner, when
/// the last one has left. At any time, whoever's turn it is.
struct Concede {
  friend bool operator==(const Concede&, const Concede&) = default;
};
/// Agrees to rack again: done when every seat has agreed since the last shot. 8-ball: a stalemate,
/// once the rack has been broken; the same player breaks again. Practice: a full rack, at any time,
/// when all who have not left agree.
struct AgreeRerack {
  friend bool operator==(const AgreeRerack&, const AgreeRerack&) = default;
};
/// The server's: `seat` has left for good and loses; in practice it leaves.
struct Abandoned {
  Seat seat{};
  friend bool operator==(const Abandoned&, const Abandoned&) = default;
};

/// The order of the alternatives is that of the record and must not change.
using Command = std::variant<Start, Place, Shoot, Choose, Concede, AgreeRerack, Abandoned>;

inline constexpr double max_shot_speed_m_s = 13.0;  ///< faster than any measured break

/// Who asks. `server` is no seat.
struct Author {
  std::optional<Seat> seat;  ///< missing: the server
  friend bool operator==(const Author&, const Author&) = default;
};

// ---- What a command led to

enum class Stage : std::uint8_t { gathering, running, finished };
enum class MatchEnd : std::uint8_t { race_won, conceded, abandoned };

/// The match as anyone may see it, after an entry.
struct Status {
  Stage stage = Stage::gathering;
  std::uint32_t rack = 0;            ///< the rack being played, from 1; 0 before the start
  std::vector<std::uint32_t> score;  ///< racks won, by seat
  rules::GameStatus game;
  std::vector<bool> rerack_agreed;  ///< by seat
  std::optional<Seat> winner;
  std::optional<MatchEnd> end;

  friend bool operator==(const Status&, const Status&) = default;
};

/// A command's outcome: everything needed to show it without simulating or judging again.
struct Outcome {
  std::optional<physics::Shot> shot;
  std::optional<rules::Ruling> ruling;  ///< with every shot and every choice
  physics::State table;  ///< at rest, after the ruling: what the next shot starts from
  Status status;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// The whole state of a running match. Everything but the seed is public.
struct Match {
  Settings settings;
  std::uint32_t physics = physics::physics_version;  ///< the version that simulates its shots
  physics::Seed seed{};                              ///< seed_of(secret, contributions)
  Seq next{};                                        ///< the number of the next entry
  std::uint32_t shots = 0;                           ///< shots taken: the number of the next one
  std::uint32_t racks = 0;  ///< racks set up: the number of the next one in the rack stream
  physics::State table;
  std::variant<rules::EightBall, rules::Practice> game;
  Status status;

  friend bool operator==(const Match&, const Match&) = default;
};

/// H(secret), published before anybody contributes.
hash::Digest commitment_of(const Secret& secret);
/// The match seed: the first 16 bytes of HMAC-SHA-256(secret, contributions in order of seat).
physics::Seed seed_of(const Secret& secret, const std::vector<Contribution>& contributions);

/// The match before its Start command. `settings` must be free of faults.
Match created(const Settings& settings, const physics::Seed& seed,
              std::uint32_t physics = physics::physics_version);

struct Ask {
  Author author;
  Seq expected{};  ///< the number that the entry is to have
  Command command;
};

struct Accepted {
  Match next;
  Outcome outcome;
};

enum class RefusalCode : std::uint8_t {
  wrong_sequence,  ///< the match has moved on: look again
  not_your_turn,
  not_allowed_now,  ///< e.g. shooting while a choice is open
  bad_value,        ///< e.g. a direction that is no unit vector, a position on another ball
  stalled,          ///< the shot could not be simulated; the match is unchanged
  finished,
};

/// A player's mistake is a value: what was wrong and what would be right.
struct Refusal {
  RefusalCode code{};
  std::string what;

  friend bool operator==(const Refusal&, const Refusal&) = default;
};

std::variant<Accepted, Refusal> apply(const Match& match, const Ask& ask);

}  // namespace breakshot::match
