// What the record says of matches, calls and rulings. This is the format (docs/record.md): whatever
// is changed here but added as a new tag is a new format version.
#pragma once

#include "common/match/match.hpp"
#include "common/record/describe_physics.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::record {

template <>
inline constexpr bool is_id<rules::Seat> = true;
template <>
inline constexpr bool is_id<match::MatchId> = true;
template <>
inline constexpr bool is_id<match::Seq> = true;
template <>
inline constexpr bool is_id<match::CommandId> = true;

template <>
struct Names<rules::BallInHand> {
  static constexpr std::array<std::string_view, 3> all{"none", "behind_head_string", "anywhere"};
};
template <>
struct Names<rules::Group> {
  static constexpr std::array<std::string_view, 3> all{"none", "solids", "stripes"};
};
template <>
struct Names<rules::Foul> {
  static constexpr std::array<std::string_view, 5> all{"scratch", "no_contact", "wrong_ball_first",
                                                       "no_rail", "behind_head_string"};
};
template <>
struct Names<rules::Option> {
  static constexpr std::array<std::string_view, 6> all{
      "accept_table",     "ball_in_hand_behind_head_string",
      "rerack_and_break", "rerack_opponent_breaks",
      "spot_eight",       "spot_nearest_ball"};
};
template <>
struct Names<rules::RackEnd> {
  static constexpr std::array<std::string_view, 4> all{"eight_pocketed", "foul_on_eight",
                                                       "eight_too_early", "eight_wrong_pocket"};
};
template <>
struct Names<match::GameKind> {
  static constexpr std::array<std::string_view, 2> all{"eight_ball", "practice"};
};
template <>
struct Names<match::Stage> {
  static constexpr std::array<std::string_view, 3> all{"gathering", "running", "finished"};
};
template <>
struct Names<match::MatchEnd> {
  static constexpr std::array<std::string_view, 3> all{"race_won", "conceded", "abandoned"};
};

template <>
inline constexpr Choice tag_of<match::Start>{0, "start"};
template <>
inline constexpr Choice tag_of<match::Place>{1, "place"};
template <>
inline constexpr Choice tag_of<match::Shoot>{2, "shoot"};
template <>
struct Growth<match::Shoot> {
  static constexpr Choice tag{7, "shoot_with_tip"};
  static bool needed(const match::Shoot& shoot) { return !(shoot.tip == physics::Tip{}); }
};
template <>
inline constexpr Choice tag_of<match::Choose>{3, "choose"};
template <>
inline constexpr Choice tag_of<match::Concede>{4, "concede"};
template <>
inline constexpr Choice tag_of<match::AgreeRerack>{5, "agree_rerack"};
template <>
inline constexpr Choice tag_of<match::Abandoned>{6, "abandoned"};

// ---- Settings

template <class Codec>
void describe(Codec& c, Value<Codec, match::Settings>& settings) {
  field(c, "preset", settings.preset, max_text_bytes);
  field(c, "scene", settings.scene);
  field(c, "game", settings.game);
  field(c, "seats", settings.seats);
  field(c, "race_to", settings.race_to);
}

// ---- Commands

template <class Codec>
void describe(Codec&, Value<Codec, match::Start>&) {}

template <class Codec>
void describe(Codec& c, Value<Codec, match::Place>& place) {
  field(c, "ball", place.ball);
  field(c, "position", place.position);
}

template <class Codec>
void describe(Codec& c, Value<Codec, rules::Call>& call) {
  field(c, "ball", call.ball);
  field(c, "pocket", call.pocket);
  field(c, "safety", call.safety);
}

template <class Codec>
void describe(Codec& c, Value<Codec, match::Shoot>& shoot) {
  field(c, "direction", shoot.direction);
  field(c, "speed_m_s", shoot.speed_m_s);
  field(c, "call", shoot.call);
}

template <class Codec>
void describe(Codec& c, Value<Codec, physics::Tip>& tip) {
  field(c, "side", tip.side);
  field(c, "height", tip.height);
}

template <class Codec>
void describe_growth(Codec& c, Value<Codec, match::Shoot>& shoot) {
  field(c, "tip", shoot.tip);
}

template <class Codec>
void describe(Codec& c, Value<Codec, match::Choose>& choose) {
  field(c, "option", choose.option);
}

template <class Codec>
void describe(Codec&, Value<Codec, match::Concede>&) {}

template <class Codec>
void describe(Codec&, Value<Codec, match::AgreeRerack>&) {}

template <class Codec>
void describe(Codec& c, Value<Codec, match::Abandoned>& abandoned) {
  field(c, "seat", abandoned.seat);
}

template <class Codec>
void describe(Codec& c, Value<Codec, match::Author>& author) {
  field(c, "seat", author.seat);
}

// ---- Outcomes

template <class Codec>
void describe(Codec& c, Value<Codec, rules::Ruling>& ruling) {
  field(c, "fouls", ruling.fouls, max_fouls);
  field(c, "pocketed", ruling.pocketed, max_balls);
  field(c, "spotted", ruling.spotted, max_balls);
  field(c, "group_won", ruling.group_won);
  field(c, "rack_winner", ruling.rack_winner);
  field(c, "rack_end", ruling.rack_end);
  field(c, "illegal_break", ruling.illegal_break);
}

template <class Codec>
void describe(Codec& c, Value<Codec, rules::GameStatus>& status) {
  field(c, "turn", status.turn);
  field(c, "breaking", status.breaking);
  field(c, "ball_in_hand", status.ball_in_hand);
  field(c, "options", status.options, max_options);
  field(c, "groups", status.groups, max_seats);
}

template <class Codec>
void describe(Codec& c, Value<Codec, match::Status>& status) {
  field(c, "stage", status.stage);
  field(c, "rack", status.rack);
  field(c, "score", status.score, max_seats);
  field(c, "game", status.game);
  field(c, "rerack_agreed", status.rerack_agreed, max_seats);
  field(c, "winner", status.winner);
  field(c, "end", status.end);
}

template <class Codec>
void describe(Codec& c, Value<Codec, match::Outcome>& outcome) {
  field(c, "shot", outcome.shot);
  field(c, "ruling", outcome.ruling);
  field(c, "table", outcome.table);
  field(c, "status", outcome.status);
}

}  // namespace breakshot::record
