// A Create that is asked again with its key, since the answer was lost: one match comes of it.
#include <gtest/gtest.h>

#include <set>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

lobby::Create keyed(lobby::Create wish = eight_ball(), std::uint8_t key = 7) {
  wish.key.emplace().fill(key);
  return wish;
}

TEST(Creation, AskedAgainAfterALostAnswerIsTheSameMatch) {
  HubRig rig;
  const Player lost = meet(rig, "Ada");
  const auto first = create(rig, lost, keyed(eight_ball(true)));
  rig.close(lost.connection);
  const Player ada = again(rig, lost);
  const auto news = rig.get<lobby::MatchNews>(ada.connection, keyed(eight_ball(true)));
  EXPECT_EQ(news.info, first);
  EXPECT_TRUE(news.info.code);
  EXPECT_EQ(news.you, match::Seat{0});
  EXPECT_EQ(rig.kept().matches.size(), 1u);
  EXPECT_EQ(rig.standing(ada.connection), Standing::player);
  // It is followed on the connection that asked again.
  rig.forget(ada.connection);
  const Player bob = meet(rig, "Bob");
  rig.get<lobby::MatchNews>(bob.connection, lobby::Join{first.id, first.code, {}});
  EXPECT_EQ(rig.told<lobby::MatchNews>(ada.connection).size(), 1u);
}

TEST(Creation, AskedAgainOfAMatchThatRunsTellsItFromItsBeginning) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, keyed(practice()));
  contribute(rig, ada, info.id);
  play(rig, {ada, info.id}, 1, 2);
  rig.close(ada.connection);
  const Player back = again(rig, ada);
  EXPECT_TRUE(rig.get<lobby::MatchNews>(back.connection, keyed(practice())).header);
  EXPECT_EQ(told_entries(rig, back), up_to(3));
}

TEST(Creation, AskedAgainWhileAChangeIsBeingStoredDoesNotWait) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, keyed());
  rig.hold_store = true;
  rig.ask(bob.connection, join(info.id));
  EXPECT_EQ(create(rig, ada, keyed()), info);
  rig.let_store_go();
  EXPECT_EQ(rig.told<lobby::MatchNews>(ada.connection).back().info.seats.at(1).name, "Bob");
}

TEST(Creation, AskedAgainCountsForNoLimit) {
  Limits limits;
  limits.live_matches = 1;
  limits.live_matches_per_guest = 1;
  limits.follows_per_connection = 1;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, keyed());
  EXPECT_EQ(create(rig, ada, keyed()).id, info.id);
  EXPECT_EQ(rig.refusal(ada.connection, eight_ball()), lobby::RefusalCode::too_many);
}

TEST(Creation, AskedAgainByWhoFollowsTooMuchIsRefusedAndMayBeAskedOnceMore) {
  Limits limits;
  limits.follows_per_connection = 1;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, keyed());
  const auto other = create(rig, bob, eight_ball());
  rig.close(ada.connection);
  const Player back = again(rig, ada);
  rig.get<lobby::MatchNews>(back.connection, watch(other.id));
  EXPECT_EQ(rig.refusal(back.connection, keyed()), lobby::RefusalCode::too_many);
  rig.get<lobby::Done>(back.connection, lobby::Leave{other.id});
  EXPECT_EQ(create(rig, back, keyed()).id, info.id);
}

// ---- While the match is being stored

/// Ada, whose Create with a key is being stored; her connection has broken, and she is back on
/// another one.
Player back_while_storing(HubRig& rig) {
  const Player lost = meet(rig, "Ada");
  rig.hold_store = true;
  const ConnectionId connection = rig.open();
  rig.ask(connection, lobby::Hello{lobby::protocol_version, lost.name, lost.token});
  rig.ask(lost.connection, keyed());
  rig.store().work();  // she is looked up: the store of the tests does one after the other
  rig.close(lost.connection);
  return {connection, lost.token, lost.name};
}

TEST(Creation, AskedAgainFromANewConnectionWhileItIsBeingStoredIsAnsweredThere) {
  HubRig rig;
  const Player ada = back_while_storing(rig);
  const auto request = rig.ask(ada.connection, keyed());
  EXPECT_TRUE(rig.answers(ada.connection, request).empty());
  rig.let_store_go();
  const auto news = rig.answer<lobby::MatchNews>(ada.connection, request);
  EXPECT_EQ(news.you, match::Seat{0});
  EXPECT_TRUE(news.info.seats.at(0).present);
  EXPECT_EQ(rig.kept().matches.size(), 1u);
  EXPECT_EQ(rig.told<lobby::MatchNews>(ada.connection).size(), 1u);
}

TEST(Creation, AskedTwiceOnOneConnectionIsAnsweredTwiceWithOneMatch) {
  Limits limits;
  limits.follows_per_connection = 1;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  rig.hold_store = true;
  const auto first = rig.ask(ada.connection, keyed());
  const auto second = rig.ask(ada.connection, keyed());
  rig.let_store_go();
  const auto news = rig.answer<lobby::MatchNews>(ada.connection, first);
  EXPECT_EQ(rig.answer<lobby::MatchNews>(ada.connection, second), news);
  EXPECT_EQ(rig.kept().matches.size(), 1u);
}

