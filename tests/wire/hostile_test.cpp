// What others wrote wrongly, by mistake or on purpose: each fault is named, and nothing gets
// through that the domain could not bear.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "breakshot/v1/session.pb.h"
#include "common/physics/timeline.hpp"
#include "common/wire/translate.hpp"
#include "tests/wire/samples.hpp"

namespace breakshot::wire {
namespace {

using samples::Chance;

hash::Bytes bytes_of(const std::string& text) {
  return hash::bytes_of(std::string_view(text));
}

std::string body_of(const ByteVector& frame) {
  return {frame.begin() + frame_header_bytes, frame.end()};
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- Requests

/// What makes a request of one kind wrong, and the field that must be named.
struct WrongRequest {
  std::size_t kind;
  std::string field;
  std::function<void(v1::ClientToServer&)> spoil;
};

std::vector<WrongRequest> wrong_requests() {
  const auto shoot = [](v1::ClientToServer& m) {
    return m.mutable_act()->mutable_command()->mutable_shoot();
  };
  return {
      {0, "request_id", [](auto& m) { m.set_request_id(0); }},
      {0, "request", [](auto& m) { m.clear_request(); }},
      {0, "hello.name", [](auto& m) { m.mutable_hello()->clear_name(); }},
      {0, "hello.name", [](auto& m) { m.mutable_hello()->set_name(std::string(33, 'x')); }},
      {0, "hello.name", [](auto& m) { m.mutable_hello()->set_name("\x1b[2J"); }},
      {0, "hello.token", [](auto& m) { m.mutable_hello()->set_token(std::string(31, 'x')); }},
      {0, "hello.token", [](auto& m) { m.mutable_hello()->set_token(std::string(33, 'x')); }},
      {1, "create.preset", [](auto& m) { m.mutable_create()->set_preset(std::string(65, 'x')); }},
      {1, "create.preset", [](auto& m) { m.mutable_create()->set_preset("a\nb"); }},
      {1, "create.game", [](auto& m) { m.mutable_create()->clear_game(); }},
      {1, "create.game",
       [](auto& m) { m.mutable_create()->set_game(static_cast<v1::GameKind>(99)); }},
      {1, "create.game",
       [](auto& m) { m.mutable_create()->set_game(static_cast<v1::GameKind>(-1)); }},
      {1, "create.seats", [](auto& m) { m.mutable_create()->set_seats(0); }},
      {1, "create.seats", [](auto& m) { m.mutable_create()->set_seats(258); }},
      {1, "create.key", [](auto& m) { m.mutable_create()->set_key(std::string(15, 'x')); }},
      {1, "create.key", [](auto& m) { m.mutable_create()->set_key(std::string(17, 'x')); }},
      {2, "join", [](auto& m) { m.mutable_join()->Clear(); }},
      {2, "join.code", [](auto& m) { m.mutable_join()->set_code("U123456789"); }},
      {3, "watch", [](auto& m) { m.mutable_watch()->Clear(); }},
      {3, "watch.code", [](auto& m) { m.mutable_watch()->set_code("0"); }},
      {4, "list.filter", [](auto& m) { m.mutable_list()->clear_filter(); }},
      {4, "list.filter", [](auto& m) { m.mutable_list()->set_filter(static_cast<v1::Filter>(5)); }},
      {5, "fetch", [](auto& m) { m.mutable_fetch()->Clear(); }},
      {6, "contribute.contribution", [](auto& m) { m.mutable_contribute()->clear_contribution(); }},
      {7, "act.id", [](auto& m) { m.mutable_act()->clear_id(); }},
      {7, "act.command", [](auto& m) { m.mutable_act()->clear_command(); }},
      {7, "act.command", [](auto& m) { m.mutable_act()->mutable_command()->mutable_start(); }},
      {7, "act.command", [](auto& m) { m.mutable_act()->mutable_command()->mutable_abandoned(); }},
      {7, "act.command.abandoned.seat",
       [](auto& m) { m.mutable_act()->mutable_command()->mutable_abandoned()->set_seat(8); }},
      {7, "act.command.place.x",
       [](auto& m) { m.mutable_act()->mutable_command()->mutable_place()->set_x(nan); }},
      {7, "act.command.choose.option",
       [](auto& m) { m.mutable_act()->mutable_command()->mutable_choose()->clear_option(); }},
      {7, "act.command.shoot.direction_y", [=](auto& m) { shoot(m)->set_direction_y(infinity); }},
      {7, "act.command.shoot.speed_m_s", [=](auto& m) { shoot(m)->set_speed_m_s(-infinity); }},
      {7, "act.command.shoot.tip.side", [=](auto& m) { shoot(m)->mutable_tip()->set_side(nan); }},
      {7, "act.command.shoot.tip.height",
       [=](auto& m) { shoot(m)->mutable_tip()->set_height(infinity); }},
      {7, "act.command.shoot.call.pocket",
       [=](auto& m) { shoot(m)->mutable_call()->set_pocket(6); }},
      {7, "act.command.shoot.call.pocket",
       [=](auto& m) { shoot(m)->mutable_call()->set_pocket(256); }},
  };
}

/// A request of a kind; of the commands, a shot.
lobby::Request sample_request(std::size_t kind) {
  Chance chance(1);
  if (kind != 7) return samples::random_request(chance, kind);
  return lobby::Act{match::MatchId{1}, match::Seq{1}, match::CommandId{1},
                    samples::random_command(chance, 2)};
}

TEST(Hostile, EveryFaultOfARequestNamesItsFieldAndKeepsTheRequestId) {
  for (const WrongRequest& wrong : wrong_requests()) {
    SCOPED_TRACE(wrong.field);
    const lobby::Asked asked{lobby::RequestId{5}, sample_request(wrong.kind)};
    v1::ClientToServer message;
    ASSERT_TRUE(message.ParseFromString(body_of(frame_of(asked))));
    wrong.spoil(message);
    const auto read = read_asked(bytes_of(message.SerializeAsString()));
    const auto* malformed = std::get_if<Malformed>(&read);
    ASSERT_NE(malformed, nullptr);
    EXPECT_EQ(malformed->fault.field, wrong.field);
    EXPECT_FALSE(malformed->fault.what.empty());
    EXPECT_EQ(malformed->id, lobby::RequestId{message.request_id()});
  }
}

TEST(Hostile, TextThatIsNoUtf8IsNamed) {
  // Protobuf does not write such a text: the bytes are changed afterwards.
  v1::ClientToServer message;
  message.set_request_id(1);
  message.mutable_hello()->set_name("name");
  std::string bytes = message.SerializeAsString();
  bytes[bytes.find("name") + 1] = '\xff';
  const auto read = read_asked(bytes_of(bytes));
  const auto* malformed = std::get_if<Malformed>(&read);
  ASSERT_NE(malformed, nullptr);
  EXPECT_EQ(malformed->id, std::nullopt);
  EXPECT_EQ(malformed->fault.field, "hello.name");
}

TEST(Hostile, BytesOfNoMessageAreSaidToBeNone) {
  for (const std::string& bytes :
       {std::string("GET / HTTP/1.1\r\n\r\n"), std::string("\xff\xff"), std::string(1, '\x0a')}) {
    const auto read = read_asked(bytes_of(bytes));
    const auto* malformed = std::get_if<Malformed>(&read);
    ASSERT_NE(malformed, nullptr);
    EXPECT_EQ(malformed->id, std::nullopt);
    EXPECT_EQ(malformed->fault.field, "message");
  }
}

// ---- Answers

struct WrongAnswer {
  std::size_t kind;
  std::string field;
  std::function<void(v1::ServerToClient&)> spoil;
};

/// An entry with a shot of its own, whatever the samples are.
v1::Entry* entry_of(v1::ServerToClient& message) {
  return message.mutable_entry_news()->mutable_entry();
}
v1::Shot* shot_of(v1::ServerToClient& message) {
  return entry_of(message)->mutable_outcome()->mutable_shot();
}

std::vector<WrongAnswer> wrong_answers() {
  const std::string shot = "entry_news.entry.outcome.shot.";
  return {
      {0, "answer", [](auto& m) { m.clear_answer(); }},
      {0, "welcome.name", [](auto& m) { m.mutable_welcome()->clear_name(); }},
      {0, "welcome.token", [](auto& m) { m.mutable_welcome()->set_token("x"); }},
      {0, "welcome.server", [](auto& m) { m.mutable_welcome()->set_server("\x1b]0;x\a"); }},
      {0, "welcome.claim_after_ms", [](auto& m) { m.mutable_welcome()->set_claim_after_ms(-1); }},
      {1, "refused.code", [](auto& m) { m.mutable_refused()->clear_code(); }},
      {1, "refused.detail",
       [](auto& m) { m.mutable_refused()->set_detail(static_cast<v1::CommandRefusal>(77)); }},
      {1, "refused.what", [](auto& m) { m.mutable_refused()->set_what(std::string(1025, 'x')); }},
      {2, "match_news.info.settings.scene.bed.motion",
       [](auto& m) { m.mutable_match_news()->mutable_info()->clear_settings(); }},
      {2, "match_news.info.stage",
       [](auto& m) { m.mutable_match_news()->mutable_info()->clear_stage(); }},
      {2, "match_news.info.seats",
       [](auto& m) { m.mutable_match_news()->mutable_info()->clear_seats(); }},
      {2, "match_news.info.commitment",
       [](auto& m) { m.mutable_match_news()->mutable_info()->clear_commitment(); }},
      {2, "match_news.you", [](auto& m) { m.mutable_match_news()->set_you(8); }},
      {3, "entry_news.entry.command", [](auto& m) { entry_of(m)->clear_command(); }},
      {3, "entry_news.entry.digest", [](auto& m) { entry_of(m)->clear_digest(); }},
      {3, "entry_news.entry.secret", [](auto& m) { entry_of(m)->set_secret("x"); }},
      {3, "entry_news.entry.seat", [](auto& m) { entry_of(m)->set_seat(8); }},
      {3, "entry_news.entry.outcome.status.stage",
       [](auto& m) { entry_of(m)->mutable_outcome()->mutable_status()->clear_stage(); }},
      {3, shot + "stop", [](auto& m) { shot_of(m)->clear_stop(); }},
      {3, shot + "end_s", [](auto& m) { shot_of(m)->set_end_s(nan); }},
      {3, shot + "segments[2].ball",  // the second of a ball ends those at the start
       [](auto& m) { shot_of(m)->mutable_segments(1)->set_ball(shot_of(m)->segments(0).ball()); }},
      {3, shot + "segments[2].x",
       [](auto& m) { shot_of(m)->mutable_segments(2)->set_x(infinity); }},
      {3, shot + "segments[2].spin_x",
       [](auto& m) { shot_of(m)->mutable_segments(2)->set_spin_x(nan); }},
      {3, shot + "segments[2].spin_change_z",
       [](auto& m) { shot_of(m)->mutable_segments(2)->set_spin_change_z(-infinity); }},
      {3, shot + "events[0]",
       [](auto& m) { shot_of(m)->mutable_events(0)->mutable_spins()->set_ball(99); }},
      {3, shot + "segments[2].phase",
       [](auto& m) { shot_of(m)->mutable_segments(2)->clear_phase(); }},
      {3, shot + "segments[3].start_s",
       [](auto& m) { shot_of(m)->mutable_segments(3)->set_start_s(-1); }},
      {3, shot + "segments[3].start_s",
       [](auto& m) { shot_of(m)->mutable_segments(3)->set_start_s(1e9); }},
      {3, shot + "events[0]", [](auto& m) { shot_of(m)->mutable_events(0)->clear_kind(); }},
      {3, shot + "events[0]",
       [](auto& m) { shot_of(m)->mutable_events(0)->mutable_rolls()->set_ball(99); }},
      {3, shot + "events[1].time_s",
       [](auto& m) { shot_of(m)->mutable_events(1)->set_time_s(-1); }},
      {3, shot + "events[1].pass",
       [](auto& m) {
         shot_of(m)->mutable_events(1)->mutable_rests()->set_ball(1);
         shot_of(m)->mutable_events(1)->set_pass(1);
       }},
      {3, shot + "events[1].ball_ball.lower",
       [](auto& m) { shot_of(m)->mutable_events(1)->mutable_ball_ball()->set_lower(1); }},
      {4, "match_gone.what", [](auto& m) { m.mutable_match_gone()->set_what("\x7f"); }},
      {5, "listing.matches",
       [](auto& m) {
         for (int i = 0; i < 51; ++i) m.mutable_listing()->add_matches();
       }},
      {8, "goodbye.reason", [](auto& m) { m.mutable_goodbye()->clear_reason(); }},
      {8, "goodbye.what", [](auto& m) { m.mutable_goodbye()->set_what("\n"); }},
  };
}

lobby::Answer sample_answer(Chance& chance, std::size_t kind) {
  if (kind != 3) return samples::random_answer(chance, kind);
  record::Entry entry = samples::random_entry(chance);
  entry.outcome.shot = samples::random_shot(chance, 10);
  return lobby::EntryNews{match::MatchId{1}, std::make_shared<const record::Entry>(entry)};
}

TEST(Hostile, EveryFaultOfAnAnswerNamesItsField) {
  for (const WrongAnswer& wrong : wrong_answers()) {
    SCOPED_TRACE(wrong.field);
    Chance chance(2);
    const lobby::Told told{lobby::RequestId{5}, sample_answer(chance, wrong.kind)};
    v1::ServerToClient message;
    ASSERT_TRUE(message.ParseFromString(body_of(frame_of(told))));
    wrong.spoil(message);
    const auto read = read_told(bytes_of(message.SerializeAsString()));
    const auto* malformed = std::get_if<Malformed>(&read);
    ASSERT_NE(malformed, nullptr);
    EXPECT_EQ(malformed->fault.field, wrong.field);
    EXPECT_FALSE(malformed->fault.what.empty());
  }
}

// ---- Chance

/// Flips bits, cuts, doubles and inserts.
std::string damaged(std::string bytes, Chance& chance) {
  for (std::size_t n = 1 + chance.below(4); n > 0; --n) {
    const std::size_t at = chance.below(bytes.size() + 1);
    switch (chance.below(4)) {
      case 0:
        if (at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << chance.below(8)));
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.insert(at, bytes.substr(chance.below(at + 1), chance.below(20)));
        break;
      default:
        bytes.insert(at, 1, static_cast<char>(chance.bits()));
    }
  }
  return bytes;
}

TEST(Hostile, DamagedRequestsAreRefusedOrReadAsSomethingThatCanBeSaid) {
  std::size_t refused = 0;
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Chance chance(seed);
    const std::size_t kind = chance.below(samples::request_kinds);
    const lobby::Asked asked{lobby::RequestId{1}, samples::random_request(chance, kind)};
    const auto read = read_asked(bytes_of(damaged(body_of(frame_of(asked)), chance)));
    if (const auto* again = std::get_if<lobby::Asked>(&read)) {
      const auto reread = read_asked(bytes_of(body_of(frame_of(*again))));
      ASSERT_TRUE(std::holds_alternative<lobby::Asked>(reread));
    } else {
      ++refused;
      ASSERT_FALSE(std::get<Malformed>(read).fault.what.empty());
    }
  }
  EXPECT_GT(refused, 1000u);
  EXPECT_LT(refused, 19'000u);
}

TEST(Hostile, DamagedEntriesAreRefusedOrCanBeDrawn) {
  std::size_t refused = 0;
  for (std::uint64_t seed = 1; seed <= 3'000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Chance chance(seed);
    const lobby::Told told{{}, sample_answer(chance, 3)};
    const auto read = read_told(bytes_of(damaged(body_of(frame_of(told)), chance)));
    const auto* again = std::get_if<lobby::Told>(&read);
    if (again == nullptr) {
      ++refused;
      continue;
    }
    const auto* news = std::get_if<lobby::EntryNews>(&again->answer);
    if (news == nullptr || !news->entry->outcome.shot) continue;
    const physics::Timeline timeline(*news->entry->outcome.shot);
    ASSERT_EQ(timeline.states(timeline.end_s() / 2).size(), timeline.balls().size());
  }
  EXPECT_GT(refused, 100u);
  EXPECT_LT(refused, 2'900u);
}

TEST(Hostile, NoiseIsRefused) {
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Chance chance(seed);
    std::string noise(chance.below(64), '\0');
    for (char& c : noise) c = static_cast<char>(chance.bits());
    ASSERT_TRUE(std::holds_alternative<Malformed>(read_told(bytes_of(noise))));
    ASSERT_TRUE(std::holds_alternative<Malformed>(read_asked(bytes_of(noise))));
  }
}

}  // namespace
}  // namespace breakshot::wire
