#include "common/wire/matches.hpp"

#include <variant>

#include "common/wire/scene.hpp"
#include "common/wire/shots.hpp"

namespace breakshot::wire {
namespace {

using physics::BallId;

static_assert(v1::GameKind_MAX == static_cast<int>(match::GameKind::practice) + 1);
static_assert(v1::Option_MAX == static_cast<int>(rules::Option::spot_nearest_ball) + 1);
static_assert(v1::Foul_MAX == static_cast<int>(rules::Foul::behind_head_string) + 1);
static_assert(v1::Group_MAX == static_cast<int>(rules::Group::stripes) + 1);
static_assert(v1::RackEnd_MAX == static_cast<int>(rules::RackEnd::eight_wrong_pocket) + 1);
static_assert(v1::Stage_MAX == static_cast<int>(match::Stage::finished) + 1);
static_assert(v1::BallInHand_MAX == static_cast<int>(rules::BallInHand::anywhere) + 1);
static_assert(v1::MatchEnd_MAX == static_cast<int>(match::MatchEnd::abandoned) + 1);

// ---- Commands

struct CommandWriter {
  v1::Command& message;

  void operator()(const match::Start&) const { message.mutable_start(); }
  void operator()(const match::Place& place) const {
    v1::Place& said = *message.mutable_place();
    said.set_ball(number(place.ball));
    said.set_x(place.position.x);
    said.set_y(place.position.y);
  }
  void operator()(const match::Shoot& shoot) const {
    v1::Shoot& said = *message.mutable_shoot();
    said.set_direction_x(shoot.direction.x);
    said.set_direction_y(shoot.direction.y);
    said.set_speed_m_s(shoot.speed_m_s);
    if (!(shoot.tip == physics::Tip{})) {
      said.mutable_tip()->set_side(shoot.tip.side);
      said.mutable_tip()->set_height(shoot.tip.height);
    }
    if (shoot.call == rules::Call{}) return;
    v1::Call& call = *said.mutable_call();
    if (shoot.call.ball) call.set_ball(number(*shoot.call.ball));
    if (shoot.call.pocket) call.set_pocket(number(*shoot.call.pocket));
    call.set_safety(shoot.call.safety);
  }
  void operator()(const match::Choose& choose) const {
    message.mutable_choose()->set_option(enum_of<v1::Option>(choose.option));
  }
  void operator()(const match::Concede&) const { message.mutable_concede(); }
  void operator()(const match::AgreeRerack&) const { message.mutable_agree_rerack(); }
  void operator()(const match::Abandoned& abandoned) const {
    message.mutable_abandoned()->set_seat(number(abandoned.seat));
  }
};

match::Place read(const v1::Place& message, const Where& at) {
  return {BallId{message.ball()},
          {finite(message.x(), Where(at, "x")), finite(message.y(), Where(at, "y"))}};
}

rules::Call read(const v1::Call& message, const Where& at) {
  rules::Call call;
  if (message.has_ball()) call.ball = BallId{message.ball()};
  if (message.has_pocket()) call.pocket = pocket(message.pocket(), Where(at, "pocket"));
  call.safety = message.safety();
  return call;
}

physics::Tip read(const v1::Tip& message, const Where& at) {
  return {finite(message.side(), Where(at, "side")), finite(message.height(), Where(at, "height"))};
}

match::Shoot read(const v1::Shoot& message, const Where& at) {
  return {{finite(message.direction_x(), Where(at, "direction_x")),
           finite(message.direction_y(), Where(at, "direction_y"))},
          finite(message.speed_m_s(), Where(at, "speed_m_s")),
          read(message.call(), Where(at, "call")),
          read(message.tip(), Where(at, "tip"))};
}

rules::Option read_option(int value, const Where& at) {
  return enumerated<rules::Option>(value, v1::Option_MAX, at);
}

// ---- Rulings

void write(const rules::Ruling& ruling, v1::Ruling& message) {
  for (const rules::Foul foul : ruling.fouls) message.add_fouls(enum_of<v1::Foul>(foul));
  for (const BallId ball : ruling.pocketed) message.add_pocketed(number(ball));
  for (const BallId ball : ruling.spotted) message.add_spotted(number(ball));
  if (ruling.group_won) message.set_group_won(enum_of<v1::Group>(*ruling.group_won));
  if (ruling.rack_winner) message.set_rack_winner(number(*ruling.rack_winner));
  if (ruling.rack_end) message.set_rack_end(enum_of<v1::RackEnd>(*ruling.rack_end));
  message.set_illegal_break(ruling.illegal_break);
}

rules::Ruling read(const v1::Ruling& message, const Where& at) {
  rules::Ruling ruling;
  for (int i = 0; i < message.fouls_size() && at.good(); ++i) {
    const Where here(at, "fouls", i);
    ruling.fouls.push_back(enumerated<rules::Foul>(message.fouls(i), v1::Foul_MAX, here));
  }
  for (const std::uint32_t ball : message.pocketed()) ruling.pocketed.push_back(BallId{ball});
  for (const std::uint32_t ball : message.spotted()) ruling.spotted.push_back(BallId{ball});
  if (message.group_won() != v1::GROUP_UNSPECIFIED) {
    const Where here(at, "group_won");
    ruling.group_won = enumerated<rules::Group>(message.group_won(), v1::Group_MAX, here);
  }
  if (message.has_rack_winner()) {
    ruling.rack_winner = seat(message.rack_winner(), Where(at, "rack_winner"));
  }
  if (message.rack_end() != v1::RACK_END_UNSPECIFIED) {
    const Where here(at, "rack_end");
    ruling.rack_end = enumerated<rules::RackEnd>(message.rack_end(), v1::RackEnd_MAX, here);
  }
  ruling.illegal_break = message.illegal_break();
  return ruling;
}

// ---- Status

void write(const rules::GameStatus& game, v1::GameStatus& message) {
  message.set_turn(number(game.turn));
  message.set_breaking(game.breaking);
  message.set_ball_in_hand(enum_of<v1::BallInHand>(game.ball_in_hand));
  for (const rules::Option o : game.options) message.add_options(enum_of<v1::Option>(o));
  for (const rules::Group g : game.groups) message.add_groups(enum_of<v1::Group>(g));
}

rules::GameStatus read(const v1::GameStatus& message, const Where& at) {
  rules::GameStatus game;
  game.turn = seat(message.turn(), Where(at, "turn"));
  game.breaking = message.breaking();
  game.ball_in_hand = enumerated<rules::BallInHand>(message.ball_in_hand(), v1::BallInHand_MAX,
                                                    Where(at, "ball_in_hand"));
  for (int i = 0; i < message.options_size() && at.good(); ++i) {
    game.options.push_back(read_option(message.options(i), Where(at, "options", i)));
  }
  check_per_seat(message.groups_size(), Where(at, "groups"));
  for (int i = 0; i < message.groups_size() && at.good(); ++i) {
    const Where here(at, "groups", i);
    game.groups.push_back(enumerated<rules::Group>(message.groups(i), v1::Group_MAX, here));
  }
  return game;
}

void write(const match::Status& status, v1::Status& message) {
  message.set_stage(enum_of<v1::Stage>(status.stage));
  message.set_rack(status.rack);
  for (const std::uint32_t racks : status.score) message.add_score(racks);
  write(status.game, *message.mutable_game());
  for (const bool agreed : status.rerack_agreed) message.add_rerack_agreed(agreed);
  if (status.winner) message.set_winner(number(*status.winner));
  if (status.end) message.set_end(enum_of<v1::MatchEnd>(*status.end));
}

match::Status read(const v1::Status& message, const Where& at) {
  match::Status status;
  status.stage = enumerated<match::Stage>(message.stage(), v1::Stage_MAX, Where(at, "stage"));
  status.rack = message.rack();
  check_per_seat(message.score_size(), Where(at, "score"));
  status.score.assign(message.score().begin(), message.score().end());
  status.game = read(message.game(), Where(at, "game"));
  check_per_seat(message.rerack_agreed_size(), Where(at, "rerack_agreed"));
  status.rerack_agreed.assign(message.rerack_agreed().begin(), message.rerack_agreed().end());
  if (message.has_winner()) status.winner = seat(message.winner(), Where(at, "winner"));
  status.end = match_end(message.end(), Where(at, "end"));
  return status;
}

}  // namespace

std::optional<match::MatchEnd> match_end(int value, const Where& at) {
  if (value == v1::MATCH_END_UNSPECIFIED) return std::nullopt;
  return enumerated<match::MatchEnd>(value, v1::MatchEnd_MAX, at);
}

void write(const match::Settings& settings, v1::Settings& message) {
  message.set_preset(settings.preset);
  write(settings.scene, *message.mutable_scene());
  message.set_game(enum_of<v1::GameKind>(settings.game));
  message.set_seats(settings.seats);
  message.set_race_to(settings.race_to);
}

match::Settings read(const v1::Settings& message, const Where& at) {
  match::Settings settings;
  settings.preset = preset(message.preset(), Where(at, "preset"));
  settings.scene = read(message.scene(), Where(at, "scene"));
  settings.game = enumerated<match::GameKind>(message.game(), v1::GameKind_MAX, Where(at, "game"));
  settings.seats = seat_count(message.seats(), Where(at, "seats"));
  settings.race_to = message.race_to();
  if (!at.good()) return settings;
  for (const physics::Fault& fault : match::faults_of(settings)) {
    Where(at, fault.field.c_str()).refuse(fault.what);
  }
  return settings;
}

void write(const match::Command& command, v1::Command& message) {
  std::visit(CommandWriter{message}, command);
}

match::Command read(const v1::Command& message, const Where& at) {
  using Kind = v1::Command::KindCase;
  switch (message.kind_case()) {
    case Kind::kStart:
      return match::Start{};
    case Kind::kPlace:
      return read(message.place(), Where(at, "place"));
    case Kind::kShoot:
      return read(message.shoot(), Where(at, "shoot"));
    case Kind::kChoose: {
      const Where here(at, "choose");
      return match::Choose{read_option(message.choose().option(), Where(here, "option"))};
    }
    case Kind::kConcede:
      return match::Concede{};
    case Kind::kAgreeRerack:
      return match::AgreeRerack{};
    case Kind::kAbandoned: {
      const Where here(at, "abandoned");
      return match::Abandoned{seat(message.abandoned().seat(), Where(here, "seat"))};
    }
    case Kind::KIND_NOT_SET:
      break;
  }
  at.refuse("has no kind, or one that this version does not know; exactly one must be given");
  return match::Concede{};
}

void write(const match::Outcome& outcome, v1::Outcome& message) {
  if (outcome.shot) write(*outcome.shot, *message.mutable_shot());
  if (outcome.ruling) write(*outcome.ruling, *message.mutable_ruling());
  write(outcome.table, *message.mutable_table());
  write(outcome.status, *message.mutable_status());
}

match::Outcome read(const v1::Outcome& message, const Where& at) {
  match::Outcome outcome;
  if (message.has_shot()) outcome.shot = read(message.shot(), Where(at, "shot"));
  if (message.has_ruling()) outcome.ruling = read(message.ruling(), Where(at, "ruling"));
  outcome.table = read(message.table(), Where(at, "table"));
  outcome.status = read(message.status(), Where(at, "status"));
  return outcome;
}

}  // namespace breakshot::wire
