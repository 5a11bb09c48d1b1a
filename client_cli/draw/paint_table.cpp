#include <algorithm>
#include <cmath>

#include "client_cli/draw/paint.hpp"

namespace breakshot::client {
namespace {

using physics::Vec2;

/// Tangents of how far a cushion's end is cut away from its pocket, of the WPA's angles of 142
/// degrees at the corners and 104 degrees at the sides.
constexpr double corner_cut = 0.78;
constexpr double side_cut = 0.25;

/// A rail in the coordinates of its own nose: along the nose, and outwards from it.
struct Rail {
  Vec2 origin;
  Vec2 along;
  Vec2 outward;

  Vec2 at(double along_m, double outward_m) const {
    return origin + along * along_m + outward * outward_m;
  }
};

struct Span {
  double from = 0;
  double to = 0;
  double cut_from = 0;
  double cut_to = 0;
};

void paint_cushion(Canvas& canvas, const Rail& rail, const Span& span, double width_m) {
  canvas.polygon({rail.at(span.from, 0), rail.at(span.to, 0),
                  rail.at(span.to + span.cut_to * width_m, width_m),
                  rail.at(span.from - span.cut_from * width_m, width_m)});
  canvas.fill_linear(rail.at(0, 0), rail.at(0, width_m),
                     {{0, palette::nose},
                      {0.22, palette::cushion},
                      {1, mixed(palette::cushion, palette::ink, 0.3)}});
}

/// The straight parts of a rail of half-length `half_m`, between its pockets if it has any.
std::vector<Span> spans_of(const Table& table, double half_m, bool has_side) {
  // Without pockets the cushions are mitred at the corners.
  if (table.pockets.empty()) return {{-half_m, half_m, 1, 1}};
  const double corner = std::abs(table.pockets[0].mouth_from.x - table.bed.low.x);
  const double end = half_m - corner;
  if (!has_side) return {{-end, end, corner_cut, corner_cut}};
  const double side = table.pockets[1].mouth_to.x;
  return {{-end, -side, corner_cut, side_cut}, {side, end, side_cut, corner_cut}};
}

std::vector<Rail> rails_of(const Box& bed) {
  const Vec2 centre = (bed.low + bed.high) / 2.0;
  return {{{centre.x, bed.low.y}, {1, 0}, {0, -1}},
          {{centre.x, bed.high.y}, {1, 0}, {0, 1}},
          {{bed.low.x, centre.y}, {0, 1}, {-1, 0}},
          {{bed.high.x, centre.y}, {0, 1}, {1, 0}}};
}

void paint_cushions(Canvas& canvas, const Table& table) {
  const double width = cushion_width(table);
  for (const Rail& rail : rails_of(table.bed)) {
    const bool is_long = rail.along.x != 0;
    const double half = (is_long ? table.bed.width() : table.bed.height()) / 2;
    for (const Span& span : spans_of(table, half, is_long)) {
      paint_cushion(canvas, rail, span, width);
    }
  }
}

/// A rail's wood: mitred, with the light falling across it.
void paint_wood(Canvas& canvas, const Table& table) {
  const Box frame = frame_of(table);
  const double wood = wood_width(table);
  canvas.save();
  canvas.rounded(frame, 0.9 * wood);
  canvas.clip();
  canvas.rectangle(frame);
  canvas.fill(palette::wood);
  for (const Rail& rail : rails_of(frame)) {
    const bool is_long = rail.along.x != 0;
    const double half = (is_long ? frame.width() : frame.height()) / 2;
    canvas.polygon({rail.at(-half, 0), rail.at(half, 0), rail.at(half - wood, -wood),
                    rail.at(-half + wood, -wood)});
    canvas.fill_linear(rail.at(0, 0), rail.at(0, -wood),
                       {{0, palette::wood_dark},
                        {0.18, palette::wood},
                        {0.5, palette::wood_light},
                        {0.85, palette::wood},
                        {1, palette::wood_dark}});
  }
  canvas.restore();
}

/// Fine darker lines along each rail. Their places are arithmetic: the same picture every time.
void paint_grain(Canvas& canvas, const Table& table) {
  const Box frame = frame_of(table);
  const double wood = wood_width(table);
  canvas.save();
  canvas.rounded(frame, 0.9 * wood);
  canvas.clip();
  for (const Rail& rail : rails_of(frame)) {
    const bool is_long = rail.along.x != 0;
    const double half = (is_long ? frame.width() : frame.height()) / 2;
    for (int line = 1; line < 9; ++line) {
      const double depth = wood * (line + 0.3 * std::sin(7.0 * line)) / 9;
      const double waviness = 0.012 * wood * (1 + line % 3);
      std::vector<Vec2> points;
      for (int i = 0; i <= 48; ++i) {
        const double s = -1 + i / 24.0;
        points.push_back(
            rail.at(s * (half - depth), -depth + waviness * std::sin(9 * s + 2.1 * line)));
      }
      canvas.polyline(points);
      canvas.stroke(line % 2 == 0 ? palette::wood_dark : palette::wood_light, 0.006 * wood,
                    line % 2 == 0 ? 0.35 : 0.25);
    }
  }
  canvas.restore();
}

void paint_diamond(Canvas& canvas, Vec2 centre, double size_m) {
  canvas.polygon({centre + Vec2{size_m, 0}, centre + Vec2{0, size_m}, centre - Vec2{size_m, 0},
                  centre - Vec2{0, size_m}});
  canvas.fill(palette::pearl);
}

/// The sights at the eighths of the long rails and the quarters of the short ones.
void paint_diamonds(Canvas& canvas, const Table& table) {
  const double out = cushion_width(table) + 0.48 * wood_width(table);
  const double size = 0.3 * table.ball_radius_m;
  for (const Rail& rail : rails_of(table.bed)) {
    const bool is_long = rail.along.x != 0;
    const double length = is_long ? table.bed.width() : table.bed.height();
    const int parts = is_long ? 8 : 4;
    for (int i = 1; i < parts; ++i) {
      const bool at_side_pocket = is_long && 2 * i == parts;
      if (at_side_pocket && !table.pockets.empty()) continue;
      paint_diamond(canvas, rail.at(length * (double(i) / parts - 0.5), out), size);
    }
  }
}

void paint_cloth(Canvas& canvas, const Table& table) {
  const Vec2 centre = (table.bed.low + table.bed.high) / 2.0;
  Box cloth = table.bed;
  // The cloth goes on under the cushions and into the pockets' mouths.
  const Vec2 under{cushion_width(table), cushion_width(table)};
  cloth = {cloth.low - under, cloth.high + under};
  canvas.rectangle(cloth);
  if (!canvas.full()) {
    canvas.fill(palette::cloth);
    return;
  }
  canvas.fill_radial(centre, 0.62 * table.bed.width(),
                     {{0, mixed(palette::cloth, palette::chalk, 0.07)},
                      {0.55, palette::cloth},
                      {1, palette::cloth_edge}});
}

void paint_pockets(Canvas& canvas, const Table& table) {
  for (const DrawnPocket& pocket : table.pockets) {
    if (canvas.full()) {
      canvas.circle(pocket.centre, 1.16 * pocket.radius_m);
      canvas.fill(palette::leather);
    }
    canvas.circle(pocket.centre, pocket.radius_m);
    if (!canvas.full()) {
      canvas.fill(palette::hole);
      continue;
    }
    canvas.fill_radial(pocket.centre, pocket.radius_m,
                       {{0, palette::hole}, {0.82, palette::hole}, {1, palette::leather}});
  }
}

void paint_spots(Canvas& canvas, const Table& table) {
  if (table.head_string_x_m) {
    const double x = *table.head_string_x_m;
    canvas.polyline({{x, table.bed.low.y}, {x, table.bed.high.y}});
    canvas.stroke(palette::chalk, 0.06 * table.ball_radius_m, canvas.full() ? 0.35 : 0.18);
  }
  if (!canvas.full()) return;
  for (const auto& spot : {table.head_spot, table.foot_spot}) {
    if (!spot) continue;
    canvas.circle(*spot, 0.2 * table.ball_radius_m);
    canvas.fill(palette::chalk, 0.75);
  }
}

void paint_free_cushions(Canvas& canvas, const Table& table) {
  for (const auto& cushion : table.cushions) {
    canvas.polyline({cushion.from, cushion.to});
    canvas.stroke(palette::wood_light, 0.25 * table.ball_radius_m);
  }
}

}  // namespace

void paint_table(Canvas& canvas, const Table& table) {
  if (!table.has_rails) {
    paint_cloth(canvas, table);
    paint_free_cushions(canvas, table);
    return;
  }
  paint_wood(canvas, table);
  if (canvas.full()) {
    paint_grain(canvas, table);
    paint_diamonds(canvas, table);
  }
  paint_cloth(canvas, table);
  paint_pockets(canvas, table);
  paint_cushions(canvas, table);
  paint_spots(canvas, table);
}

}  // namespace breakshot::client
