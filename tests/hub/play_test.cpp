// A match that runs: store before announce, each command once, claims, the end.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

TEST(Play, NobodyIsToldAShotBeforeItIsStored) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.hold_store = true;
  const auto request = rig.ask(table.first.connection, act(table.match, 1, 7, a_break()));
  EXPECT_EQ(told_entries(rig, table.first), up_to(1));
  EXPECT_EQ(told_entries(rig, table.second), up_to(1));
  rig.let_store_go();
  EXPECT_EQ(told_entries(rig, table.second), up_to(2));
  const auto news = rig.answer<lobby::EntryNews>(table.first.connection, request);
  EXPECT_EQ(news.entry->id, match::CommandId{7});
  EXPECT_TRUE(news.entry->outcome.shot);
  EXPECT_EQ(news.entry, rig.kept().matches.at(table.match).entries.back());
}

TEST(Play, TheAskerIsToldTheEntryOnce) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.get<lobby::EntryNews>(table.first.connection, act(table.match, 1, 7, a_break()));
  EXPECT_EQ(told_entries(rig, table.first), up_to(2));
}

TEST(Play, AShotThatCannotBeStoredChangesNothing) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.store().fail(1, "the disk is full");
  EXPECT_EQ(refused(rig, table.first, act(table.match, 1, 7, a_break())).code,
            lobby::RefusalCode::unavailable);
  EXPECT_EQ(told_entries(rig, table.second), up_to(1));
  EXPECT_EQ(rig.get<lobby::MatchNews>(table.first.connection, watch(table.match, 1)).info.next,
            match::Seq{1});
}

TEST(Play, AShotThatWasNotStoredHasTheSameOutcomeWhenItIsAskedForAgain) {
  HubRig failing;
  HubRig rig;
  const Table table = sit_down(rig);
  const Table same = sit_down(failing);
  failing.store().fail(1, "the disk is full");
  refused(failing, same.first, act(same.match, 1, 7, a_break()));
  failing.get<lobby::EntryNews>(same.first.connection, act(same.match, 1, 7, a_break()));
  rig.get<lobby::EntryNews>(table.first.connection, act(table.match, 1, 7, a_break()));
  EXPECT_EQ(*rig.kept().matches.at(table.match).entries.back(),
            *failing.kept().matches.at(same.match).entries.back());
}

TEST(Play, ARefusalOfTheGameIsToldWithItsReason) {
  HubRig rig;
  const Table table = sit_down(rig);
  const auto not_the_turn = refused(rig, table.second, act(table.match, 1, 7, a_break()));
  EXPECT_EQ(not_the_turn.code, lobby::RefusalCode::command);
  EXPECT_EQ(not_the_turn.detail, match::RefusalCode::not_your_turn);
  EXPECT_FALSE(not_the_turn.what.empty());
  const auto bad = refused(rig, table.first, act(table.match, 1, 7, match::Shoot{{2, 0}, 8, {}}));
  EXPECT_EQ(bad.detail, match::RefusalCode::bad_value);
  EXPECT_EQ(rig.kept().matches.at(table.match).entries.size(), 1u);
}

TEST(Play, ASpectatorHasNoCommands) {
  HubRig rig;
  const Table table = sit_down(rig);
  const Player eve = meet(rig, "Eve");
  rig.get<lobby::MatchNews>(eve.connection, watch(table.match));
  EXPECT_EQ(refused(rig, eve, act(table.match, 1, 7, a_break())).code,
            lobby::RefusalCode::not_seated);
}

TEST(Play, AMatchThatHasNotStartedHasNoCommands) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, eight_ball());
  EXPECT_EQ(refused(rig, ada, act(info.id, 0, 7, a_break())).code, lobby::RefusalCode::wrong_stage);
}

TEST(Play, TheServersCommandsAndTheServersIdAreRefused) {
  HubRig rig;
  const Table table = sit_down(rig);
  const auto bad = lobby::RefusalCode::bad_request;
  EXPECT_EQ(refused(rig, table.first, act(table.match, 1, 7, match::Start{})).code, bad);
  EXPECT_EQ(
      refused(rig, table.first, act(table.match, 1, 7, match::Abandoned{match::Seat{1}})).code,
      bad);
  EXPECT_EQ(refused(rig, table.first, act(table.match, 1, 0, a_break())).code, bad);
}

// ---- The end

TEST(End, TheLastEntryRevealsTheSecretAndTheRecordVerifies) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.get<lobby::EntryNews>(table.first.connection, act(table.match, 1, 7, a_break()));
  EXPECT_FALSE(rig.kept().matches.at(table.match).entries.back()->secret);
  const auto news =
      rig.get<lobby::EntryNews>(table.second.connection, act(table.match, 2, 8, match::Concede{}));
  const auto& kept = rig.kept().matches.at(table.match);
  EXPECT_EQ(news.entry->secret, kept.secret);
  record::Record record{*kept.row.header, {}};
  for (const auto& entry : kept.entries) record.entries.push_back(*entry);
  const record::Verdict verdict = record::verify(record);
  EXPECT_EQ(verdict.kind, record::Verdict::Kind::verified);
  EXPECT_EQ(verdict.entries_verified, 3u);
  EXPECT_EQ(rig.notes<MatchFinished>().at(0).winner, match::Seat{0});
}

TEST(End, TheOtherPlayerIsToldTheLastEntry) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.get<lobby::EntryNews>(table.second.connection, act(table.match, 1, 8, match::Concede{}));
  EXPECT_EQ(told_entries(rig, table.first), up_to(2));
}

}  // namespace
}  // namespace breakshot::hub
