// Until a match starts: create, join, contribute, leave.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

TEST(Seating, AMatchIsToldOnlyWhenItIsStored) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  rig.hold_store = true;
  const auto request = rig.ask(ada.connection, eight_ball());
  EXPECT_TRUE(rig.answers(ada.connection, request).empty());
  rig.let_store_go();
  const auto news = rig.answer<lobby::MatchNews>(ada.connection, request);
  EXPECT_EQ(news.you, match::Seat{0});
  EXPECT_EQ(news.info.stage, match::Stage::gathering);
  EXPECT_FALSE(news.header);
  EXPECT_EQ(news.info.seats.at(0), (lobby::SeatInfo{"Ada", false, true, 0}));
  EXPECT_EQ(news.info.seats.at(1), lobby::SeatInfo{});
  EXPECT_FALSE(news.info.code);
}

TEST(Seating, AMatchThatCannotBeStoredDoesNotExist) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  rig.store().fail(1, "the disk is full");
  EXPECT_EQ(rig.refusal(ada.connection, eight_ball()), lobby::RefusalCode::unavailable);
  EXPECT_TRUE(rig.get<lobby::Listing>(ada.connection, lobby::List{}).matches.empty());
}

TEST(Seating, TheCommitmentIsPublishedBeforeAnyoneContributes) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, eight_ball());
  const auto& kept = rig.kept().matches.at(info.id);
  EXPECT_EQ(info.commitment, match::commitment_of(kept.secret));
  EXPECT_NE(kept.secret, match::Secret{});
}

TEST(Seating, BadSettingsAreRefusedByName) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  lobby::Create unknown = eight_ball();
  unknown.preset = "billiard room";
  const auto refused = rig.get<lobby::Refused>(ada.connection, unknown);
  EXPECT_EQ(refused.code, lobby::RefusalCode::bad_request);
  EXPECT_EQ(refused.what.rfind("preset: ", 0), 0u) << refused.what;
  for (const auto& [seats, race_to] : {std::pair<int, int>{3, 1}, {2, 0}, {2, 101}, {0, 1}}) {
    lobby::Create wish = eight_ball();
    wish.seats = static_cast<std::uint8_t>(seats);
    wish.race_to = static_cast<std::uint32_t>(race_to);
    EXPECT_EQ(rig.refusal(ada.connection, wish), lobby::RefusalCode::bad_request)
        << seats << " " << race_to;
  }
}

TEST(Seating, PracticeHasOneToEightSeats) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  EXPECT_EQ(create(rig, ada, practice(match::max_practice_seats)).seats.size(), 8u);
  EXPECT_EQ(rig.refusal(ada.connection, practice(match::max_practice_seats + 1)),
            lobby::RefusalCode::bad_request);
}

TEST(Seating, JoiningTakesTheFreeSeatAndTellsTheOthers) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, eight_ball());
  rig.forget(ada.connection);
  const auto news = rig.get<lobby::MatchNews>(bob.connection, join(info.id));
  EXPECT_EQ(news.you, match::Seat{1});
  EXPECT_EQ(news.info.seats.at(1), (lobby::SeatInfo{"Bob", false, true, 0}));
  const auto told = rig.told<lobby::MatchNews>(ada.connection);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].you, match::Seat{0});
  EXPECT_EQ(told[0].info.seats, news.info.seats);
}

TEST(Seating, ASeatIsTakenOnlyWhenItIsStored) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, eight_ball());
  rig.store().fail(1, "the disk is full");
  EXPECT_EQ(rig.refusal(bob.connection, join(info.id)), lobby::RefusalCode::unavailable);
  const auto listed = rig.get<lobby::Listing>(ada.connection, lobby::List{}).matches.at(0);
  EXPECT_EQ(listed.seats.at(1).name, "");
}

TEST(Seating, OfTwoWhoJoinAtOnceOneGetsTheSeat) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const Player eve = meet(rig, "Eve");
  const auto info = create(rig, ada, eight_ball());
  rig.hold_store = true;
  const auto first = rig.ask(bob.connection, join(info.id));
  const auto second = rig.ask(eve.connection, join(info.id));
  rig.let_store_go();
  EXPECT_EQ(rig.answer<lobby::MatchNews>(bob.connection, first).you, match::Seat{1});
  EXPECT_EQ(rig.answer<lobby::Refused>(eve.connection, second).code,
            lobby::RefusalCode::match_full);
}

TEST(Seating, JoiningAgainComesBackToTheSame) {
  HubRig rig;
  const Table table = sit_down(rig);
  const auto news = rig.get<lobby::MatchNews>(table.second.connection, join(table.match));
  EXPECT_EQ(news.you, match::Seat{1});
  EXPECT_TRUE(news.header);
}

TEST(Seating, ARunningMatchIsFull) {
  HubRig rig;
  const Table table = sit_down(rig);
  const Player eve = meet(rig, "Eve");
  EXPECT_EQ(rig.refusal(eve.connection, join(table.match)), lobby::RefusalCode::match_full);
}

