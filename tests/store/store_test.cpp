// What any store must do: the one in SQLite, and the one in memory that other tests rely on.
#include <gtest/gtest.h>

#include <functional>

#include "tests/store/shelf.hpp"

namespace breakshot::store {
namespace {

struct Kind {
  const char* name;
  std::unique_ptr<Shelf> (*make)();
};

class AnyStore : public testing::TestWithParam<Kind> {
 protected:
  std::unique_ptr<Shelf> shelf = GetParam().make();

  void keep(const Story& story) {
    for (const ledger::Batch& batch : story.batches) ASSERT_EQ(shelf->put(batch), std::nullopt);
  }
};

INSTANTIATE_TEST_SUITE_P(
    Stores, AnyStore,
    testing::Values(
        Kind{"Sqlite", []() -> std::unique_ptr<Shelf> { return std::make_unique<SqliteShelf>(); }},
        Kind{"Memory", []() -> std::unique_ptr<Shelf> { return std::make_unique<MemoryShelf>(); }}),
    [](const auto& kind) { return kind.param.name; });

TEST_P(AnyStore, KeepsGuestsAndTheirLatestName) {
  ASSERT_FALSE(shelf->put({ledger::PutGuest{{guest(1), "Ada"}}}));
  ASSERT_FALSE(shelf->put({ledger::PutGuest{{guest(2), "Bob"}}}));
  ASSERT_FALSE(shelf->put({ledger::PutGuest{{guest(1), "Countess"}}}));
  shelf->reopen();
  const auto find = [&](std::uint8_t number) {
    return shelf->find<ledger::FoundGuest>(ledger::FindGuest{guest(number)}).guest;
  };
  EXPECT_EQ(find(1), (ledger::Guest{guest(1), "Countess"}));
  EXPECT_EQ(find(2), (ledger::Guest{guest(2), "Bob"}));
  EXPECT_EQ(find(3), std::nullopt);
}

TEST_P(AnyStore, GivesBackTheRowOfAnOpenMatch) {
  ledger::MatchRow row = open_match(0xfedcba9876543210);
  row.code = "0123456789";
  row.seats[1] = ledger::Sitter{guest(2), "Bób", secret(3)};
  ASSERT_FALSE(shelf->put({ledger::CreateMatch{row, secret(1)}}));
  shelf->reopen();
  EXPECT_EQ(shelf->row(row.id), row);
}

TEST_P(AnyStore, FindsAMatchByIdAndByCode) {
  ledger::MatchRow row = open_match(1);
  row.code = "0123456789";
  ASSERT_FALSE(shelf->put({ledger::CreateMatch{row, secret(1)}}));
  ASSERT_FALSE(shelf->put({ledger::CreateMatch{open_match(2), secret(1)}}));
  using Id = std::optional<match::MatchId>;
  using Code = std::optional<std::string>;
  const auto finds = [&](const Id& id, const Code& code) {
    const auto found = shelf->find<ledger::FoundMatch>(ledger::FindMatch{id, code}).row;
    return found ? Id(found->id) : std::nullopt;
  };
  EXPECT_EQ(finds(match::MatchId{1}, {}), match::MatchId{1});
  EXPECT_EQ(finds({}, "0123456789"), match::MatchId{1});
  EXPECT_EQ(finds(match::MatchId{1}, "0123456789"), match::MatchId{1});
  EXPECT_EQ(finds(match::MatchId{2}, "0123456789"), std::nullopt);
  EXPECT_EQ(finds(match::MatchId{1}, "9999999999"), std::nullopt);
  EXPECT_EQ(finds(match::MatchId{3}, {}), std::nullopt);
  EXPECT_EQ(finds({}, {}), std::nullopt);
}

TEST_P(AnyStore, KeepsAWholeMatch) {
  const Story whole = story(5, 6, true);
  keep(whole);
  shelf->reopen();
  EXPECT_EQ(shelf->row(whole.row.id), whole.row);
  const auto found = shelf->find<ledger::FoundEntries>(
      ledger::FindEntries{whole.row.id, match::Seq{0}, std::size_t{1} << 30});
  EXPECT_TRUE(same(found.entries, whole.entries));
  EXPECT_TRUE(shelf->restored().empty());
}

TEST_P(AnyStore, SeatsChangeUntilTheStart) {
  const ledger::MatchRow row = open_match(1);
  ASSERT_FALSE(shelf->put({ledger::CreateMatch{row, secret(1)}}));
  const ledger::Seats seats = {std::nullopt, ledger::Sitter{guest(2), "Bob", secret(2)}};
  ASSERT_FALSE(shelf->put({ledger::PutSeats{row.id, seats}}));
  EXPECT_EQ(shelf->row(row.id)->seats, seats);
  const Story begun = story(2, 0, false);
  keep(begun);
  EXPECT_TRUE(shelf->put({ledger::PutSeats{begun.row.id, {std::nullopt}}}));
  EXPECT_EQ(shelf->row(begun.row.id)->seats, begun.row.seats);
  EXPECT_TRUE(shelf->put({ledger::PutSeats{match::MatchId{99}, seats}}));
}

TEST_P(AnyStore, OnlyTheNextEntryOfAStartedMatchIsAppended) {
  const Story begun = story(1, 3, false);
  keep(begun);
  const auto next = [&](std::uint32_t seq) {
    record::Entry entry = *begun.entries[1];
    entry.seq = match::Seq{seq};
    return ledger::AppendEntry{begun.row.id, std::make_shared<const record::Entry>(entry)};
  };
  EXPECT_TRUE(shelf->put({next(3)})) << "there is one";
  EXPECT_TRUE(shelf->put({next(5)})) << "one is missing";
  EXPECT_FALSE(shelf->put({next(4)}));
  ASSERT_FALSE(shelf->put({ledger::CreateMatch{open_match(2), secret(1)}}));
  EXPECT_TRUE(shelf->put({ledger::AppendEntry{match::MatchId{2}, begun.entries[0]}}))
      << "it has no header";
  EXPECT_TRUE(shelf->put({ledger::AppendEntry{match::MatchId{3}, begun.entries[0]}}));
  EXPECT_EQ(shelf->row(begun.row.id)->progress.next, match::Seq{5});
}

TEST_P(AnyStore, AMatchStartsOnce) {
  const Story begun = story(1, 0, false);
  keep(begun);
  EXPECT_TRUE(shelf->put({ledger::PutHeader{*begun.row.header}}));
}

TEST_P(AnyStore, IdsAndCodesAreUnique) {
  ledger::MatchRow row = open_match(1);
  row.code = "0123456789";
  ASSERT_FALSE(shelf->put({ledger::CreateMatch{row, secret(1)}}));
  EXPECT_TRUE(shelf->put({ledger::CreateMatch{open_match(1), secret(2)}}));
  row.id = match::MatchId{2};
  EXPECT_TRUE(shelf->put({ledger::CreateMatch{row, secret(2)}}));
  EXPECT_FALSE(shelf->put({ledger::CreateMatch{open_match(2), secret(2)}}));
  EXPECT_FALSE(shelf->put({ledger::CreateMatch{open_match(3), secret(2)}}));
}

TEST_P(AnyStore, OnlyAMatchThatHasNotStartedIsDiscarded) {
  const Story begun = story(1, 0, false);
  keep(begun);
  ledger::MatchRow row = open_match(2);
  row.code = "0123456789";
  ASSERT_FALSE(shelf->put({ledger::CreateMatch{row, secret(1)}}));
  EXPECT_TRUE(shelf->put({ledger::DiscardMatch{begun.row.id}}));
  EXPECT_FALSE(shelf->put({ledger::DiscardMatch{row.id}}));
  EXPECT_TRUE(shelf->put({ledger::DiscardMatch{row.id}}));
  EXPECT_EQ(shelf->row(row.id), std::nullopt);
  EXPECT_FALSE(shelf->put({ledger::CreateMatch{row, secret(1)}})) << "nothing of it is left";
}

// ---- Batches

TEST_P(AnyStore, ABatchThatFailsLeavesNothingBehind) {
  const ledger::MatchRow row = open_match(1);
  EXPECT_TRUE(shelf->put({ledger::PutGuest{{guest(1), "Ada"}}, ledger::CreateMatch{row, secret(1)},
                          ledger::DiscardMatch{match::MatchId{99}}}));
  EXPECT_FALSE(shelf->find<ledger::FoundGuest>(ledger::FindGuest{guest(1)}).guest);
  EXPECT_FALSE(shelf->row(row.id));
}

TEST_P(AnyStore, ABatchThatFailsDoesNotHinderOthersAndReportsKeepTheOrder) {
  constexpr std::uint64_t batches = 60;
  std::vector<bool> good;
  for (std::uint64_t i = 1; i <= batches; ++i) {
    good.push_back(i % 7 != 0);
    const match::MatchId discarded{good.back() ? i : i + 1000};
    shelf->append({ledger::CreateMatch{open_match(i), secret(1)}, ledger::DiscardMatch{discarded},
                   ledger::PutGuest{{guest(static_cast<std::uint8_t>(i)), "Ada"}}});
  }
  const auto reports = shelf->reports(batches);
  ASSERT_EQ(reports.size(), batches);
  for (std::uint64_t i = 1; i <= batches; ++i) {
    const ledger::Report& report = reports[i - 1];
    if (good[i - 1]) {
      EXPECT_EQ(std::get<ledger::Stored>(report).ticket, ledger::Ticket{i});
    } else {
      EXPECT_EQ(std::get<ledger::StoreFailed>(report).ticket, ledger::Ticket{i});
    }
  }
  for (std::uint64_t i = 1; i <= batches; ++i) {
    const ledger::FindGuest query{guest(static_cast<std::uint8_t>(i))};
    EXPECT_EQ(shelf->find<ledger::FoundGuest>(query).guest.has_value(), good[i - 1]) << i;
  }
}

// ---- Queries

TEST_P(AnyStore, EntriesComeFromANumberOnUntilTheBytesAreReached) {
  const Story begun = story(1, 8, false);
  keep(begun);
  const auto find = [&](std::uint32_t from, std::size_t bytes) {
    const ledger::FindEntries query{begun.row.id, match::Seq{from}, bytes};
    return shelf->find<ledger::FoundEntries>(query).entries;
  };
  const auto size = [&](std::size_t i) { return record::encode(*begun.entries[i]).size(); };
  EXPECT_TRUE(same(find(3, 0), {begun.entries[3]})) << "at least one";
  EXPECT_TRUE(same(find(3, size(3)), {begun.entries[3]}));
  EXPECT_TRUE(same(find(3, size(3) + 1), {begun.entries[3], begun.entries[4]}));
  EXPECT_EQ(find(0, std::size_t{1} << 30).size(), 9u);
  EXPECT_TRUE(find(9, 1).empty());
}

std::vector<match::MatchId> ids_of(const ledger::FoundMatches& found) {
  std::vector<match::MatchId> ids;
  for (const ledger::MatchRow& row : found.rows) ids.push_back(row.id);
  return ids;
}
using Ids = std::vector<match::MatchId>;
using Which = ledger::ListMatches::Which;

TEST_P(AnyStore, ListsFinishedMatchesThatThePublicOrTheGuestMaySee) {
  Story secret_one = story(2, 0, true);
  std::get<ledger::CreateMatch>(secret_one.batches[0][0]).row.code = "0123456789";
  keep(story(1, 0, true));
  keep(secret_one);
  keep(story(3, 0, false));
  ASSERT_FALSE(shelf->put({ledger::CreateMatch{open_match(4), secret(1)}}));
  const auto list = [&](Which which, std::uint8_t number) {
    return ids_of(shelf->find<ledger::FoundMatches>(
        ledger::ListMatches{which, guest(number), std::nullopt, 100}));
  };
  EXPECT_EQ(list(Which::finished, 9), (Ids{match::MatchId{1}}));
  EXPECT_EQ(list(Which::finished, 1), (Ids{match::MatchId{2}, match::MatchId{1}}));
  EXPECT_EQ(list(Which::mine, 9), Ids{});
  EXPECT_EQ(list(Which::mine, 1),
            (Ids{match::MatchId{4}, match::MatchId{3}, match::MatchId{2}, match::MatchId{1}}));
}

TEST_P(AnyStore, ListsNewestFirstThenGreaterIdsAndGoesOnAfterAPlace) {
  const std::uint64_t large = 0x8000000000000001;
  const std::vector<std::pair<std::int64_t, std::uint64_t>> expected = {
      {30, 5}, {20, large}, {20, 7}, {20, 6}, {10, 9}};
  for (const auto& [created, id] : expected) {
    ASSERT_FALSE(shelf->put({ledger::CreateMatch{open_match(id, created), secret(1)}}));
  }
  for (std::size_t begin = 0; begin <= expected.size(); ++begin) {
    ledger::ListMatches query{Which::mine, guest(1), std::nullopt, 2};
    if (begin > 0) {
      query.after =
          ledger::Place{expected[begin - 1].first, match::MatchId{expected[begin - 1].second}};
    }
    Ids wanted;
    for (std::size_t i = begin; i < std::min(begin + 2, expected.size()); ++i) {
      wanted.push_back(match::MatchId{expected[i].second});
    }
    EXPECT_EQ(ids_of(shelf->find<ledger::FoundMatches>(query)), wanted) << begin;
  }
}

// ---- Start-up

TEST_P(AnyStore, RestoresMatchesThatAreNotFinishedWithTheirSecrets) {
  const Story begun = story(7, 4, false);
  const ledger::MatchRow open = open_match(0xffffffffffffffff);
  keep(story(3, 2, true));
  keep(begun);
  ASSERT_FALSE(shelf->put({ledger::CreateMatch{open, secret(2)}}));
  shelf->reopen();
  const auto restored = shelf->restored();
  ASSERT_EQ(restored.size(), 2u);
  const auto& first = std::get<ledger::LiveMatch>(restored[0]);
  EXPECT_EQ(first.row, begun.row);
  EXPECT_EQ(first.secret, begun.secret);
  EXPECT_TRUE(same(first.entries, begun.entries));
  const auto& second = std::get<ledger::LiveMatch>(restored[1]);
  EXPECT_EQ(second.row, open);
  EXPECT_EQ(second.secret, secret(2));
  EXPECT_TRUE(second.entries.empty());
}

}  // namespace
}  // namespace breakshot::store