TEST(Creation, AskedAgainByOneWhoIsGoneTooLeavesTheSeatAway) {
  HubRig rig;
  const Player lost = back_while_storing(rig);
  rig.ask(lost.connection, keyed());
  rig.close(lost.connection);
  rig.let_store_go();
  rig.pass(milliseconds(5000));
  const Player bob = meet(rig, "Bob");
  const auto listed = rig.get<lobby::Listing>(bob.connection, lobby::List{}).matches;
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(listed[0].seats.at(0), (lobby::SeatInfo{"Ada", false, false, 5000}));
  const Player ada = again(rig, lost);
  EXPECT_EQ(create(rig, ada, keyed()).id, listed[0].id);
}

TEST(Creation, WhatCannotBeStoredIsUnavailableToAllWhoAskedAndMayBeAskedAgain) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  rig.hold_store = true;
  const auto first = rig.ask(ada.connection, keyed());
  const auto second = rig.ask(ada.connection, keyed());
  rig.store().fail(1, "the disk is full");
  rig.let_store_go();
  for (const auto request : {first, second}) {
    EXPECT_EQ(rig.answer<lobby::Refused>(ada.connection, request).code,
              lobby::RefusalCode::unavailable);
  }
  create(rig, ada, keyed());
  EXPECT_EQ(rig.kept().matches.size(), 1u);
}

// ---- What is another match

TEST(Creation, AnotherGuestsSameKeyIsAnotherMatch) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const Player eve = meet(rig, "Eve");
  const auto info = create(rig, ada, keyed());
  rig.get<lobby::MatchNews>(bob.connection, join(info.id));
  rig.hold_store = true;
  const auto bobs = rig.ask(bob.connection, keyed());  // although Bob sits at the first
  const auto eves = rig.ask(eve.connection, keyed());  // although Bob's is being stored
  rig.let_store_go();
  EXPECT_EQ(rig.answer<lobby::MatchNews>(bob.connection, bobs).info.seats.at(0).name, "Bob");
  EXPECT_EQ(rig.answer<lobby::MatchNews>(eve.connection, eves).info.seats.at(0).name, "Eve");
  EXPECT_EQ(rig.kept().matches.size(), 3u);
}

TEST(Creation, AnotherKeyOrNoneIsAnotherMatchEachTime) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  std::set<match::MatchId> ids;
  for (const auto& wish : {keyed(), keyed(eight_ball(), 8), eight_ball(), eight_ball()}) {
    ids.insert(create(rig, ada, wish).id);
  }
  EXPECT_EQ(ids.size(), 4u);
}

TEST(Creation, TheSameKeyWithOtherSettingsIsRefused) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  rig.hold_store = true;
  rig.ask(ada.connection, keyed());
  lobby::Create longer = keyed();
  longer.race_to = 3;
  const auto others = {keyed(eight_ball(true)), keyed(practice()), longer};
  const auto expect_refusals = [&] {
    for (const auto& wish : others) {
      const auto refused = rig.get<lobby::Refused>(ada.connection, wish);
      EXPECT_EQ(refused.code, lobby::RefusalCode::bad_request);
      EXPECT_EQ(refused.what.rfind("key: ", 0), 0u) << refused.what;
    }
  };
  expect_refusals();  // while the match is being stored
  rig.let_store_go();
  expect_refusals();
  EXPECT_EQ(rig.kept().matches.size(), 1u);
}

TEST(Creation, TheKeyOfAMatchThatIsNoMoreOpensAnother) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto first = create(rig, ada, keyed(practice()));
  contribute(rig, ada, first.id);
  rig.get<lobby::EntryNews>(ada.connection, act(first.id, 1, 1, match::Concede{}));
  const auto second = create(rig, ada, keyed(practice()));
  EXPECT_NE(second.id, first.id);
  rig.get<lobby::Done>(ada.connection, lobby::Leave{second.id});
  EXPECT_NE(create(rig, ada, keyed(practice())).id, second.id);
}

TEST(Creation, WhoHasGivenUpTheSeatDoesNotComeBackByTheKey) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto first = create(rig, ada, keyed());
  rig.get<lobby::MatchNews>(bob.connection, join(first.id));
  rig.get<lobby::Done>(ada.connection, lobby::Leave{first.id});
  EXPECT_NE(create(rig, ada, keyed()).id, first.id);
}

TEST(Creation, ARestartForgetsTheKey) {
  HubRig rig;
  const Player lost = meet(rig, "Ada");
  const auto first = create(rig, lost, keyed());
  HubRig after({}, rig.kept());
  const Player ada = again(after, lost);
  after.get<lobby::Done>(ada.connection, lobby::Ping{});  // or both have the same random bytes
  EXPECT_NE(create(after, ada, keyed()).id, first.id);
  after.pass(Limits{}.gathering_expires);
  after.tick();
  EXPECT_TRUE(after.kept().matches.empty());
}

}  // namespace
}  // namespace breakshot::hub
