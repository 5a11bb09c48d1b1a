// Which matches there are, for whom, in which order.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

std::vector<match::MatchId> listed(HubRig& rig, const Player& player, lobby::Filter filter) {
  std::vector<match::MatchId> ids;
  const auto listing = rig.get<lobby::Listing>(player.connection, lobby::List{filter, {}});
  EXPECT_FALSE(listing.more);
  for (const lobby::MatchInfo& info : listing.matches) ids.push_back(info.id);
  return ids;
}

void finish(HubRig& rig, const Alone& alone) {
  rig.get<lobby::EntryNews>(alone.player.connection, act(alone.match, 1, 1, match::Concede{}));
}

using Ids = std::vector<match::MatchId>;

TEST(Listing, AMatchMovesFromOpenToRunningToFinished) {
  HubRig rig;
  const Player eve = meet(rig, "Eve");
  const Alone alone{meet(rig, "Ada"), {}};
  const match::MatchId id = create(rig, alone.player, practice()).id;
  using lobby::Filter;
  EXPECT_EQ(listed(rig, eve, Filter::open), Ids{id});
  EXPECT_EQ(listed(rig, eve, Filter::running), Ids{});
  contribute(rig, alone.player, id);
  EXPECT_EQ(listed(rig, eve, Filter::open), Ids{});
  EXPECT_EQ(listed(rig, eve, Filter::running), Ids{id});
  EXPECT_EQ(listed(rig, eve, Filter::finished), Ids{});
  finish(rig, {alone.player, id});
  EXPECT_EQ(listed(rig, eve, Filter::running), Ids{});
  EXPECT_EQ(listed(rig, eve, Filter::finished), Ids{id});
}

TEST(Listing, MineAreThoseOfTheAskerAtAnyStage) {
  HubRig rig;
  const Player eve = meet(rig, "Eve");
  const Player ada = meet(rig, "Ada");
  Ids own;
  for (int i = 0; i < 3; ++i) {
    rig.pass(milliseconds(1));
    own.insert(own.begin(), create(rig, ada, practice()).id);
    create(rig, eve, practice());
  }
  contribute(rig, ada, own[0]);
  contribute(rig, ada, own[1]);
  finish(rig, {ada, own[1]});
  EXPECT_EQ(listed(rig, ada, lobby::Filter::mine), own);
  const auto listing =
      rig.get<lobby::Listing>(ada.connection, lobby::List{lobby::Filter::mine, {}});
  EXPECT_TRUE(listing.matches[0].seats[0].present) << "what is live is known from memory";
}

TEST(Listing, PrivateMatchesAreListedOnlyForThoseWhoSit) {
  HubRig rig;
  const Player eve = meet(rig, "Eve");
  const Alone alone{meet(rig, "Ada"), {}};
  const match::MatchId id = create(rig, alone.player, practice(1, true)).id;
  using lobby::Filter;
  EXPECT_EQ(listed(rig, eve, Filter::open), Ids{});
  EXPECT_EQ(listed(rig, alone.player, Filter::open), Ids{id});
  contribute(rig, alone.player, id);
  EXPECT_EQ(listed(rig, eve, Filter::running), Ids{});
  EXPECT_EQ(listed(rig, alone.player, Filter::running), Ids{id});
  finish(rig, {alone.player, id});
  EXPECT_EQ(listed(rig, eve, Filter::finished), Ids{});
  EXPECT_EQ(listed(rig, alone.player, Filter::finished), Ids{id});
}

/// Reads a listing page by page.
Ids paged(HubRig& rig, const Player& player, lobby::Filter filter, std::size_t pages) {
  Ids ids;
  lobby::List list{filter, {}};
  while (true) {
    const auto listing = rig.get<lobby::Listing>(player.connection, list);
    for (const lobby::MatchInfo& info : listing.matches) ids.push_back(info.id);
    --pages;
    if (!listing.more) break;
    EXPECT_EQ(listing.matches.size(), lobby::page_size);
    list.after = lobby::Position{listing.matches.back().created_unix_ms, ids.back()};
  }
  EXPECT_EQ(pages, 0u);
  return ids;
}

TEST(Listing, PagesHoldEachMatchOnceNewestFirst) {
  Limits limits;
  limits.live_matches_per_guest = 1000;
  limits.follows_per_connection = 1000;
  HubRig rig(limits);
  const Player ada = meet(rig, "Ada");
  std::vector<std::pair<std::int64_t, match::MatchId>> made;
  for (std::size_t i = 0; i < 2 * lobby::page_size + 5; ++i) {
    if (i % 3 == 0) rig.pass(milliseconds(1));  // some are of the same millisecond
    made.emplace_back(rig.now.unix_ms, create(rig, ada, practice()).id);
  }
  std::sort(made.rbegin(), made.rend());
  Ids expected;
  for (const auto& [created, id] : made) expected.push_back(id);
  EXPECT_EQ(paged(rig, ada, lobby::Filter::open, 3), expected);
  EXPECT_EQ(paged(rig, ada, lobby::Filter::mine, 3), expected);
  for (const match::MatchId id : expected) {
    contribute(rig, ada, id);
    finish(rig, {ada, id});
  }
  EXPECT_EQ(paged(rig, ada, lobby::Filter::finished, 3), expected);
}

TEST(Listing, APageGoesOnWhereAMatchHasGone) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const auto older = create(rig, ada, practice());
  rig.pass(milliseconds(1));
  const auto newer = create(rig, ada, practice());
  rig.get<lobby::Done>(ada.connection, lobby::Leave{newer.id});
  const lobby::Position after{newer.created_unix_ms, newer.id};
  const auto listing =
      rig.get<lobby::Listing>(ada.connection, lobby::List{lobby::Filter::open, after});
  ASSERT_EQ(listing.matches.size(), 1u);
  EXPECT_EQ(listing.matches[0].id, older.id);
}

TEST(Listing, AStoreThatCannotBeReadMakesItUnavailable) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  rig.store().fail(1, "cannot read");
  EXPECT_EQ(rig.refusal(ada.connection, lobby::List{lobby::Filter::mine, {}}),
            lobby::RefusalCode::unavailable);
}

}  // namespace
}  // namespace breakshot::hub
