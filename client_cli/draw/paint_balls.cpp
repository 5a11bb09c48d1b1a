#include <algorithm>
#include <array>
#include <cmath>

#include "client_cli/draw/paint.hpp"

namespace breakshot::client {
namespace {

using physics::Vec2;

/// The light comes from the upper left, so that shadows fall to the lower right, in radii.
constexpr Vec2 shadow_offset{0.16, -0.2};
constexpr Vec2 light_offset{-0.34, 0.38};

void paint_shadow(Canvas& canvas, const DrawnBall& ball, double radius_m) {
  const Vec2 centre = ball.position + shadow_offset * radius_m;
  canvas.circle(centre, 1.25 * radius_m);
  canvas.fill_radial(centre, 1.25 * radius_m,
                     {{0, palette::ink, 0.55}, {0.72, palette::ink, 0.45}, {1, palette::ink, 0}});
}

/// The painted surface, before any light falls on it. One fill, since two on the same edge would
/// show a fringe.
void paint_colours(Canvas& canvas, physics::BallId ball, Vec2 centre, double radius_m) {
  const Rgb colour = colour_of(ball);
  canvas.circle(centre, radius_m);
  if (!is_striped(ball)) {
    canvas.fill(colour);
    return;
  }
  constexpr double low = 0.22;
  constexpr double high = 1 - low;
  constexpr double soft = 0.008;
  canvas.fill_linear(centre - Vec2{0, radius_m}, centre + Vec2{0, radius_m},
                     {{low - soft, palette::ivory},
                      {low + soft, colour},
                      {high - soft, colour},
                      {high + soft, palette::ivory}});
}

void paint_number(Canvas& canvas, physics::BallId ball, Vec2 centre, double radius_m) {
  if (number(ball) == 0) return;
  canvas.circle(centre, 0.5 * radius_m);
  canvas.fill(palette::ivory);
  const std::string digits = std::to_string(number(ball));
  canvas.text(digits, centre, (digits.size() == 1 ? 0.74 : 0.6) * radius_m, palette::ink);
}

/// Shade towards the edge and a highlight where the lamp is.
void paint_light(Canvas& canvas, Vec2 centre, double radius_m) {
  canvas.save();
  canvas.circle(centre, radius_m);
  canvas.clip();
  const Vec2 lit = centre + light_offset * (0.6 * radius_m);
  canvas.circle(centre, radius_m);
  canvas.fill_radial(lit, 1.5 * radius_m,
                     {{0, palette::ink, 0}, {0.5, palette::ink, 0.06}, {1, palette::ink, 0.62}});
  const Vec2 lamp = centre + light_offset * radius_m;
  canvas.circle(lamp, 0.42 * radius_m);
  canvas.fill_radial(
      lamp, 0.42 * radius_m,
      {{0, {255, 255, 255}, 0.9}, {0.3, {255, 255, 255}, 0.55}, {1, {255, 255, 255}, 0}});
  canvas.restore();
}

/// At a few pixels a ball, a stripe is a ring of colour round white, which survives blurring.
void paint_coarse(Canvas& canvas, physics::BallId ball, Vec2 centre, double radius_m) {
  canvas.circle(centre, radius_m);
  canvas.fill(colour_of(ball));
  if (!is_striped(ball)) return;
  canvas.circle(centre, 0.55 * radius_m);
  canvas.fill(palette::ivory);
}

/// An arrow as long as `along` that starts at the edge of a ball, so that its number stays
/// readable.
void paint_arrow(Canvas& canvas, Vec2 ball, double radius_m, Vec2 along, double width_m,
                 Rgb colour) {
  const double reach = physics::length(along);
  if (!(reach > 0)) return;
  const Vec2 direction = along / reach;
  const Vec2 from = ball + direction * radius_m;
  const Vec2 side = physics::perp(direction);
  const double head = std::min(5 * std::max(width_m, canvas.pixel_m()), 0.5 * reach);
  const Vec2 tip = from + along;
  const Vec2 neck = tip - direction * head;
  const std::vector<Vec2> triangle = {tip, neck + side * (0.45 * head),
                                      neck - side * (0.45 * head)};
  if (canvas.full()) {
    // A dark edge keeps the vector apart from whatever it crosses.
    canvas.polyline({from, neck});
    canvas.stroke(palette::ink, 1.9 * width_m, 0.4);
    canvas.polygon(triangle);
    canvas.stroke(palette::ink, 0.9 * width_m, 0.4);
  }
  canvas.polyline({from, canvas.full() ? neck : tip});
  // A line of one pixel that falls between two would be seen at half its strength.
  canvas.stroke(colour, canvas.full() ? width_m : std::max(width_m, 1.7 * canvas.pixel_m()));
  if (!canvas.full()) return;
  canvas.polygon(triangle);
  canvas.fill(colour);
}

}  // namespace

void paint_ball(Canvas& canvas, physics::BallId ball, Vec2 centre, double radius_m) {
  if (!canvas.full()) {
    paint_coarse(canvas, ball, centre, radius_m);
    return;
  }
  paint_colours(canvas, ball, centre, radius_m);
  paint_number(canvas, ball, centre, radius_m);
  paint_light(canvas, centre, radius_m);
}

void paint_paths(Canvas& canvas, const Picture& picture) {
  const double radius = picture.table.ball_radius_m;
  for (const DrawnPath& path : picture.paths) {
    canvas.polyline(path.points);
    if (canvas.full()) {
      canvas.stroke(palette::ink, 0.34 * radius, 0.25);
      canvas.polyline(path.points);
    }
    const Rgb colour =
        mixed(colour_of(path.ball), palette::ivory, is_striped(path.ball) ? 0.55 : 0.35);
    canvas.stroke(colour, 0.2 * radius, 0.85);
    canvas.circle(path.points.front(), 0.3 * radius);
    canvas.stroke(colour, 0.1 * radius, 0.9);
  }
}

void paint_balls(Canvas& canvas, const Picture& picture) {
  const double radius = picture.table.ball_radius_m;
  if (canvas.full()) {
    for (const DrawnBall& ball : picture.balls) paint_shadow(canvas, ball, ball.scale * radius);
  }
  for (const DrawnBall& ball : picture.balls) {
    paint_ball(canvas, ball.id, ball.position, ball.scale * radius);
  }
}

void paint_vectors(Canvas& canvas, const Picture& picture) {
  const double radius = picture.table.ball_radius_m;
  const double width = 0.24 * radius;
  if (picture.velocities) {
    for (const DrawnBall& ball : picture.balls) {
      paint_arrow(canvas, ball.position, radius, ball.velocity * velocity_vector_s, width,
                  palette::velocity);
    }
  }
  if (!picture.cue) return;
  paint_arrow(canvas, picture.cue->from, radius,
              picture.cue->direction * (picture.cue->speed_m_s * cue_vector_s), 1.2 * width,
              palette::cue_vector);
}

}  // namespace breakshot::client
