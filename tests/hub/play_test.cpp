// A match that runs: store before announce, each command once, claims, the end.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

lobby::Refused refused(HubRig& rig, const Player& player, lobby::Request request) {
  return rig.get<lobby::Refused>(player.connection, std::move(request));
}

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

// ---- Each command once

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

// ---- Claims

TEST(Claim, AMatchIsWonFromAnOpponentWhoHasVanishedForLongEnough) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.close(table.second.connection);
  rig.pass(Limits{}.claim_after - milliseconds(1));
  EXPECT_EQ(refused(rig, table.first, lobby::Claim{table.match}).code,
            lobby::RefusalCode::too_early);
  rig.pass(milliseconds(1));
  const auto news = rig.get<lobby::EntryNews>(table.first.connection, lobby::Claim{table.match});
  EXPECT_EQ(news.entry->command, match::Command{match::Abandoned{match::Seat{1}}});
  EXPECT_FALSE(news.entry->author.seat);
  EXPECT_EQ(news.entry->outcome.status.winner, match::Seat{0});
  EXPECT_TRUE(news.entry->secret);
}

TEST(Claim, NothingIsWonFromAnOpponentWhoIsPresent) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.pass(Limits{}.claim_after * 2);
  EXPECT_EQ(refused(rig, table.first, lobby::Claim{table.match}).code,
            lobby::RefusalCode::too_early);
}

TEST(Claim, ComingBackStartsTheTimeAnew) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.close(table.second.connection);
  rig.pass(Limits{}.claim_after - milliseconds(1));
  const Player bob = again(rig, table.second);
  rig.get<lobby::MatchNews>(bob.connection, join(table.match));
  rig.close(bob.connection);
  rig.pass(milliseconds(1));
  EXPECT_EQ(refused(rig, table.first, lobby::Claim{table.match}).code,
            lobby::RefusalCode::too_early);
}

TEST(Claim, AClaimThatCannotBeStoredMayBeMadeAgain) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.close(table.second.connection);
  rig.pass(Limits{}.claim_after);
  rig.store().fail(1, "the disk is full");
  EXPECT_EQ(refused(rig, table.first, lobby::Claim{table.match}).code,
            lobby::RefusalCode::unavailable);
  rig.get<lobby::EntryNews>(table.first.connection, lobby::Claim{table.match});
}

TEST(Claim, OnlyThoseWhoSitClaim) {
  HubRig rig;
  const Table table = sit_down(rig);
  const Player eve = meet(rig, "Eve");
  rig.close(table.second.connection);
  rig.pass(Limits{}.claim_after);
  EXPECT_EQ(refused(rig, eve, lobby::Claim{table.match}).code, lobby::RefusalCode::not_seated);
}

TEST(Claim, AMatchThatHasNotStartedCannotBeClaimed) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, eight_ball());
  EXPECT_EQ(refused(rig, ada, lobby::Claim{info.id}).code, lobby::RefusalCode::wrong_stage);
}

TEST(Claim, InPracticeTheOneLongestAwayLeavesAndTheRestGoOn) {
  HubRig rig;
  const Player players[] = {meet(rig, "Ada"), meet(rig, "Bob"), meet(rig, "Eve")};
  const auto info = create(rig, players[0], practice(3));
  for (const Player& player : players) {
    rig.get<lobby::MatchNews>(player.connection, join(info.id));
    contribute(rig, player, info.id);
  }
  rig.close(players[2].connection);
  rig.pass(milliseconds(1));
  rig.close(players[1].connection);
  rig.pass(Limits{}.claim_after);
  const auto claim = [&] {
    return rig.get<lobby::EntryNews>(players[0].connection, lobby::Claim{info.id}).entry->command;
  };
  EXPECT_EQ(claim(), match::Command{match::Abandoned{match::Seat{2}}});
  EXPECT_EQ(claim(), match::Command{match::Abandoned{match::Seat{1}}});
  EXPECT_EQ(refused(rig, players[0], lobby::Claim{info.id}).code, lobby::RefusalCode::too_early);
}

}  // namespace
}  // namespace breakshot::hub