TEST(Seating, TheLastContributionStartsTheMatch) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, eight_ball());
  contribute(rig, ada, info.id, 1);
  rig.get<lobby::MatchNews>(bob.connection, join(info.id));
  rig.forget(ada.connection);
  contribute(rig, bob, info.id, 2);
  const auto news = rig.told<lobby::MatchNews>(ada.connection).back();
  EXPECT_EQ(news.info.stage, match::Stage::running);
  ASSERT_TRUE(news.header);
  EXPECT_EQ(news.header->players.at(0), (record::Player{"Ada", share(1)}));
  EXPECT_EQ(news.header->players.at(1), (record::Player{"Bob", share(2)}));
  EXPECT_EQ(news.header->commitment, info.commitment);
  for (const Player& player : {ada, bob}) {
    const auto entries = rig.told<lobby::EntryNews>(player.connection);
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].entry->command, match::Command{match::Start{}});
    EXPECT_EQ(entries[0].entry->digest,
              record::digest_of(record::digest_of(*news.header), *entries[0].entry));
  }
}

TEST(Seating, AStartThatCannotBeStoredIsNotAnnouncedAndMayBeTriedAgain) {
  HubRig rig;
  const Alone alone{meet(rig, "Ada"), {}};
  const auto info = create(rig, alone.player, practice());
  rig.store().fail(1, "the disk is full");
  EXPECT_EQ(rig.refusal(alone.player.connection, lobby::Contribute{info.id, share(1)}),
            lobby::RefusalCode::unavailable);
  EXPECT_TRUE(rig.told<lobby::EntryNews>(alone.player.connection).empty());
  contribute(rig, alone.player, info.id, 2);
  EXPECT_EQ(told_entries(rig, alone.player), up_to(1));
}

TEST(Seating, ContributingTheSameAgainIsDoneAndAnotherIsRefused) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, eight_ball());
  contribute(rig, ada, info.id, 1);
  contribute(rig, ada, info.id, 1);
  EXPECT_EQ(rig.refusal(ada.connection, lobby::Contribute{info.id, share(2)}),
            lobby::RefusalCode::wrong_stage);
}

TEST(Seating, OnlyThoseWhoSitContribute) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player eve = meet(rig, "Eve");
  const auto info = create(rig, ada, eight_ball());
  EXPECT_EQ(rig.refusal(eve.connection, lobby::Contribute{info.id, share(1)}),
            lobby::RefusalCode::not_seated);
}

TEST(Seating, ContributionsAreSecretUntilTheStart) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto info = create(rig, ada, eight_ball());
  contribute(rig, ada, info.id);
  const auto news = rig.get<lobby::MatchNews>(ada.connection, watch(info.id));
  EXPECT_TRUE(news.info.seats.at(0).contributed);
  EXPECT_FALSE(news.header);
}

TEST(Seating, LeavingBeforeTheStartGivesUpTheSeat) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const Player eve = meet(rig, "Eve");
  const auto info = create(rig, ada, eight_ball());
  rig.get<lobby::MatchNews>(bob.connection, join(info.id));
  rig.forget(ada.connection);
  rig.get<lobby::Done>(bob.connection, lobby::Leave{info.id});
  EXPECT_EQ(rig.told<lobby::MatchNews>(ada.connection).back().info.seats.at(1), lobby::SeatInfo{});
  EXPECT_EQ(rig.get<lobby::MatchNews>(eve.connection, join(info.id)).you, match::Seat{1});
}

TEST(Seating, AMatchThatEveryoneHasLeftIsGone) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player eve = meet(rig, "Eve");
  const auto info = create(rig, ada, eight_ball());
  rig.get<lobby::MatchNews>(eve.connection, watch(info.id));
  rig.get<lobby::Done>(ada.connection, lobby::Leave{info.id});
  EXPECT_EQ(rig.told<lobby::MatchGone>(eve.connection).at(0).match, info.id);
  EXPECT_TRUE(rig.told<lobby::MatchGone>(ada.connection).empty());
  EXPECT_FALSE(rig.kept().matches.contains(info.id));
  EXPECT_EQ(rig.refusal(eve.connection, watch(info.id)), lobby::RefusalCode::no_such_match);
}

TEST(Seating, LeavingARunningMatchKeepsTheSeat) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.get<lobby::Done>(table.second.connection, lobby::Leave{table.match});
  EXPECT_FALSE(rig.told<lobby::MatchNews>(table.first.connection).back().info.seats.at(1).present);
  EXPECT_EQ(rig.get<lobby::MatchNews>(table.second.connection, join(table.match)).you,
            match::Seat{1});
}

TEST(Seating, LeavingWhatOneDoesNotFollowIsDone) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  rig.get<lobby::Done>(ada.connection, lobby::Leave{match::MatchId{4711}});
}

TEST(Seating, OthersAreToldWhoIsPresent) {
  HubRig rig;
  const Table table = sit_down(rig);
  rig.forget(table.first.connection);
  rig.close(table.second.connection);
  EXPECT_FALSE(rig.told<lobby::MatchNews>(table.first.connection).back().info.seats.at(1).present);
  rig.pass(milliseconds(5000));
  const auto news = rig.get<lobby::MatchNews>(table.first.connection, watch(table.match));
  EXPECT_EQ(news.info.seats.at(1).away_ms, 5000);
  const Player bob = again(rig, table.second);
  EXPECT_FALSE(rig.told<lobby::MatchNews>(table.first.connection).back().info.seats.at(1).present);
  rig.get<lobby::MatchNews>(bob.connection, join(table.match));
  EXPECT_TRUE(rig.told<lobby::MatchNews>(table.first.connection).back().info.seats.at(1).present);
}

}  // namespace
}  // namespace breakshot::hub
