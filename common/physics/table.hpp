// Tables as data: the scenes that have a name, and the spots of a table.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "common/physics/scene.hpp"

namespace breakshot::physics {

/// The paper's table: 8 ft, 92 x 46 in between the noses, m.
inline constexpr double eight_foot_length_m = 2.3368;
inline constexpr double eight_foot_width_m = 1.1684;
/// Ball sets: the WPA's, in the weight of the paper; UMB's carom balls; WPBSA's snooker balls.
inline constexpr BallKind pool_ball{0.028575, 0.155922};
inline constexpr BallKind carom_ball{0.03075, 0.21};
inline constexpr BallKind snooker_ball{0.02625, 0.142};

/// The paper's racks leave 1/10 in between balls, m.
inline constexpr double rack_gap_m = 0.00254;

/// Head spot: a quarter of the length from the head end, centred. +x runs from head to foot.
Vec2 head_spot(const Bed& bed);
/// Foot spot, where the apex ball of a rack stands.
Vec2 foot_spot(const Bed& bed);
/// Balls with x less than this are behind the head string, m.
double head_string_x(const Bed& bed);

/// The 15 places of a triangle rack, row by row from the apex on the foot spot, each row from -y to
/// +y; neighbours are `gap_m` apart.
std::array<Vec2, 15> triangle_rack(const Bed& bed, const BallKind& ball, double gap_m);

/// The centre of each standard pocket's mouth, by PocketId: what one aims at, m.
std::array<Vec2, 6> pocket_targets(const Bed& bed);

/// A scene that has a name: what clients ask for, since they do not send scenes.
struct Preset {
  std::string_view name;
  std::string_view summary;
  Scene scene;
};

/// Tables of all games, each with everything that is modelled: their data, whether a game for them
/// is offered or not.
const std::vector<Preset>& tables();

/// The tables that 8-ball is offered on; the first is the default.
const std::vector<Preset>& presets();

}  // namespace breakshot::physics
