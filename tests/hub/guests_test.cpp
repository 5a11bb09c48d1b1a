// Who is who: hello, tokens, taking over, going.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

lobby::Hello hello(const std::string& name, const std::optional<lobby::Token>& token = {}) {
  return {lobby::protocol_version, name, token};
}

TEST(Guests, ANewGuestIsToldATokenOnceAndTheStoreKeepsOnlyItsHash) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  ASSERT_EQ(rig.kept().guests.size(), 1u);
  EXPECT_EQ(rig.kept().guests.begin()->first.token_hash, hash::sha256(ada.token));
  EXPECT_EQ(rig.kept().guests.begin()->second.name, "Ada");
  const ConnectionId connection = rig.open();
  const auto welcome = rig.get<lobby::Welcome>(connection, hello("Ada", ada.token));
  EXPECT_FALSE(welcome.token);
}

TEST(Guests, TokensOfTwoGuestsDiffer) {
  HubRig rig;
  EXPECT_NE(meet(rig, "Ada").token, meet(rig, "Ada").token);
}

TEST(Guests, NobodyIsWelcomedBeforeTheGuestIsStored) {
  HubRig rig;
  rig.hold_store = true;
  const ConnectionId connection = rig.open();
  const auto request = rig.ask(connection, hello("Ada"));
  EXPECT_TRUE(rig.inbox(connection).empty());
  rig.let_store_go();
  EXPECT_TRUE(rig.answer<lobby::Welcome>(connection, request).token);
}

TEST(Guests, AGuestThatCannotBeStoredMayAskAgain) {
  HubRig rig;
  const ConnectionId connection = rig.open();
  rig.store().fail(1, "the disk is full");
  EXPECT_EQ(rig.refusal(connection, hello("Ada")), lobby::RefusalCode::unavailable);
  EXPECT_EQ(rig.notes<StoreRefused>().at(0).why, "the disk is full");
  EXPECT_TRUE(rig.get<lobby::Welcome>(connection, hello("Ada")).token);
}

TEST(Guests, ATokenThatCannotBeLookedUpIsNotUnknown) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const ConnectionId connection = rig.open();
  rig.store().fail(1, "cannot read");
  EXPECT_EQ(rig.refusal(connection, hello("Ada", ada.token)), lobby::RefusalCode::unavailable);
}

TEST(Guests, AnUnknownTokenIsRefusedAndTheConnectionMayBecomeANewGuest) {
  HubRig rig;
  const ConnectionId connection = rig.open();
  EXPECT_EQ(rig.refusal(connection, hello("Ada", lobby::Token{})),
            lobby::RefusalCode::unknown_token);
  EXPECT_TRUE(rig.get<lobby::Welcome>(connection, hello("Ada")).token);
}

TEST(Guests, AGuestIsKnownAfterARestart) {
  HubRig before;
  const Player ada = meet(before, "Ada");
  HubRig after({}, before.kept());
  EXPECT_EQ(after.get<lobby::Welcome>(after.open(), hello("Ada", ada.token)).name, "Ada");
}

TEST(Guests, ANewNameIsStoredBeforeItIsTold) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  rig.hold_store = true;
  const ConnectionId connection = rig.open();
  const auto request = rig.ask(connection, hello("Countess", ada.token));
  rig.store().work();  // the look-up
  EXPECT_TRUE(rig.inbox(connection).empty());
  rig.let_store_go();
  EXPECT_EQ(rig.answer<lobby::Welcome>(connection, request).name, "Countess");
  EXPECT_EQ(rig.kept().guests.begin()->second.name, "Countess");
}

TEST(Guests, ABadNameIsRefused) {
  HubRig rig;
  const ConnectionId connection = rig.open();
  for (const std::string name : {"", " Ada", "A\nda", "\xff"}) {
    EXPECT_EQ(rig.refusal(connection, hello(name)), lobby::RefusalCode::bad_request) << name;
  }
}

