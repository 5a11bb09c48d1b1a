#include "common/physics/rails.hpp"

#include <array>
#include <cmath>

#include "common/physics/angle.hpp"

namespace breakshot::physics {
namespace {

constexpr std::size_t pockets = 6;

/// The angle of a facing, as the cosine and sine of its turn away from the cushion.
struct Turn {
  double cosine;
  double sine;
};

Turn turn_of(double cut_rad) {
  const Vec2 cut = direction_of(cut_rad);
  return {-cut.x, cut.y};
}

Vec2 turned_left(Vec2 d, Turn turn) {
  return d * turn.cosine + perp(d) * turn.sine;
}
Vec2 turned_right(Vec2 d, Turn turn) {
  return d * turn.cosine - perp(d) * turn.sine;
}

/// How one pocket's jaws and hole are shaped.
struct JawShape {
  Turn turn;
  double shelf_m;
  double nose_m;
  double hole_m;

  /// From the point of the nose, where cushion and facing would meet, to where each leaves the arc.
  double trim_m() const { return nose_m * turn.sine / (1 + turn.cosine); }
};

/// The shapes of all pockets' jaws.
std::array<JawShape, pockets> shapes_of(const JawedPockets& jaws) {
  const JawShape corner{turn_of(jaws.corner_cut_rad), jaws.corner_shelf_m, jaws.corner_nose_m,
                        jaws.corner_hole_m};
  const JawShape side{turn_of(jaws.side_cut_rad), jaws.side_shelf_m, jaws.side_nose_m,
                      jaws.side_hole_m};
  return {corner, side, corner, corner, side, corner};
}

CushionId jaw_id(std::size_t pocket, std::size_t side) {
  return CushionId(static_cast<std::uint32_t>(4 + 2 * pocket + side));
}

/// One jaw at the end of a cushion: the facing from `tip` into the pocket and the nose between.
/// `along` points to the pocket on the cushion before it and away from it on the one after it.
struct Jaw {
  Vec2 tip;
  Vec2 along;
  CushionId id;
  CushionModel model;
};

/// A facing reaches as far as the centre of the hole, where every ball has dropped.
double facing_m(const JawShape& shape, Vec2 facing, Vec2 outward) {
  return (shape.shelf_m + shape.hole_m) / dot(facing, outward);
}

void add_jaw_after_cushion(Rails& rails, const Jaw& jaw, const JawShape& shape, Vec2 outward) {
  const Vec2 facing = turned_right(jaw.along, shape.turn);
  const double trim = shape.trim_m();
  const Vec2 start = jaw.tip + facing * trim;
  rails.segments.push_back(
      {jaw.id, {start, jaw.tip + facing * facing_m(shape, facing, outward), jaw.model}});
  rails.arcs.push_back({jaw.id,
                        {start - perp(facing) * shape.nose_m, shape.nose_m, perp(facing),
                         perp(jaw.along), jaw.model}});
}

void add_jaw_before_cushion(Rails& rails, const Jaw& jaw, const JawShape& shape, Vec2 outward) {
  const Vec2 facing = turned_left(-jaw.along, shape.turn);
  const double trim = shape.trim_m();
  const Vec2 end = jaw.tip + facing * trim;
  rails.segments.push_back(
      {jaw.id, {jaw.tip + facing * facing_m(shape, facing, outward), end, jaw.model}});
  rails.arcs.push_back({jaw.id,
                        {end - perp(-facing) * shape.nose_m, shape.nose_m, perp(jaw.along),
                         perp(-facing), jaw.model}});
}

/// The cushion between two pockets, counter-clockwise: 0 foot, 1 left, 2 head, 3 right.
struct Side {
  std::uint32_t cushion;
  std::size_t from;
  std::size_t to;
  Vec2 along;
};

constexpr std::array<Side, 6> sides{{{0, 2, 3, {0, 1}},
                                     {1, 3, 4, {-1, 0}},
                                     {1, 4, 5, {-1, 0}},
                                     {2, 5, 0, {0, -1}},
                                     {3, 0, 1, {1, 0}},
                                     {3, 1, 2, {1, 0}}}};

Rails jawed(const Scene& scene, const JawedPockets& jaws, const CushionModel& model) {
  Rails rails;
  rails.segments.reserve(3 * sides.size());
  rails.arcs.reserve(2 * sides.size());
  rails.holes.reserve(pockets);
  const std::array<JawShape, pockets> shapes = shapes_of(jaws);
  std::array<Mouth, pockets> mouths;
  for (std::size_t p = 0; p < pockets; ++p) {
    mouths[p] = mouth_of(scene.bed, PocketId(static_cast<std::uint8_t>(p)), jaws.corner_mouth_m,
                         jaws.side_mouth_m);
  }
  for (const Side& side : sides) {
    const Vec2 from = mouths[side.from].second + side.along * shapes[side.from].trim_m();
    const Vec2 to = mouths[side.to].first - side.along * shapes[side.to].trim_m();
    rails.segments.push_back({CushionId(side.cushion), {from, to, model}});
  }
  for (const Side& side : sides) {
    const Mouth& before = mouths[side.from];
    const Mouth& after = mouths[side.to];
    add_jaw_before_cushion(rails, {before.second, side.along, jaw_id(side.from, 1), model},
                           shapes[side.from], before.outward);
    add_jaw_after_cushion(rails, {after.first, side.along, jaw_id(side.to, 0), model},
                          shapes[side.to], after.outward);
  }
  for (std::size_t p = 0; p < pockets; ++p) {
    const JawShape& shape = shapes[p];
    const Vec2 middle = (mouths[p].first + mouths[p].second) * 0.5;
    rails.holes.push_back({PocketId(static_cast<std::uint8_t>(p)),
                           middle + mouths[p].outward * (shape.shelf_m + shape.hole_m),
                           shape.hole_m});
  }
  return rails;
}

}  // namespace

Mouth mouth_of(const Bed& bed, PocketId pocket, double corner_mouth_m, double side_mouth_m) {
  const double x = bed.length_m.value() / 2;
  const double y = bed.width_m.value() / 2;
  const double side = side_mouth_m / 2;
  const double half = 1 / std::sqrt(2.0);
  const double corner = corner_mouth_m * half;
  switch (number(pocket)) {
    case 0:
      return {{-x, -y + corner}, {-x + corner, -y}, {-half, -half}};
    case 1:
      return {{-side, -y}, {side, -y}, {0, -1}};
    case 2:
      return {{x - corner, -y}, {x, -y + corner}, {half, -half}};
    case 3:
      return {{x, y - corner}, {x - corner, y}, {half, half}};
    case 4:
      return {{side, y}, {-side, y}, {0, 1}};
    default:
      return {{-x + corner, y}, {-x, y - corner}, {-half, half}};
  }
}

Rails rails_of(const Scene& scene) {
  Rails rails;
  if (!scene.cushions) return rails;
  if (const auto* free = std::get_if<FreeCushions>(&*scene.cushions)) {
    std::uint32_t id = 0;
    for (const CushionSegment& nose : free->segments)
      rails.segments.push_back({CushionId(id++), nose});
    for (const CushionArc& nose : free->arcs) rails.arcs.push_back({CushionId(id++), nose});
    return rails;
  }
  const CushionModel& model = std::get<RectangleCushions>(*scene.cushions).model;
  const double x = scene.bed.length_m.value() / 2;
  const double y = scene.bed.width_m.value() / 2;
  const auto* jaws = scene.pockets ? std::get_if<JawedPockets>(&*scene.pockets) : nullptr;
  if (jaws != nullptr) {
    rails = jawed(scene, *jaws, model);
  } else {
    rails.segments = {{CushionId{0}, {{x, -y}, {x, y}, model}},
                      {CushionId{1}, {{x, y}, {-x, y}, model}},
                      {CushionId{2}, {{-x, y}, {-x, -y}, model}},
                      {CushionId{3}, {{-x, -y}, {x, -y}, model}}};
  }
  rails.inside = {x, y};
  return rails;
}

}  // namespace breakshot::physics
