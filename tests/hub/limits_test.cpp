// Every limit of server/hub/limits.hpp is reached; one below it, all is well.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

constexpr auto too_many = lobby::RefusalCode::too_many;

TEST(Limit, Connections) {
  Limits limits;
  limits.connections = 2;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  meet(rig, "Bob");
  const ConnectionId third = rig.open();
  EXPECT_EQ(rig.told<lobby::Goodbye>(third).at(0).reason, lobby::GoodbyeReason::too_many);
  EXPECT_TRUE(rig.is_closing(third));
  rig.close(third);
  rig.close(ada.connection);
  meet(rig, "Eve");
}

TEST(Limit, AsksPerConnection) {
  Limits limits;
  limits.asks_per_connection = 3;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  rig.hold_store = true;
  std::vector<lobby::RequestId> waiting;
  for (int i = 0; i < 3; ++i) waiting.push_back(rig.ask(ada.connection, practice()));
  EXPECT_EQ(rig.refusal(ada.connection, lobby::Ping{}), too_many);
  rig.let_store_go();
  for (const auto request : waiting) rig.answer<lobby::MatchNews>(ada.connection, request);
  rig.get<lobby::Done>(ada.connection, lobby::Ping{});
}

TEST(Limit, AFetchIsAnAskUntilItsEnd) {
  Limits limits;
  limits.asks_per_connection = 1;
  limits.batch_bytes = 1;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  play(rig, alone, 1, 3);
  rig.hold_drains = true;
  rig.ask(alone.player.connection, fetch(alone.match));
  EXPECT_EQ(rig.refusal(alone.player.connection, lobby::Ping{}), too_many);
  while (rig.is_draining(alone.player.connection)) rig.drain(alone.player.connection);
  rig.get<lobby::Done>(alone.player.connection, lobby::Ping{});
}

TEST(Limit, FollowsPerConnection) {
  Limits limits;
  limits.follows_per_connection = 2;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  const Player eve = meet(rig, "Eve");
  const auto first = create(rig, ada, eight_ball());
  const auto second = create(rig, ada, eight_ball());
  EXPECT_EQ(rig.refusal(ada.connection, eight_ball()), too_many);
  const auto third = create(rig, eve, eight_ball());
  EXPECT_EQ(rig.refusal(ada.connection, watch(third.id)), too_many);
  EXPECT_EQ(rig.refusal(ada.connection, join(third.id)), too_many);
  rig.get<lobby::MatchNews>(ada.connection, watch(first.id));
  rig.get<lobby::Done>(ada.connection, lobby::Leave{second.id});
  rig.get<lobby::MatchNews>(ada.connection, watch(third.id));
}

TEST(Limit, FollowsPerConnectionCountSeatsThatAreBeingStored) {
  Limits limits;
  limits.follows_per_connection = 2;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  rig.hold_store = true;
  rig.ask(ada.connection, eight_ball());
  rig.ask(ada.connection, eight_ball());
  EXPECT_EQ(rig.refusal(ada.connection, eight_ball()), too_many);
  rig.store().fail(2, "the disk is full");
  rig.let_store_go();
  create(rig, ada, eight_ball());
  create(rig, ada, eight_ball());
}

TEST(Limit, ASeatThatCannotBeStoredLeavesRoomToFollow) {
  Limits limits;
  limits.follows_per_connection = 1;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, eight_ball());
  rig.store().fail(1, "the disk is full");
  EXPECT_EQ(rig.refusal(bob.connection, join(info.id)), lobby::RefusalCode::unavailable);
  rig.get<lobby::MatchNews>(bob.connection, join(info.id));
}

TEST(Limit, FollowsOfFinishedMatches) {
  Limits limits;
  limits.follows_per_connection = 1;
  limits.recent_entries = 1;
  limits.batch_bytes = 1;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  rig.get<lobby::EntryNews>(alone.player.connection, act(alone.match, 1, 1, match::Concede{}));
  const Player eve = meet(rig, "Eve");
  create(rig, eve, eight_ball());
  EXPECT_EQ(rig.refusal(eve.connection, watch(alone.match)), too_many);
}

TEST(Limit, WrongCodesPerConnection) {
  Limits limits;
  limits.wrong_codes_per_connection = 3;
  HubRig rig(limits);
  const Player eve = meet(rig, "Eve");
  const lobby::Watch wrong{std::nullopt, "0000000000", {}};
  const lobby::Watch no_code{std::nullopt, "?", {}};
  const auto none = lobby::RefusalCode::no_such_match;
  EXPECT_EQ(rig.refusal(eve.connection, wrong), none);
  EXPECT_EQ(rig.refusal(eve.connection, no_code), none);
  EXPECT_EQ(rig.refusal(eve.connection, watch(match::MatchId{1})), none);
  EXPECT_FALSE(rig.is_closing(eve.connection));
  EXPECT_EQ(rig.refusal(eve.connection, wrong), none);
  EXPECT_TRUE(rig.is_closing(eve.connection));
}

