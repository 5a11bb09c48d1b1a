// Whole records, as they stand.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

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
