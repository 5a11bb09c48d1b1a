// Matches won from those who have vanished.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

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