TEST(Limit, LiveMatches) {
  Limits limits;
  limits.live_matches = 2;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  const Player eve = meet(rig, "Eve");
  rig.hold_store = true;
  const auto second = rig.ask(eve.connection, eight_ball());
  EXPECT_EQ(rig.refusal(eve.connection, eight_ball()), too_many) << "one is being stored";
  rig.let_store_go();
  rig.answer<lobby::MatchNews>(eve.connection, second);
  EXPECT_EQ(rig.refusal(eve.connection, eight_ball()), too_many);
  rig.get<lobby::EntryNews>(alone.player.connection, act(alone.match, 1, 1, match::Concede{}));
  create(rig, eve, eight_ball());
}

TEST(Limit, LiveMatchesPerGuest) {
  Limits limits;
  limits.live_matches_per_guest = 2;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  const Player eve = meet(rig, "Eve");
  const auto first = create(rig, ada, eight_ball());
  const auto second = create(rig, ada, eight_ball());
  EXPECT_EQ(rig.refusal(ada.connection, eight_ball()), too_many);
  const auto other = create(rig, eve, eight_ball());
  EXPECT_EQ(rig.refusal(ada.connection, join(other.id)), too_many);
  rig.get<lobby::MatchNews>(ada.connection, join(first.id));  // one's own seat
  rig.get<lobby::Done>(ada.connection, lobby::Leave{second.id});
  rig.get<lobby::MatchNews>(ada.connection, join(other.id));
}

TEST(Limit, LiveMatchesPerGuestCountThoseThatAreBeingStored) {
  Limits limits;
  limits.live_matches_per_guest = 2;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  const Player eve = meet(rig, "Eve");
  const auto open = create(rig, eve, eight_ball());
  const auto other = create(rig, eve, eight_ball());
  rig.hold_store = true;
  rig.ask(ada.connection, eight_ball());
  rig.ask(ada.connection, join(open.id));
  EXPECT_EQ(rig.refusal(ada.connection, join(other.id)), too_many);
}

TEST(Limit, APracticeThatOneHasLeftDoesNotCount) {
  Limits limits;
  limits.live_matches_per_guest = 1;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  const Player eve = meet(rig, "Eve");
  const auto info = create(rig, ada, practice(2));
  rig.get<lobby::MatchNews>(eve.connection, join(info.id));
  contribute(rig, ada, info.id);
  contribute(rig, eve, info.id);
  rig.get<lobby::EntryNews>(ada.connection, act(info.id, 1, 1, match::Concede{}));
  create(rig, ada, practice());
}

TEST(Limit, SpectatorsPerMatch) {
  Limits limits;
  limits.spectators_per_match = 2;
  HubRig rig(limits);
  const Table table = sit_down(rig);
  const Player one = meet(rig, "One");
  const Player two = meet(rig, "Two");
  const Player three = meet(rig, "Three");
  rig.get<lobby::MatchNews>(one.connection, watch(table.match));
  rig.get<lobby::MatchNews>(two.connection, watch(table.match));
  EXPECT_EQ(rig.refusal(three.connection, watch(table.match)), too_many);
  rig.get<lobby::MatchNews>(one.connection, watch(table.match));  // again
  rig.get<lobby::MatchNews>(table.first.connection, watch(table.match));
  rig.close(one.connection);
  rig.get<lobby::MatchNews>(three.connection, watch(table.match));
}

TEST(Limit, EntriesPerMatch) {
  Limits limits;
  limits.entries_per_match = 4;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  play(rig, alone, 1, 3);
  EXPECT_EQ(rig.refusal(alone.player.connection, act(alone.match, 4, 4, a_place(4))), too_many);
  rig.get<lobby::EntryNews>(alone.player.connection, act(alone.match, 4, 5, match::Concede{}));
}

TEST(Limit, AsksPerMatch) {
  Limits limits;
  limits.asks_per_match = 2;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  rig.hold_store = true;
  for (std::uint32_t i = 1; i < 4; ++i) {
    rig.ask(alone.player.connection, act(alone.match, i, i, a_place(i)));
  }
  EXPECT_EQ(rig.refusal(alone.player.connection, act(alone.match, 4, 4, a_place(4))), too_many);
  EXPECT_EQ(rig.refusal(alone.player.connection, join(alone.match)), too_many);
  rig.let_store_go();
  EXPECT_EQ(told_entries(rig, alone.player), up_to(4));
}

TEST(Limit, RecentEntriesAreServedFromMemoryAndOlderOnesAreLoaded) {
  Limits limits;
  limits.recent_entries = 3;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  play(rig, alone, 1, 9);
  const Player eve = meet(rig, "Eve");
  const std::size_t before = rig.loads();
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match, 7));
  EXPECT_EQ(rig.loads(), before);
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match, 6));
  EXPECT_EQ(rig.loads(), before + 1);
}

TEST(Limit, ABatchEndsAtTheFirstEntryBeyondItsBytes) {
  Limits limits;
  limits.batch_bytes = 1;
  HubRig rig(limits);
  const Alone alone = practise(rig);
  play(rig, alone, 1, 3);
  const Player eve = meet(rig, "Eve");
  rig.hold_drains = true;
  rig.get<lobby::MatchNews>(eve.connection, watch(alone.match));
  for (std::uint32_t told = 1; told < 4; ++told) {
    EXPECT_EQ(told_entries(rig, eve), up_to(told));
    rig.drain(eve.connection);
  }
  EXPECT_EQ(told_entries(rig, eve), up_to(4));
}

}  // namespace
}  // namespace breakshot::hub
