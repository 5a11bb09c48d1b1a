// Restarting and stopping.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

TEST(Restart, AMatchGoesOnAndTheShotThatWasNotStoredHasTheSameOutcome) {
  HubRig rig;
  const Table table = sit_down(rig);
  const auto shot = act(table.match, 1, 7, a_break());
  const support::Kept at_the_crash = rig.kept();
  const auto lost = rig.get<lobby::EntryNews>(table.first.connection, shot).entry;

  HubRig after({}, at_the_crash);
  EXPECT_EQ(after.notes<MatchRestored>().at(0).next, match::Seq{1});
  const Player ada = again(after, table.first);
  const auto news = after.get<lobby::MatchNews>(ada.connection, join(table.match));
  EXPECT_EQ(news.you, match::Seat{0});
  EXPECT_EQ(news.info.stage, match::Stage::running);
  EXPECT_TRUE(news.header);
  const auto replayed = after.get<lobby::EntryNews>(ada.connection, shot).entry;
  EXPECT_EQ(*replayed, *lost);
  EXPECT_EQ(replayed->digest, lost->digest);
}

TEST(Restart, AStoredShotWhoseAnswerWasLostIsAnsweredAndNotPlayedAgain) {
  HubRig rig;
  const Table table = sit_down(rig);
  const auto shot = act(table.match, 1, 7, a_break());
  rig.get<lobby::EntryNews>(table.first.connection, shot);
  HubRig after({}, rig.kept());
  const Player ada = again(after, table.first);
  EXPECT_EQ(after.get<lobby::EntryNews>(ada.connection, shot).entry->seq, match::Seq{1});
  EXPECT_EQ(after.kept().matches.at(table.match).entries.size(), 2u);
}

TEST(Restart, AWholeMatchSurvivesARestartBeforeEveryCommand) {
  HubRig straight;
  const Alone alone = practise(straight);
  support::Kept kept = straight.kept();
  Limits limits;
  limits.recent_entries = 2;
  for (std::uint32_t i = 1; i < 12; ++i) {
    const match::Command command = i % 3 == 0 ? a_place(i) : a_break();
    straight.get<lobby::EntryNews>(alone.player.connection, act(alone.match, i, i, command));
    HubRig restarted(limits, kept);
    const Player ada = again(restarted, alone.player);
    restarted.get<lobby::EntryNews>(ada.connection, act(alone.match, i, i, command));
    kept = restarted.kept();
  }
  const auto& expected = straight.kept().matches.at(alone.match).entries;
  const auto& found = kept.matches.at(alone.match).entries;
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(*found[i], *expected[i]) << i;
}

TEST(Restart, AnOpenMatchKeepsItsSeatsContributionsAndCode) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, eight_ball(true));
  contribute(rig, ada, info.id, 1);
  HubRig after({}, rig.kept());
  const Player bob_again = again(after, bob);
  const auto news =
      after.get<lobby::MatchNews>(bob_again.connection, lobby::Join{{}, info.code, {}});
  EXPECT_EQ(news.you, match::Seat{1});
  EXPECT_TRUE(news.info.seats.at(0).contributed);
  contribute(after, bob_again, info.id, 2);
  EXPECT_EQ(told_entries(after, bob_again), up_to(1));
}

TEST(Restart, TheTimeThatAMatchWasOpenCountsAcrossIt) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, eight_ball());
  HubRig after({}, rig.kept());
  after.pass(Limits{}.gathering_expires);
  after.tick();
  EXPECT_FALSE(after.kept().matches.contains(info.id));
}

TEST(Restart, NobodyLosesForHavingBeenAwayBeforeIt) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.close(table.second.connection);
  rig.pass(Limits{}.claim_after);
  HubRig after({}, rig.kept());
  const Player ada = again(after, table.first);
  after.get<lobby::MatchNews>(ada.connection, join(table.match));
  EXPECT_EQ(after.refusal(ada.connection, lobby::Claim{table.match}),
            lobby::RefusalCode::too_early);
  after.pass(Limits{}.claim_after);
  after.get<lobby::EntryNews>(ada.connection, lobby::Claim{table.match});
}

// ---- Matches that cannot go on

/// A running match of which `spoil` has changed what the store gives back.
template <class Spoil>
void expect_set_aside(Spoil spoil) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.get<lobby::EntryNews>(table.first.connection, act(table.match, 1, 7, a_break()));
  support::Kept kept = rig.kept();
  spoil(kept.matches.at(table.match));
  HubRig after({}, kept);
  ASSERT_EQ(after.notes<MatchSetAside>().size(), 1u);
  EXPECT_TRUE(after.notes<MatchRestored>().empty());
  EXPECT_TRUE(is_alarming(after.notes<MatchSetAside>()[0]));
  // It can still be read, but not played.
  const Player ada = again(after, table.first);
  const auto answers = after.answers(ada.connection, after.ask(ada.connection, fetch(table.match)));
  EXPECT_TRUE(std::holds_alternative<lobby::MatchNews>(answers.at(0)));
  EXPECT_EQ(after.refusal(ada.connection, act(table.match, 2, 8, match::Concede{})),
            lobby::RefusalCode::unavailable);
}

