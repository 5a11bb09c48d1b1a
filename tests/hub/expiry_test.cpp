// The limits of time: matches that nobody begins, and those that nobody goes on with.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

TEST(Limit, AMatchThatDoesNotStartInTimeExpires) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, eight_ball());
  rig.pass(Limits{}.gathering_expires - milliseconds(1));
  rig.tick();
  EXPECT_TRUE(rig.kept().matches.contains(info.id));
  rig.pass(milliseconds(1));
  rig.tick();
  EXPECT_FALSE(rig.kept().matches.contains(info.id));
  EXPECT_EQ(rig.told<lobby::MatchGone>(ada.connection).at(0).match, info.id);
  EXPECT_EQ(rig.standing(ada.connection), Standing::guest);
  EXPECT_EQ(rig.refusal(ada.connection, join(info.id)), lobby::RefusalCode::no_such_match);
}

TEST(Limit, AnExpiryThatCannotBeStoredIsTriedAgain) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, eight_ball());
  rig.pass(Limits{}.gathering_expires);
  rig.store().fail(1, "the disk is full");
  rig.tick();
  EXPECT_TRUE(rig.told<lobby::MatchGone>(ada.connection).empty());
  rig.tick();
  EXPECT_FALSE(rig.kept().matches.contains(info.id));
}

TEST(Limit, WhoeverJoinsWhileAMatchExpiresFindsNone) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, eight_ball());
  rig.pass(Limits{}.gathering_expires);
  rig.hold_store = true;
  rig.tick();
  const auto request = rig.ask(bob.connection, join(info.id));
  rig.let_store_go();
  EXPECT_EQ(rig.answer<lobby::Refused>(bob.connection, request).code,
            lobby::RefusalCode::no_such_match);
}

TEST(Limit, ADesertedMatchIsEnded) {
  HubRig rig;
  const Table table = sit_down(rig);
  const Player eve = meet(rig, "Eve");
  rig.get<lobby::MatchNews>(eve.connection, watch(table.match));
  rig.close(table.first.connection);
  rig.pass(milliseconds(10));
  rig.close(table.second.connection);
  rig.pass(Limits{}.deserted_ends - milliseconds(1));
  rig.tick();
  EXPECT_EQ(told_entries(rig, eve), up_to(1));
  rig.pass(milliseconds(1));
  rig.tick();
  const auto last = rig.told<lobby::EntryNews>(eve.connection).back().entry;
  EXPECT_EQ(last->command, match::Command{match::Abandoned{match::Seat{0}}});
  EXPECT_EQ(last->outcome.status.stage, match::Stage::finished);
}

TEST(Limit, ADesertedPracticeEndsSeatBySeat) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, practice(2));
  rig.get<lobby::MatchNews>(bob.connection, join(info.id));
  contribute(rig, ada, info.id);
  contribute(rig, bob, info.id);
  rig.close(ada.connection);
  rig.close(bob.connection);
  rig.pass(Limits{}.deserted_ends);
  rig.tick();
  rig.tick();
  EXPECT_EQ(rig.kept().matches.at(info.id).row.progress.stage, match::Stage::finished);
}

TEST(Limit, AMatchWithSomebodyPresentIsNotDeserted) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.close(table.second.connection);
  rig.pass(Limits{}.deserted_ends * 2);
  rig.tick();
  EXPECT_EQ(told_entries(rig, table.first), up_to(1));
}

}  // namespace
}  // namespace breakshot::hub
