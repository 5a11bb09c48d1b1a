// Each command is played once, and those that come while one is stored wait their turn.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

TEST(Idempotency, ACommandSentAgainIsAnsweredWithTheSameEntry) {
  HubRig rig;
  const Alone alone = practise(rig);
  const auto command = act(alone.match, 1, 7, a_break());
  const auto first = rig.get<lobby::EntryNews>(alone.player.connection, command);
  const auto second = rig.get<lobby::EntryNews>(alone.player.connection, command);
  EXPECT_EQ(first.entry, second.entry);
  EXPECT_EQ(rig.kept().matches.at(alone.match).entries.size(), 2u);
}

TEST(Idempotency, ACommandSentAgainWhileItIsBeingStoredIsPlayedOnce) {
  HubRig rig;
  const Alone alone = practise(rig);
  rig.hold_store = true;
  const auto command = act(alone.match, 1, 7, a_break());
  const auto first = rig.ask(alone.player.connection, command);
  const auto second = rig.ask(alone.player.connection, command);
  rig.let_store_go();
  EXPECT_EQ(rig.answer<lobby::EntryNews>(alone.player.connection, first),
            rig.answer<lobby::EntryNews>(alone.player.connection, second));
  EXPECT_EQ(rig.kept().matches.at(alone.match).entries.size(), 2u);
}

TEST(Idempotency, ACommandSentAgainFromANewConnectionIsPlayedOnce) {
  HubRig rig;
  const Alone alone = practise(rig);
  rig.hold_store = true;
  const auto command = act(alone.match, 1, 7, a_break());
  rig.ask(alone.player.connection, command);
  rig.close(alone.player.connection);
  rig.let_store_go();
  const Player ada = again(rig, alone.player);
  EXPECT_EQ(rig.get<lobby::EntryNews>(ada.connection, command).entry->seq, match::Seq{1});
  EXPECT_EQ(rig.kept().matches.at(alone.match).entries.size(), 2u);
}

TEST(Idempotency, AnotherCommandAtAPlayedNumberIsLate) {
  HubRig rig;
  const Alone alone = practise(rig);
  play(rig, alone, 1, 1);
  const auto late = refused(rig, alone.player, act(alone.match, 1, 99, a_break()));
  EXPECT_EQ(late.code, lobby::RefusalCode::command);
  EXPECT_EQ(late.detail, match::RefusalCode::wrong_sequence);
}

TEST(Idempotency, TheIdOfAnotherSeatsCommandIsLate) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.get<lobby::EntryNews>(table.first.connection, act(table.match, 1, 7, a_break()));
  EXPECT_EQ(refused(rig, table.second, act(table.match, 1, 7, a_break())).detail,
            match::RefusalCode::wrong_sequence);
}

TEST(Idempotency, ACommandTooEarlyIsRefused) {
  HubRig rig;
  const Alone alone = practise(rig);
  EXPECT_EQ(refused(rig, alone.player, act(alone.match, 2, 7, a_break())).detail,
            match::RefusalCode::wrong_sequence);
}

TEST(Idempotency, AnOldCommandIsFoundInTheStore) {
  Limits limits;
  limits.recent_entries = 2;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  play(rig, alone, 1, 8);
  const std::size_t loads = rig.loads();
  const auto news =
      rig.get<lobby::EntryNews>(alone.player.connection, act(alone.match, 3, 3, a_place(3)));
  EXPECT_EQ(news.entry->seq, match::Seq{3});
  EXPECT_EQ(rig.loads(), loads + 1);
  EXPECT_EQ(refused(rig, alone.player, act(alone.match, 3, 99, a_place(3))).detail,
            match::RefusalCode::wrong_sequence);
}

TEST(Idempotency, TheLastCommandOfAFinishedMatchMayBeSentAgain) {
  HubRig rig;
  const Alone alone = practise(rig);
  const auto concede = act(alone.match, 1, 7, match::Concede{});
  rig.get<lobby::EntryNews>(alone.player.connection, concede);
  EXPECT_EQ(rig.get<lobby::EntryNews>(alone.player.connection, concede).entry->command,
            match::Command{match::Concede{}});
  EXPECT_EQ(refused(rig, alone.player, act(alone.match, 2, 8, a_break())).detail,
            match::RefusalCode::finished);
}

TEST(Idempotency, AnEntryThatCannotBeReadNowIsUnavailable) {
  HubRig rig;
  const Alone alone = practise(rig);
  const auto concede = act(alone.match, 1, 7, match::Concede{});
  rig.get<lobby::EntryNews>(alone.player.connection, concede);
  rig.hold_store = true;
  const auto request = rig.ask(alone.player.connection, concede);
  rig.store().work();  // the match is found
  rig.store().fail(1, "cannot read");
  rig.let_store_go();
  EXPECT_EQ(rig.answer<lobby::Refused>(alone.player.connection, request).code,
            lobby::RefusalCode::unavailable);
}

// ---- Commands that wait

TEST(Waiting, CommandsSentAheadArePlayedInOrder) {
  HubRig rig;
  const Alone alone = practise(rig);
  rig.hold_store = true;
  std::vector<lobby::RequestId> requests;
  for (std::uint32_t i = 1; i < 4; ++i) {
    requests.push_back(rig.ask(alone.player.connection, act(alone.match, i, i, a_place(i))));
  }
  rig.let_store_go();
  for (std::uint32_t i = 1; i < 4; ++i) {
    EXPECT_EQ(rig.answer<lobby::EntryNews>(alone.player.connection, requests[i - 1]).entry->seq,
              match::Seq{i});
  }
}

TEST(Waiting, WhenTheFirstFailsThoseBehindItAreTooEarly) {
  HubRig rig;
  const Alone alone = practise(rig);
  rig.hold_store = true;
  const auto first = rig.ask(alone.player.connection, act(alone.match, 1, 1, a_place(1)));
  const auto second = rig.ask(alone.player.connection, act(alone.match, 2, 2, a_place(2)));
  rig.store().fail(1, "the disk is full");
  rig.let_store_go();
  EXPECT_EQ(rig.answer<lobby::Refused>(alone.player.connection, first).code,
            lobby::RefusalCode::unavailable);
  EXPECT_EQ(rig.answer<lobby::Refused>(alone.player.connection, second).detail,
            match::RefusalCode::wrong_sequence);
}

TEST(Waiting, WhatWaitedForAMatchThatEndsIsAnswered) {
  HubRig rig;
  const Alone alone = practise(rig);
  rig.hold_store = true;
  rig.ask(alone.player.connection, act(alone.match, 1, 1, match::Concede{}));
  const auto shot = rig.ask(alone.player.connection, act(alone.match, 2, 2, a_break()));
  const auto claim = rig.ask(alone.player.connection, lobby::Claim{alone.match});
  rig.let_store_go();
  EXPECT_EQ(rig.answer<lobby::Refused>(alone.player.connection, shot).detail,
            match::RefusalCode::finished);
  EXPECT_EQ(rig.answer<lobby::Refused>(alone.player.connection, claim).code,
            lobby::RefusalCode::wrong_stage);
}

TEST(Waiting, WhatAClosedConnectionHadWaitingIsDropped) {
  HubRig rig;
  const Alone alone = practise(rig);
  rig.hold_store = true;
  rig.ask(alone.player.connection, act(alone.match, 1, 1, a_place(1)));
  rig.ask(alone.player.connection, act(alone.match, 2, 2, a_place(2)));
  rig.close(alone.player.connection);
  rig.let_store_go();
  EXPECT_EQ(rig.kept().matches.at(alone.match).entries.size(), 2u);
}

}  // namespace
}  // namespace breakshot::hub