using KeptMatch = support::Kept::Match;

TEST(Restart, AMatchWithAnotherOutcomeIsSetAside) {
  expect_set_aside([](KeptMatch& match) {
    record::Entry entry = *match.entries[1];
    entry.outcome.table.balls[0].position.x += 0.001;
    entry.digest = record::digest_of(match.entries[0]->digest, entry);
    match.entries[1] = std::make_shared<const record::Entry>(entry);
  });
}

TEST(Restart, AMatchWithABrokenChainIsSetAside) {
  expect_set_aside([](KeptMatch& match) {
    record::Entry entry = *match.entries[1];
    entry.digest[0] ^= 1;
    match.entries[1] = std::make_shared<const record::Entry>(entry);
  });
}

TEST(Restart, AMatchWithAnotherSecretIsSetAside) {
  expect_set_aside([](KeptMatch& match) { match.secret[0] ^= 1; });
}

TEST(Restart, AMatchThatLacksEntriesIsSetAside) {
  expect_set_aside([](KeptMatch& match) { match.entries.pop_back(); });
}

TEST(Restart, AMatchOfAnotherVersionOfThePhysicsIsSetAside) {
  expect_set_aside([](KeptMatch& match) { match.row.header->physics += 1; });
}

TEST(Restart, ADamagedMatchIsNoted) {
  HubRig rig;
  rig.step(ledger::Restored{ledger::DamagedMatch{match::MatchId{7}, "a blob has the wrong size"}});
  ASSERT_EQ(rig.notes<MatchSetAside>().size(), 1u);
  EXPECT_EQ(sentence_of(rig.notes<MatchSetAside>()[0]),
            "match 0000000000000007 cannot go on: a blob has the wrong size");
}

// ---- Stopping

TEST(Stop, EveryoneIsToldGoodbyeAndStoppedComesLast) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const ConnectionId stranger = rig.open();
  rig.step(Stopping{});
  for (const ConnectionId connection : {ada.connection, stranger}) {
    EXPECT_EQ(rig.told<lobby::Goodbye>(connection).at(0).reason, lobby::GoodbyeReason::stopping);
    EXPECT_TRUE(rig.is_closing(connection));
  }
  EXPECT_TRUE(rig.stopped());
}

TEST(Stop, WhatIsBeingStoredIsWaitedForAndAnnounced) {
  HubRig rig;
  const Alone alone = practise(rig);
  rig.hold_store = true;
  const auto shot = rig.ask(alone.player.connection, act(alone.match, 1, 1, a_break()));
  const auto behind = rig.ask(alone.player.connection, act(alone.match, 2, 2, a_break()));
  rig.step(Stopping{});
  EXPECT_FALSE(rig.stopped());
  rig.let_store_go();
  EXPECT_TRUE(rig.stopped());
  rig.answer<lobby::EntryNews>(alone.player.connection, shot);
  EXPECT_EQ(rig.answer<lobby::Refused>(alone.player.connection, behind).code,
            lobby::RefusalCode::unavailable);
}

TEST(Stop, NothingNewIsCarriedOut) {
  HubRig rig;
  const Alone alone = practise(rig);
  rig.hold_store = true;
  rig.ask(alone.player.connection, practice());
  rig.step(Stopping{});
  EXPECT_EQ(rig.refusal(alone.player.connection, act(alone.match, 1, 1, a_break())),
            lobby::RefusalCode::unavailable);
  const ConnectionId late = rig.open();
  EXPECT_TRUE(rig.is_closing(late));
  rig.let_store_go();
  EXPECT_TRUE(rig.stopped());
}

TEST(Stop, AReportOfALoadThatComesAfterwardsIsHarmless) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const ConnectionId connection = rig.open();
  rig.hold_store = true;
  rig.ask(connection, lobby::Hello{lobby::protocol_version, "Countess", ada.token});
  rig.ask(ada.connection, lobby::List{lobby::Filter::mine, {}});
  rig.step(Stopping{});
  EXPECT_TRUE(rig.stopped());
  rig.let_store_go();
  EXPECT_EQ(rig.kept().guests.begin()->second.name, "Ada");
}

}  // namespace
}  // namespace breakshot::hub
