// Random records and their pieces.
#include <variant>

#include "common/physics/table.hpp"
#include "tests/wire/samples.hpp"

namespace breakshot::wire::samples {

using physics::BallId;

namespace {

physics::Vec2 random_vec2(Chance& chance) {
  return {chance.real(), chance.real()};
}
physics::Vec3 random_vec3(Chance& chance) {
  return {chance.real(), chance.real(), chance.real()};
}
BallId random_ball(Chance& chance) {
  return BallId{chance.u32() >> chance.below(32)};
}
physics::PocketId random_pocket(Chance& chance) {
  return physics::PocketId{static_cast<std::uint8_t>(chance.below(6))};
}

physics::CushionModel random_cushion_model(Chance& chance) {
  const auto share = [&] { return chance.between(0, 1); };
  const auto height_m = [&] { return chance.between(0.03, 0.04); };
  switch (chance.below(5)) {
    case 0:
      return physics::Mirror{};
    case 1:
      return physics::CushionRestitution{share(), share(), share()};
    case 2:
      return physics::Han2005{share(), share(), height_m()};
    case 3:
      return physics::Mathavan2010{share(), share(), height_m()};
    default:
      return physics::Stronge2000{share(), share(), height_m(), chance.between(1, 10)};
  }
}

physics::BallBallModel random_ball_ball(Chance& chance) {
  const auto share = [&] { return chance.between(0, 1); };
  switch (chance.below(4)) {
    case 0:
      return physics::Elastic{};
    case 1:
      return physics::BallRestitution{share(), share()};
    case 2:
      return physics::BallFriction{share(), share(), share(), chance.between(0, 9), share()};
    default:
      return physics::Mathavan2014{share(), share(), share()};
  }
}

/// Within the ranges of their defaults, so that the scene stays free of faults.
physics::Pockets random_pockets(Chance& chance) {
  if (chance.coin()) {
    return physics::StandardPockets{chance.between(0.1, 0.2), chance.between(0.1, 1)};
  }
  physics::JawedPockets jaws;
  for (double* number :
       {&jaws.corner_mouth_m, &jaws.side_mouth_m, &jaws.corner_cut_rad, &jaws.side_cut_rad,
        &jaws.corner_shelf_m, &jaws.side_shelf_m, &jaws.corner_nose_m, &jaws.side_nose_m,
        &jaws.corner_hole_m, &jaws.side_hole_m}) {
    *number *= chance.between(0.99, 1.01);
  }
  return jaws;
}

/// A scene without faults that is not one of the presets.
physics::Scene random_scene(Chance& chance) {
  physics::Scene scene;
  scene.bed.length_m = chance.between(2, 4);
  scene.bed.width_m = chance.between(1, 2);
  scene.ball = {chance.between(0.02, 0.03), chance.between(0.1, 0.2)};
  scene.gravity_m_s2 = chance.between(1, 20);
  switch (chance.below(3)) {
    case 0:
      break;
    case 1:
      scene.bed.motion =
          physics::Straight{chance.between(0, 1), chance.between(0, 1), chance.between(0, 2)};
      break;
    default:
      scene.bed.motion =
          physics::Spinning{chance.between(0, 1), chance.between(0, 1), chance.between(0, 1)};
  }
  switch (chance.below(3)) {
    case 0:
      break;
    case 1:
      scene.cushions = physics::RectangleCushions{random_cushion_model(chance)};
      if (chance.coin()) scene.pockets = random_pockets(chance);
      break;
    default:
      scene.cushions = physics::FreeCushions{chance.some(5, [](Chance& c) {
        const physics::Vec2 from{c.between(-9, 9), c.between(-9, 9)};
        const physics::Vec2 to = from + physics::Vec2{c.between(1, 2), c.between(1, 2)};
        return physics::CushionSegment{from, to, random_cushion_model(c)};
      })};
  }
  scene.ball_ball = random_ball_ball(chance);
  if (chance.coin()) {
    scene.perturbation = physics::Perturbation{chance.between(0, 1), chance.between(0, 1)};
  }
  return scene;
}

physics::Ball random_ball_at(Chance& chance) {
  return {random_ball(chance), random_vec2(chance), random_vec2(chance), random_vec3(chance)};
}

physics::Event random_event(Chance& chance, double t) {
  const BallId ball{static_cast<std::uint32_t>(chance.below(16))};
  const std::uint32_t pass = chance.u32() >> chance.below(32);
  switch (chance.below(7)) {
    case 0:
      return physics::Struck{t, ball};
    case 1: {
      const auto higher = BallId{number(ball) + 1};
      return number(ball) == 15 ? physics::BallBall{t, pass, BallId{3}, ball}
                                : physics::BallBall{t, pass, ball, higher};
    }
    case 2:
      return physics::BallCushion{t, pass, ball, physics::CushionId{chance.u32()}};
    case 3:
      return physics::BallPocket{t, pass, ball, random_pocket(chance)};
    case 4:
      return physics::Rolls{t, ball};
    case 5:
      return physics::Spins{t, ball};
    default:
      return physics::Rests{t, ball};
  }
}

rules::Ruling random_ruling(Chance& chance) {
  rules::Ruling ruling;
  ruling.fouls = chance.some(5, [](Chance& c) { return c.one_of<rules::Foul>(5); });
  ruling.pocketed = chance.some(5, random_ball);
  ruling.spotted = chance.some(5, random_ball);
  ruling.group_won = chance.maybe([](Chance& c) { return c.one_of<rules::Group>(3); });
  ruling.rack_winner = chance.maybe(random_seat);
  ruling.rack_end = chance.maybe([](Chance& c) { return c.one_of<rules::RackEnd>(4); });
  ruling.illegal_break = chance.coin();
  return ruling;
}

match::Status random_status(Chance& chance) {
  match::Status status;
  status.stage = chance.one_of<match::Stage>(3);
  status.rack = chance.u32();
  status.score = chance.some(8, [](Chance& c) { return c.u32(); });
  status.game.turn = random_seat(chance);
  status.game.breaking = chance.coin();
  status.game.ball_in_hand = chance.one_of<rules::BallInHand>(3);
  status.game.options = chance.some(5, [](Chance& c) { return c.one_of<rules::Option>(6); });
  status.game.groups = chance.some(8, [](Chance& c) { return c.one_of<rules::Group>(3); });
  status.rerack_agreed = chance.some(8, [](Chance& c) { return c.coin(); });
  status.winner = chance.maybe(random_seat);
  status.end = random_end(chance);
  return status;
}

}  // namespace

physics::Shot random_shot(Chance& chance, std::size_t events) {
  physics::Shot shot;
  const auto segment = [&](std::uint32_t ball, double start) {
    shot.segments.push_back({BallId{ball}, chance.one_of<physics::Phase>(5), start,
                             random_vec2(chance), random_vec2(chance), random_vec2(chance),
                             chance.coin() ? random_vec3(chance) : physics::Vec3{},
                             chance.coin() ? random_vec3(chance) : physics::Vec3{}});
  };
  for (std::uint32_t ball = 0; ball < 16; ++ball) segment(ball, 0);
  double t = 0;
  for (std::size_t i = 0; i < events; ++i) {
    if (chance.coin()) t += chance.between(0, 1);
    shot.events.push_back(random_event(chance, t));
    const auto [first, second] = physics::balls_of(shot.events.back());
    segment(number(first), t);
    if (second) segment(number(*second), t);
  }
  shot.end_s = t + (chance.coin() ? chance.between(0, 1) : 0);
  shot.stop = chance.one_of<physics::Stop>(2);
  return shot;
}

match::Settings random_settings(Chance& chance) {
  match::Settings settings;
  const physics::Preset& preset = physics::presets()[chance.below(physics::presets().size())];
  settings.preset = preset.name;
  settings.scene = preset.scene;
  settings.race_to = static_cast<std::uint32_t>(1 + chance.below(match::max_race_to));
  if (chance.coin()) return settings;
  settings.game = match::GameKind::practice;
  settings.seats = static_cast<std::uint8_t>(1 + chance.below(match::max_practice_seats));
  settings.race_to = 1;
  const physics::Scene scene = random_scene(chance);
  if (match::Settings other = settings; other.scene = scene, match::faults_of(other).empty()) {
    settings = other;
  }
  return settings;
}

record::Header random_header(Chance& chance) {
  record::Header header;
  header.format = chance.u32();
  header.physics = chance.u32();
  header.id = match::MatchId{chance.bits()};
  header.created_unix_ms = static_cast<std::int64_t>(chance.bits());
  header.settings = random_settings(chance);
  header.players = chance.some(8, [](Chance& c) {
    return record::Player{random_name(c), c.bytes32()};
  });
  header.commitment = chance.bytes32();
  return header;
}

record::Entry random_entry(Chance& chance) {
  record::Entry entry;
  entry.seq = random_seq(chance);
  entry.author.seat = chance.maybe(random_seat);
  entry.id = match::CommandId{chance.bits()};
  entry.command = random_command(chance, chance.below(command_kinds));
  if (chance.coin()) entry.outcome.shot = random_shot(chance, chance.below(50));
  entry.outcome.ruling = chance.maybe(random_ruling);
  entry.outcome.table.balls = chance.some(16, random_ball_at);
  entry.outcome.status = random_status(chance);
  entry.secret = chance.maybe([](Chance& c) { return c.bytes32(); });
  entry.digest = chance.bytes32();
  return entry;
}

match::Command random_command(Chance& chance, std::size_t index) {
  switch (index) {
    case 0:
      return match::Start{};
    case 1:
      return match::Place{random_ball(chance), random_vec2(chance)};
    case 2:
      return match::Shoot{random_vec2(chance),
                          chance.real(),
                          {chance.maybe(random_ball), chance.maybe(random_pocket), chance.coin()},
                          {chance.coin() ? chance.real() : 0, chance.coin() ? chance.real() : 0}};
    case 3:
      return match::Choose{chance.one_of<rules::Option>(6)};
    case 4:
      return match::Concede{};
    case 5:
      return match::AgreeRerack{};
    default:
      return match::Abandoned{random_seat(chance)};
  }
}

match::Seq random_seq(Chance& chance) {
  return match::Seq{chance.u32() >> chance.below(32)};
}

rules::Seat random_seat(Chance& chance) {
  return rules::Seat{static_cast<std::uint8_t>(chance.below(8))};
}

std::optional<match::MatchEnd> random_end(Chance& chance) {
  return chance.maybe([](Chance& c) { return c.one_of<match::MatchEnd>(3); });
}

std::string random_name(Chance& chance) {
  static constexpr std::array<const char*, 8> characters = {"a", "Z",  "7", "'",
                                                            "ø", "張", "😀", "-"};
  std::string name;
  for (std::size_t n = 1 + chance.below(32); n > 0; --n) {
    name += characters[chance.below(characters.size())];
  }
  return name;
}

}  // namespace breakshot::wire::samples
