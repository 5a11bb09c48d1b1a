// A shot as far as it has been prepared, and what can be said about it before it is played.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client_cli/draw/picture.hpp"
#include "common/match/match.hpp"

namespace breakshot::client {

struct Stance {
  std::optional<physics::Vec2> direction;  ///< unit; missing: not aimed yet
  double speed_m_s = 2.5;
  physics::Tip tip{};
  rules::Call call;
};

/// The table at which the shot is prepared. Refers to values that must outlive it.
struct Moment {
  match::GameKind kind;
  const physics::Scene& scene;
  const physics::State& table;
  const rules::GameStatus& game;
};

/// Whether a shot needs a ball and a pocket, or a safety, to be called now.
bool asks_for_call(const Moment& moment);

// Each changes the stance, or says why it cannot and leaves it as it was.

std::optional<std::string> aim_along(Stance& stance, double degrees);
std::optional<std::string> turn_by(Stance& stance, double degrees);
/// At a ball, full, or so that it goes towards the middle of a pocket, which is also called where
/// a call is asked for.
std::optional<std::string> aim_at(Stance& stance, const Moment& moment, physics::BallId ball,
                                  std::optional<physics::PocketId> pocket);
std::optional<std::string> set_speed(Stance& stance, double speed_m_s);
std::optional<std::string> set_tip(Stance& stance, const Moment& moment, const physics::Tip& tip);
std::optional<std::string> set_call(Stance& stance, const Moment& moment, const rules::Call& call);

/// What is missing before the shot can be played, and how to say it; nothing if it is ready.
std::optional<std::string> missing(const Stance& stance, const Moment& moment);

/// Aim, speed, tip, what is met first and what has been called, a sentence or two a line.
std::vector<std::string> preview(const Stance& stance, const Moment& moment);

/// Adds the cue vector and the lines of aim to a picture of the table: that of the cue ball to the
/// first thing it meets, and, if that is a ball, that ball's to the next thing.
void draw_aim(const Stance& stance, const Moment& moment, Picture& picture);

/// The angle of a direction, degrees in (-180, 180].
double degrees_of(physics::Vec2 direction);

}  // namespace breakshot::client
