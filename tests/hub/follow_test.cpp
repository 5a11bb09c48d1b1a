// Who is told what: every follower each entry once and in order, wherever it comes from.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

TEST(Follow, ALatecomerIsToldTheMatchSoFarAndThenGoesOnLive) {
  HubRig rig;
  const Alone alone = practise(rig);
  play(rig, alone, 1, 5);
  const Player eve = meet(rig, "Eve");
  const auto news = rig.get<lobby::MatchNews>(eve.connection, watch(alone.match));
  EXPECT_EQ(news.info.next, match::Seq{6});
  EXPECT_TRUE(news.header);
  EXPECT_FALSE(news.you);
  EXPECT_EQ(told_entries(rig, eve), up_to(6));
  play(rig, alone, 6, 2);
  EXPECT_EQ(told_entries(rig, eve), up_to(8));
}

TEST(Follow, TheNewsComesBeforeTheEntries) {
  HubRig rig;
  const Alone alone = practise(rig);
  const Player eve = meet(rig, "Eve");
  rig.forget(eve.connection);
  rig.ask(eve.connection, watch(alone.match));
  ASSERT_EQ(rig.inbox(eve.connection).size(), 2u);
  EXPECT_TRUE(std::holds_alternative<lobby::MatchNews>(rig.inbox(eve.connection)[0]->answer));
  EXPECT_EQ(rig.inbox(eve.connection)[1]->id, lobby::RequestId{0});
}

TEST(Follow, FollowingBeginsAtTheNumberAskedFor) {
  HubRig rig;
  const Alone alone = practise(rig);
  play(rig, alone, 1, 5);
  const Player eve = meet(rig, "Eve");
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match, 4));
  EXPECT_EQ(told_entries(rig, eve), up_to(6, 4));
}

TEST(Follow, FollowingFromBeyondTheEndIsRefused) {
  HubRig rig;
  const Alone alone = practise(rig);
  const Player eve = meet(rig, "Eve");
  for (const lobby::Request& request :
       {lobby::Request{watch(alone.match, 2)}, lobby::Request{fetch(alone.match, 2)}}) {
    EXPECT_EQ(rig.refusal(eve.connection, request), lobby::RefusalCode::bad_request);
  }
  EXPECT_EQ(
      rig.refusal(alone.player.connection, lobby::Join{alone.match, std::nullopt, match::Seq{2}}),
      lobby::RefusalCode::bad_request);
}

TEST(Follow, OldEntriesComeFromTheStoreWithoutGapOrDouble) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 20);
  const Player eve = meet(rig, "Eve");
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match));
  EXPECT_EQ(told_entries(rig, eve), up_to(21));
  EXPECT_GT(rig.loads(), 5u);
}

TEST(Follow, EntriesStoredWhileAFollowerIsBehindComeInTheirPlace) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  const Player eve = meet(rig, "Eve");
  rig.hold_drains = true;
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match));
  std::uint32_t next = 11;
  while (rig.is_draining(eve.connection) && next < 25) {
    play(rig, alone, next++, 1);
    rig.drain(eve.connection);
  }
  while (rig.is_draining(eve.connection)) rig.drain(eve.connection);
  EXPECT_EQ(told_entries(rig, eve), up_to(next));
  play(rig, alone, next, 1);
  EXPECT_EQ(told_entries(rig, eve), up_to(next + 1));
}

TEST(Follow, EntriesStoredWhileABatchIsBeingLoadedComeInTheirPlace) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  const Player eve = meet(rig, "Eve");
  rig.hold_store = true;
  rig.ask(eve.connection, watch(alone.match));
  rig.ask(alone.player.connection, act(alone.match, 11, 11, a_place(11)));
  rig.let_store_go();
  EXPECT_EQ(told_entries(rig, eve), up_to(12));
}

TEST(Follow, ABatchInTheSendQueueHoldsBackTheNext) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 20);
  const Player eve = meet(rig, "Eve");
  rig.hold_drains = true;
  rig.ask(eve.connection, watch(alone.match));
  rig.ask(eve.connection, fetch(alone.match));
  const std::size_t first = told_entries(rig, eve).size();
  EXPECT_LT(first, 8u);
  rig.drain(eve.connection);
  EXPECT_GT(told_entries(rig, eve).size(), first);
}

TEST(Follow, AskingAgainStartsAgainAtTheNewNumber) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  const Player eve = meet(rig, "Eve");
  rig.hold_drains = true;
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match));
  rig.forget(eve.connection);
  rig.hold_drains = false;
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match, 9));
  rig.drain(eve.connection);
  EXPECT_EQ(told_entries(rig, eve), up_to(11, 9));
  play(rig, alone, 11, 1);
  EXPECT_EQ(told_entries(rig, eve), up_to(12, 9));
}

TEST(Follow, WhoLeavesIsToldNoMore) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  const Player eve = meet(rig, "Eve");
  rig.hold_drains = true;
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match));
  const auto before = told_entries(rig, eve);
  rig.get<lobby::Done>(eve.connection, lobby::Leave{alone.match});
  rig.drain(eve.connection);
  play(rig, alone, 11, 1);
  EXPECT_EQ(told_entries(rig, eve), before);
}

