// The parts of a picture, from the floor up.
#pragma once

#include "client_cli/draw/canvas.hpp"
#include "client_cli/draw/picture.hpp"

namespace breakshot::client {

/// Rails, cloth, pockets and spots.
void paint_table(Canvas& canvas, const Table& table);

/// The ways of the balls, under them.
void paint_paths(Canvas& canvas, const Picture& picture);

/// The balls, each with its shadow.
void paint_balls(Canvas& canvas, const Picture& picture);

/// One ball of radius `radius_m`, without a shadow.
void paint_ball(Canvas& canvas, physics::BallId ball, physics::Vec2 centre, double radius_m);

/// The cue's red vector and the blue vectors of velocity, above everything.
void paint_vectors(Canvas& canvas, const Picture& picture);

}  // namespace breakshot::client