TEST(Guests, AnotherVersionOfTheProtocolIsToldGoodbye) {
  HubRig rig;
  const ConnectionId connection = rig.open();
  const auto request = rig.ask(connection, lobby::Hello{99, "Ada", {}});
  EXPECT_EQ(rig.answer<lobby::Refused>(connection, request).code,
            lobby::RefusalCode::unsupported_version);
  EXPECT_EQ(rig.told<lobby::Goodbye>(connection).at(0).reason, lobby::GoodbyeReason::bad_protocol);
  EXPECT_TRUE(rig.is_closing(connection));
}

TEST(Guests, EverythingButHelloAndPingNeedsAHelloFirst) {
  HubRig rig;
  const ConnectionId connection = rig.open();
  const match::MatchId match{1};
  const lobby::Request requests[] = {eight_ball(),
                                     join(match),
                                     watch(match),
                                     lobby::List{},
                                     fetch(match),
                                     lobby::Contribute{match, {}},
                                     act(match, 0, 1, a_break()),
                                     lobby::Claim{match},
                                     lobby::Leave{match}};
  for (const lobby::Request& request : requests) {
    EXPECT_EQ(rig.refusal(connection, request), lobby::RefusalCode::hello_first) << request.index();
  }
  rig.get<lobby::Done>(connection, lobby::Ping{});
}

TEST(Guests, AConnectionSaysHelloOnlyOnce) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  EXPECT_EQ(rig.refusal(ada.connection, hello("Bob")), lobby::RefusalCode::bad_request);
}

TEST(Guests, ASecondHelloWhileTheFirstIsBeingStoredIsRefused) {
  HubRig rig;
  rig.hold_store = true;
  const ConnectionId connection = rig.open();
  rig.ask(connection, hello("Ada"));
  EXPECT_EQ(rig.refusal(connection, hello("Bob")), lobby::RefusalCode::bad_request);
}

TEST(Guests, TheSameTokenOnANewConnectionTakesOver) {
  HubRig rig;
  const Table table = sit_down(rig);
  const Player ada = again(rig, table.first);
  EXPECT_EQ(rig.told<lobby::Goodbye>(table.first.connection).at(0).reason,
            lobby::GoodbyeReason::taken_over);
  EXPECT_TRUE(rig.is_closing(table.first.connection));
  rig.get<lobby::MatchNews>(ada.connection, join(table.match));
  rig.get<lobby::EntryNews>(ada.connection, act(table.match, 1, 7, a_break()));
}

TEST(Guests, WhatTheOldConnectionStillAsksIsIgnored) {
  HubRig rig;
  const Table table = sit_down(rig);
  again(rig, table.first);
  rig.ask(table.first.connection, act(table.match, 1, 7, a_break()));
  EXPECT_EQ(rig.kept().matches.at(table.match).entries.size(), 1u);
  rig.close(table.first.connection);
}

TEST(Guests, StandingGrowsWithHelloAndWithASeat) {
  HubRig rig;
  const ConnectionId connection = rig.open();
  EXPECT_EQ(rig.standing(connection), Standing::stranger);
  rig.get<lobby::Welcome>(connection, hello("Ada"));
  EXPECT_EQ(rig.standing(connection), Standing::guest);
  const auto info = rig.get<lobby::MatchNews>(connection, practice()).info;
  EXPECT_EQ(rig.standing(connection), Standing::player);
  rig.get<lobby::Done>(connection, lobby::Contribute{info.id, {}});
  rig.get<lobby::EntryNews>(connection, act(info.id, 1, 1, match::Concede{}));
  EXPECT_EQ(rig.standing(connection), Standing::guest);
}

TEST(Guests, AConnectionThatIsGoneIsToldNothing) {
  HubRig rig;
  rig.hold_store = true;
  const ConnectionId connection = rig.open();
  rig.ask(connection, hello("Ada"));
  rig.close(connection);
  rig.let_store_go();
  EXPECT_TRUE(rig.inbox(connection).empty());
}

}  // namespace
}  // namespace breakshot::hub
