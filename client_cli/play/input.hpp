// What a player types at the table: one line, one wish.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/match/match.hpp"

namespace breakshot::client {

struct Nothing {};
/// Aim along an angle from +x, the way to the foot of the table, towards +y, its left.
struct AimAlong {
  double degrees = 0;
};
/// Aim at a ball, full, or so that it goes into a pocket.
struct AimAt {
  physics::BallId ball{};
  std::optional<physics::PocketId> pocket;
};
struct TurnBy {
  double degrees = 0;  ///< positive: to the left
};
struct SetSpeed {
  double m_s = 0;
};
/// Meet the cue ball off its centre.
struct SetTip {
  physics::Tip tip;
};
struct MakeCall {
  rules::Call call;
};
struct PlaceBall {
  physics::BallId ball = rules::cue_ball;
  physics::Vec2 position;  ///< m
};
struct ShootNow {};
struct TakeOption {
  std::size_t number = 0;  ///< from 1, as they are listed
};
struct ShowTable {};
struct TellStatus {};
struct TellInvitation {};
struct GiveUp {
  bool sure = false;
};
struct AgreeToRerack {};
struct ClaimMatch {};
struct AskHelp {
  std::string topic;
};
struct LeaveTable {};

using Input = std::variant<Nothing, AimAlong, AimAt, TurnBy, SetSpeed, SetTip, MakeCall, PlaceBall,
                           ShootNow, TakeOption, ShowTable, TellStatus, TellInvitation, GiveUp,
                           AgreeToRerack, ClaimMatch, AskHelp, LeaveTable>;

/// Why a line was not understood, and what would have been.
struct Misread {
  std::string what;
};

std::variant<Input, Misread> input_of(std::string_view line);

/// The pocket of that name: "foot-left", "left foot", "side right", "fl"; nothing if it is none.
std::optional<physics::PocketId> pocket_of(std::string_view text);

/// What can be typed, a line each; or one command explained, or that there is none of that name.
std::vector<std::string> help_on(std::string_view topic);

}  // namespace breakshot::client
