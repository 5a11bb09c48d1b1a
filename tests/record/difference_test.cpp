#include "common/record/difference.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/record/fixed_record.hpp"

namespace breakshot::record {
namespace {

match::Outcome judged() {
  return fixed_record().entries[2].outcome;
}

template <class Change>
std::optional<std::string> difference_after(Change change) {
  match::Outcome simulated = judged();
  change(simulated);
  return difference_of(judged(), simulated);
}

TEST(Difference, IsNothingBetweenTheSameBytes) {
  EXPECT_EQ(difference_of(judged(), judged()), std::nullopt);
  EXPECT_EQ(difference_after([](auto& o) { o.table.balls[0].velocity.x = -0.0; }), std::nullopt);
}

TEST(Difference, IsOneUlp) {
  EXPECT_EQ(difference_after([](auto& o) {
              auto& event = std::get<physics::BallPocket>(o.shot->events[3]);
              event.time_s = std::nextafter(event.time_s, 2.0);
            }),
            "shot.events[3].time_s: 1.25 stored, 1.2500000000000002 simulated");
}

TEST(Difference, NamesKindsByTheirWords) {
  EXPECT_EQ(difference_after([](auto& o) { o.ruling->fouls[0] = rules::Foul::no_contact; }),
            "ruling.fouls[0]: scratch stored, no_contact simulated");
  EXPECT_EQ(difference_after([](auto& o) {
              o.shot->events[4] = physics::Rests{1.5, physics::BallId{0}};
            }),
            "shot.events[4]: rolls stored, rests simulated");
  EXPECT_EQ(difference_after([](auto& o) { o.status.stage = match::Stage::finished; }),
            "status.stage: running stored, finished simulated");
  EXPECT_EQ(difference_after([](auto& o) { o.status.winner = rules::Seat{0}; }),
            "status.winner: absent stored, present simulated");
}

TEST(Difference, OfAListIsItsFirstElementThatDiffers) {
  EXPECT_EQ(difference_after([](auto& o) { o.shot->events.erase(o.shot->events.begin() + 1); }),
            "shot.events[1]: ball_ball stored, ball_cushion simulated");
}

TEST(Difference, OfAPrefixIsItsEnd) {
  EXPECT_EQ(difference_after([](auto& o) { o.shot->events.pop_back(); }),
            "shot.events[5]: rests stored, shot.events: 5 elements simulated");
  EXPECT_EQ(difference_after([](auto& o) { o.ruling->fouls.push_back(rules::Foul::scratch); }),
            "ruling.fouls: 2 elements stored, ruling.fouls[2]: scratch simulated");
}

}  // namespace
}  // namespace breakshot::record