TEST(Follow, AMatchThatEndsWhileAFollowerIsBehindIsToldToTheEnd) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  const Player eve = meet(rig, "Eve");
  rig.hold_drains = true;
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match));
  rig.get<lobby::EntryNews>(alone.player.connection, act(alone.match, 11, 11, match::Concede{}));
  while (rig.is_draining(eve.connection)) rig.drain(eve.connection);
  EXPECT_EQ(told_entries(rig, eve), up_to(12));
}

TEST(Follow, AFinishedMatchIsToldFromTheStore) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  rig.get<lobby::EntryNews>(alone.player.connection, act(alone.match, 11, 11, match::Concede{}));
  const Player eve = meet(rig, "Eve");
  const auto news = rig.get<lobby::MatchNews>(eve.connection, watch(alone.match, 2));
  EXPECT_EQ(news.info.stage, match::Stage::finished);
  EXPECT_EQ(news.info.end, match::MatchEnd::conceded);
  EXPECT_EQ(told_entries(rig, eve), up_to(12, 2));
}

TEST(Follow, APlayerComesBackToAFinishedMatch) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.close(table.second.connection);
  rig.get<lobby::EntryNews>(table.first.connection, act(table.match, 1, 7, match::Concede{}));
  const Player bob = again(rig, table.second);
  const auto news =
      rig.get<lobby::MatchNews>(bob.connection, lobby::Join{table.match, {}, match::Seq{1}});
  EXPECT_EQ(news.you, match::Seat{1});
  EXPECT_EQ(news.info.winner, match::Seat{1});
  EXPECT_EQ(told_entries(rig, bob), up_to(2, 1));
}

TEST(Follow, NobodyElseJoinsAFinishedMatch) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.get<lobby::EntryNews>(table.first.connection, act(table.match, 1, 7, match::Concede{}));
  const Player eve = meet(rig, "Eve");
  EXPECT_EQ(rig.refusal(eve.connection, join(table.match)), lobby::RefusalCode::wrong_stage);
}

TEST(Follow, AFollowerThatCannotBeToldTheMatchSoFarIsSentAway) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  const Player eve = meet(rig, "Eve");
  rig.hold_store = true;
  rig.ask(eve.connection, watch(alone.match));
  rig.store().fail(1, "cannot read");
  rig.let_store_go();
  EXPECT_EQ(rig.told<lobby::Goodbye>(eve.connection).at(0).reason, lobby::GoodbyeReason::stopping);
  EXPECT_TRUE(rig.is_closing(eve.connection));
  play(rig, alone, 11, 1);
  const Player back = again(rig, eve);
  rig.get<lobby::MatchNews>(back.connection, watch(alone.match));
  EXPECT_EQ(told_entries(rig, back), up_to(12));
}

// ---- Answers that are entries which a follower awaits

TEST(Follow, AnAnswerThatAFollowerAwaitsIsNotToldAgain) {
  Limits limits;
  limits.batch_bytes = 1;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  play(rig, alone, 1, 4);
  const Player ada = again(rig, alone.player);
  rig.hold_drains = true;
  rig.get<lobby::MatchNews>(ada.connection, join(alone.match));
  EXPECT_EQ(told_entries(rig, ada), up_to(1));
  rig.get<lobby::EntryNews>(ada.connection, act(alone.match, 1, 1, a_place(1)));
  while (rig.is_draining(ada.connection)) rig.drain(ada.connection);
  EXPECT_EQ(told_entries(rig, ada), up_to(5));
}

TEST(Follow, AnAnswerThatAFollowerAwaitsIsNotToldAgainFromABatchUnderWay) {
  Limits limits;
  limits.batch_bytes = 1;
  limits.recent_entries = 1;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  play(rig, alone, 1, 4);
  const Player ada = again(rig, alone.player);
  rig.hold_store = true;
  rig.ask(ada.connection, act(alone.match, 1, 1, a_place(1)));
  rig.ask(ada.connection, watch(alone.match, 1));
  rig.let_store_go();
  EXPECT_EQ(told_entries(rig, ada), up_to(5, 1));
}

TEST(Follow, AnAnswerAheadOfWhatAFollowerWasToldComesAgainInItsPlace) {
  Limits limits;
  limits.batch_bytes = 1;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  play(rig, alone, 1, 2);
  const Player ada = again(rig, alone.player);
  rig.hold_drains = true;
  rig.get<lobby::MatchNews>(ada.connection, join(alone.match));
  rig.get<lobby::EntryNews>(ada.connection, act(alone.match, 3, 3, a_place(3)));
  while (rig.is_draining(ada.connection)) rig.drain(ada.connection);
  EXPECT_EQ(told_entries(rig, ada), (std::vector<std::uint32_t>{0, 3, 1, 2, 3}));
}

}  // namespace
}  // namespace breakshot::hub
