// Who is told what: every follower each entry once and in order, wherever it comes from.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

/// Few entries in memory, few in a batch.
Limits small_batches() {
  Limits limits;
  limits.recent_entries = 3;
  limits.batch_bytes = 1500;
  return limits;
}

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

// ---- Fetching

/// What a fetch told: the numbers of the entries, and whether news came first and the end last.
std::vector<std::uint32_t> fetched(HubRig& rig, const Player& player, const lobby::Fetch& fetch) {
  const auto answers = rig.answers(player.connection, rig.ask(player.connection, fetch));
  std::vector<std::uint32_t> numbers;
  EXPECT_TRUE(std::get<lobby::MatchNews>(answers.at(0)).header);
  for (std::size_t i = 1; i + 1 < answers.size(); ++i) {
    const auto& news = std::get<lobby::EntryNews>(answers[i]);
    numbers.push_back(static_cast<std::uint32_t>(news.entry->seq));
  }
  const auto& done = std::get<lobby::FetchDone>(answers.back());
  EXPECT_EQ(done.next, std::get<lobby::MatchNews>(answers[0]).info.next);
  return numbers;
}

TEST(Fetch, ARecordOfAFinishedMatchVerifies) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  rig.get<lobby::EntryNews>(alone.player.connection, act(alone.match, 11, 11, match::Concede{}));
  const Player eve = meet(rig, "Eve");
  const auto answers = rig.answers(eve.connection, rig.ask(eve.connection, fetch(alone.match)));
  record::Record record{*std::get<lobby::MatchNews>(answers.at(0)).header, {}};
  for (const lobby::Answer& answer : answers) {
    if (const auto* news = std::get_if<lobby::EntryNews>(&answer)) {
      record.entries.push_back(*news->entry);
    }
  }
  EXPECT_EQ(record.entries.size(), 12u);
  EXPECT_EQ(record::verify(record).kind, record::Verdict::Kind::verified);
}

TEST(Fetch, ARunningMatchIsFetchedUpToWhereItStands) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  const Player eve = meet(rig, "Eve");
  EXPECT_EQ(fetched(rig, eve, fetch(alone.match)), up_to(11));
  EXPECT_EQ(fetched(rig, eve, fetch(alone.match, 8)), up_to(11, 8));
  EXPECT_EQ(fetched(rig, eve, fetch(alone.match, 11)), up_to(11, 11));
}

TEST(Fetch, EntriesStoredMeanwhileAreNotPartOfIt) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 6);
  const Player eve = meet(rig, "Eve");
  rig.hold_drains = true;
  const auto request = rig.ask(eve.connection, fetch(alone.match));
  play(rig, alone, 7, 5);
  while (rig.is_draining(eve.connection)) rig.drain(eve.connection);
  EXPECT_EQ(rig.answers(eve.connection, request).size(), 9u);
  EXPECT_EQ(told_entries(rig, eve), up_to(7));
}

TEST(Fetch, AMatchThatHasNotStartedHasNoRecord) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, eight_ball());
  EXPECT_EQ(rig.refusal(ada.connection, fetch(info.id)), lobby::RefusalCode::wrong_stage);
}

TEST(Fetch, AMatchThatThereIsNot) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  EXPECT_EQ(rig.refusal(ada.connection, fetch(match::MatchId{4711})),
            lobby::RefusalCode::no_such_match);
  EXPECT_EQ(rig.refusal(ada.connection, lobby::Fetch{}), lobby::RefusalCode::bad_request);
}

TEST(Fetch, AStoreThatCannotBeReadMakesItUnavailable) {
  HubRig rig(small_batches());
  const Alone alone = practise(rig);
  play(rig, alone, 1, 10);
  const Player eve = meet(rig, "Eve");
  rig.hold_store = true;
  const auto request = rig.ask(eve.connection, fetch(alone.match));
  rig.store().fail(1, "cannot read");
  rig.let_store_go();
  const auto answers = rig.answers(eve.connection, request);
  EXPECT_EQ(std::get<lobby::Refused>(answers.back()).code, lobby::RefusalCode::unavailable);
  EXPECT_FALSE(rig.is_closing(eve.connection));
  rig.store().fail(1, "cannot read");
  EXPECT_EQ(rig.refusal(eve.connection, fetch(match::MatchId{4711})),
            lobby::RefusalCode::unavailable);
}

}  // namespace
}  // namespace breakshot::hub
