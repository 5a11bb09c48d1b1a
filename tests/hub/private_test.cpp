// Private matches are for those who sit at them or have their code.
#include <gtest/gtest.h>

#include "tests/hub/table.hpp"

namespace breakshot::hub {
namespace {

TEST(PrivateMatch, OnlyThoseWhoSitAreToldItsCode) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player eve = meet(rig, "Eve");
  const auto info = create(rig, ada, eight_ball(true));
  ASSERT_TRUE(info.is_private);
  ASSERT_TRUE(info.code);
  EXPECT_EQ(info.code->size(), lobby::invite_code_length);
  const auto news =
      rig.get<lobby::MatchNews>(eve.connection, lobby::Watch{std::nullopt, info.code, {}});
  EXPECT_FALSE(news.info.code);
}

TEST(PrivateMatch, ItsCodeOpensItInAnyCase) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player bob = meet(rig, "Bob");
  const auto info = create(rig, ada, eight_ball(true));
  std::string typed = *info.code;
  for (char& c : typed) c = static_cast<char>(std::tolower(c));
  const auto news = rig.get<lobby::MatchNews>(bob.connection, lobby::Join{{}, typed, {}});
  EXPECT_EQ(news.info.id, info.id);
  EXPECT_EQ(news.you, match::Seat{1});
}

TEST(PrivateMatch, WithoutCodeOrSeatItLooksLikeNone) {
  HubRig rig;
  const Table table = sit_down(rig, eight_ball(true));
  const Player eve = meet(rig, "Eve");
  const auto refusals = [&](match::MatchId id) {
    std::vector<lobby::Refused> found;
    const lobby::Request requests[] = {join(id),
                                       watch(id),
                                       fetch(id),
                                       lobby::Contribute{id, share(1)},
                                       act(id, 1, 1, a_break()),
                                       lobby::Claim{id},
                                       lobby::Join{id, "0000000000", {}},
                                       lobby::Watch{id, "0000000000", {}}};
    for (const lobby::Request& request : requests) {
      const std::size_t loads = rig.loads();
      found.push_back(rig.get<lobby::Refused>(eve.connection, request));
      EXPECT_EQ(rig.loads(), loads + 1) << "the same work is done for both";
    }
    rig.get<lobby::Done>(eve.connection, lobby::Leave{id});
    return found;
  };
  const auto of_private = refusals(table.match);
  const auto of_none = refusals(match::MatchId{4711});
  for (std::size_t i = 0; i < of_none.size(); ++i) {
    EXPECT_EQ(of_private[i].code, lobby::RefusalCode::no_such_match) << i;
    EXPECT_EQ(of_none[i].code, lobby::RefusalCode::no_such_match) << i;
    EXPECT_EQ(of_private[i].what, of_none[i].what) << i;
  }
}

TEST(PrivateMatch, ThoseWhoSitNeedNoCode) {
  HubRig rig;
  const Table table = sit_down(rig, eight_ball(true));
  const Player bob = again(rig, table.second);
  EXPECT_EQ(rig.get<lobby::MatchNews>(bob.connection, join(table.match)).you, match::Seat{1});
}

TEST(PrivateMatch, TheCodeOfAnotherMatchDoesNotOpenIt) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player eve = meet(rig, "Eve");
  const auto info = create(rig, ada, eight_ball(true));
  const auto other = create(rig, ada, eight_ball(true));
  EXPECT_EQ(rig.refusal(eve.connection, lobby::Watch{info.id, other.code, {}}),
            lobby::RefusalCode::no_such_match);
}

TEST(PrivateMatch, AfterItsEndTheCodeStillOpensTheRecord) {
  HubRig rig;
  const Player ada = meet(rig, "Ada");
  const Player eve = meet(rig, "Eve");
  const auto info = create(rig, ada, practice(1, true));
  contribute(rig, ada, info.id);
  rig.get<lobby::EntryNews>(ada.connection, act(info.id, 1, 1, match::Concede{}));
  EXPECT_EQ(rig.refusal(eve.connection, fetch(info.id)), lobby::RefusalCode::no_such_match);
  const auto request = rig.ask(eve.connection, lobby::Fetch{std::nullopt, info.code, {}});
  EXPECT_EQ(rig.answers(eve.connection, request).size(), 4u);  // news, two entries, done
}

}  // namespace
}  // namespace breakshot::hub
