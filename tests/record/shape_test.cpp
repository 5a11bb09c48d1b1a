#include "common/record/shape.hpp"

#include <gtest/gtest.h>

#include "tests/record/fixed_record.hpp"

namespace breakshot::record {
namespace {

template <class Change>
std::optional<std::string> fault_of_shot(Change change) {
  physics::Shot shot = fixed_shot();
  change(shot);
  return shape_fault(shot);
}

TEST(Shape, AcceptsAShotAndATable) {
  EXPECT_EQ(shape_fault(fixed_shot()), std::nullopt);
  EXPECT_EQ(shape_fault(physics::Shot{}), std::nullopt);
  EXPECT_EQ(shape_fault(fixed_table()), std::nullopt);
  EXPECT_EQ(shape_fault(physics::State{}), std::nullopt);
}

TEST(Shape, WantsBallsInAscendingOrder) {
  physics::State table = fixed_table();
  table.balls[1].id = table.balls[0].id;
  EXPECT_EQ(shape_fault(table), "balls[1] does not ascend by id");
}

TEST(Shape, WantsTimesInOrderAndWithinTheShot) {
  EXPECT_EQ(fault_of_shot([](auto& shot) { shot.end_s = -1; }), "ends before it starts");
  EXPECT_EQ(fault_of_shot([](auto& shot) { shot.end_s = 1.75; }),
            "segments[6] is later than the end of the shot");
  EXPECT_EQ(fault_of_shot([](auto& shot) { shot.segments[5].start_s = 1; }),
            "segments[5] is earlier than the one before it");
  EXPECT_EQ(fault_of_shot([](auto& shot) {
              shot.events[5] = physics::Rests{2.5, {}};
            }),
            "events[5] is later than the end of the shot");
  EXPECT_EQ(fault_of_shot([](auto& shot) { std::swap(shot.events[1], shot.events[2]); }),
            "events[2] is earlier than the one before it");
  EXPECT_EQ(fault_of_shot([](auto& shot) {
              shot.events[0] = physics::Struck{-1, {}};
            }),
            "events[0] is earlier than the one before it");
}

TEST(Shape, WantsAPathForEveryBall) {
  const physics::BallId stranger{5};
  EXPECT_EQ(fault_of_shot([&](auto& shot) { shot.segments[2].ball = stranger; }),
            "segments[2] is of ball 5, which has no segment from 0");
  EXPECT_EQ(fault_of_shot([&](auto& shot) {
              shot.events[4] = physics::Rolls{1.5, stranger};
            }),
            "events[4] is of ball 5, which has no segment from 0");
  EXPECT_EQ(fault_of_shot([](auto& shot) { shot.segments.erase(shot.segments.begin()); }),
            "segments[1] is of ball 0, which has no segment from 0");
  const physics::BallId cue{0};
  EXPECT_EQ(fault_of_shot([&](auto& shot) {
              shot.events[1] = physics::BallBall{0.5, 0, cue, stranger};
            }),
            "events[1] is of ball 5, which has no segment from 0");
  EXPECT_EQ(fault_of_shot([&](auto& shot) {
              shot.events[1] = physics::BallBall{0.5, 0, cue, cue};
            }),
            "events[1] must name the lower ball first");
}

TEST(Shape, WantsAPlayerForEverySeat) {
  Header header = fixed_header();
  EXPECT_EQ(shape_fault(header), std::nullopt);
  header.settings.seats = 3;
  EXPECT_EQ(shape_fault(header), "players: 2 listed, one for each of 3 seats is right");
  header.settings.seats = 0;
  EXPECT_EQ(shape_fault(header), "settings.seats: 0 seats, 1 to 8 are right");
  header.settings.seats = 9;
  EXPECT_EQ(shape_fault(header), "settings.seats: 9 seats, 1 to 8 are right");
}

TEST(Shape, WantsSeatsOfTheMatch) {
  const Header header = fixed_header();
  const Entry good = fixed_record().entries[2];
  const rules::Seat third{2};
  const auto fault = [&](auto change) {
    Entry entry = good;
    change(entry);
    return shape_fault(header, entry);
  };
  EXPECT_EQ(fault([](Entry&) {}), std::nullopt);
  EXPECT_EQ(fault([&](Entry& e) { e.author.seat = third; }),
            "author.seat: seat 2 of a match with 2");
  EXPECT_EQ(fault([&](Entry& e) { e.command = match::Abandoned{third}; }),
            "command.seat: seat 2 of a match with 2");
  EXPECT_EQ(fault([&](Entry& e) { e.outcome.ruling->rack_winner = third; }),
            "outcome.ruling.rack_winner: seat 2 of a match with 2");
  EXPECT_EQ(fault([&](Entry& e) { e.outcome.status.game.turn = third; }),
            "outcome.status.game.turn: seat 2 of a match with 2");
  EXPECT_EQ(fault([&](Entry& e) { e.outcome.status.winner = third; }),
            "outcome.status.winner: seat 2 of a match with 2");
}

TEST(Shape, WantsOneOfEachForEverySeat) {
  const Header header = fixed_header();
  const auto fault = [&](auto change) {
    Entry entry = fixed_record().entries[2];
    change(entry.outcome.status);
    return shape_fault(header, entry);
  };
  EXPECT_EQ(fault([](match::Status& s) { s.score.pop_back(); }),
            "outcome.status.score: 1 listed, one for each of 2 seats is right");
  EXPECT_EQ(fault([](match::Status& s) { s.game.groups.clear(); }),
            "outcome.status.game.groups: 0 listed, one for each of 2 seats is right");
  EXPECT_EQ(fault([](match::Status& s) { s.rerack_agreed.push_back(true); }),
            "outcome.status.rerack_agreed: 3 listed, one for each of 2 seats is right");
}

}  // namespace
}  // namespace breakshot::record
