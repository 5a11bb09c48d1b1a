#include "common/record/limits.hpp"

#include <gtest/gtest.h>

#include "common/record/record.hpp"
#include "tests/record/small_record.hpp"

namespace breakshot::record {
namespace {

/// Fills a list or a text to its limit, and one beyond.
template <class Value, class List, class Fault>
void expect_limit(const Value& value, List list, std::size_t limit, Fault fault) {
  Value full = value, beyond = value;
  list(full).resize(limit, typename std::remove_reference_t<decltype(list(full))>::value_type{'x'});
  list(beyond) = list(full);
  list(beyond).push_back(list(full).back());
  EXPECT_EQ(fault(full), std::nullopt);
  const auto said = fault(beyond);
  ASSERT_TRUE(said);
  EXPECT_NE(said->find("is beyond the limit of " + std::to_string(limit)), std::string::npos)
      << *said;
}

TEST(Limits, HoldForHeaders) {
  const auto fault = [](const Header& header) { return fault_of(header); };
  const auto text = [](Header & header) -> auto& {
    return header.settings.preset;
  };
  expect_limit(small_header(), text, max_text_bytes, fault);
  const auto name = [](Header & header) -> auto& {
    return header.players[0].name;
  };
  expect_limit(small_header(), name, max_text_bytes, fault);
  Header many = small_header();
  many.settings.seats = max_seats;
  many.players.resize(max_seats);
  EXPECT_EQ(fault_of(many), std::nullopt);
  many.players.emplace_back();
  EXPECT_EQ(fault_of(many), "players: a count of 9 is beyond the limit of 8");
}

TEST(Limits, HoldForCushions) {
  Header header = small_header();
  physics::FreeCushions cushions;
  cushions.segments.resize(max_cushions);
  header.settings.scene.cushions = cushions;
  EXPECT_EQ(fault_of(header), std::nullopt);
  cushions.segments.emplace_back();
  header.settings.scene.cushions = cushions;
  EXPECT_EQ(fault_of(header),
            "settings.scene.cushions.segments: a count of 4097 is beyond the limit of 4096");
}

physics::State state_of(std::size_t balls) {
  physics::State state;
  for (std::uint32_t id = 0; id < balls; ++id) {
    state.balls.push_back({physics::BallId{id}, {}, {}, {}});
  }
  return state;
}

TEST(Limits, HoldForBalls) {
  Entry entry = small_entry();
  entry.outcome.table = state_of(max_balls);
  EXPECT_EQ(fault_of(small_header(), entry), std::nullopt);
  entry.outcome.table = state_of(max_balls + 1);
  EXPECT_EQ(fault_of(small_header(), entry),
            "outcome.table.balls: a count of 4097 is beyond the limit of 4096");
}

TEST(Limits, HoldForShots) {
  Entry entry = small_entry();
  physics::Shot& shot = entry.outcome.shot.emplace();
  shot.events.resize(max_events, physics::Rests{0, physics::BallId{7}});
  shot.segments.resize(max_segments, physics::Segment{physics::BallId{7}, {}, 0, {}, {}, {}});
  EXPECT_EQ(fault_of(small_header(), entry), std::nullopt);
  shot.segments.push_back(shot.segments.back());
  EXPECT_EQ(fault_of(small_header(), entry),
            "outcome.shot.segments: a count of 44097 is beyond the limit of 44096");
  shot.events.push_back(shot.events.back());
  EXPECT_EQ(fault_of(small_header(), entry),
            "outcome.shot.events: a count of 20001 is beyond the limit of 20000");
}

TEST(Limits, HoldForRulings) {
  const auto fault = [](const Entry& entry) { return fault_of(small_header(), entry); };
  Entry entry = small_entry();
  entry.outcome.ruling.emplace();
  entry.outcome.ruling->fouls.resize(max_fouls);
  entry.outcome.status.game.options.resize(max_options);
  EXPECT_EQ(fault(entry), std::nullopt);
  entry.outcome.status.game.options.emplace_back();
  EXPECT_EQ(fault(entry), "outcome.status.game.options: a count of 17 is beyond the limit of 16");
  entry.outcome.ruling->fouls.emplace_back();
  EXPECT_EQ(fault(entry), "outcome.ruling.fouls: a count of 17 is beyond the limit of 16");
  const auto pocketed = [](Entry & e) -> auto& {
    return e.outcome.ruling->pocketed;
  };
  const auto spotted = [](Entry & e) -> auto& {
    return e.outcome.ruling->spotted;
  };
  Entry judged = small_entry();
  judged.outcome.ruling.emplace();
  expect_limit(judged, pocketed, max_balls, fault);
  expect_limit(judged, spotted, max_balls, fault);
}

}  // namespace
}  // namespace breakshot::record
