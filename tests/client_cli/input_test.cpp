#include "client_cli/play/input.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "client_cli/play/line_reader.hpp"
#include "tests/support/subprocess.hpp"

namespace breakshot::client {
namespace {

using physics::BallId;
using physics::PocketId;

template <class Wish>
Wish wish_of(const std::string& line) {
  const auto input = input_of(line);
  if (const auto* misread = std::get_if<Misread>(&input)) {
    ADD_FAILURE() << line << ": " << misread->what;
    return {};
  }
  const auto* wish = std::get_if<Wish>(&std::get<Input>(input));
  EXPECT_NE(wish, nullptr) << line;
  return wish == nullptr ? Wish{} : *wish;
}

std::string misread_of(const std::string& line) {
  const auto input = input_of(line);
  const auto* misread = std::get_if<Misread>(&input);
  return misread == nullptr ? "" : misread->what;
}

TEST(Input, ReadsWhatPreparesAShot) {
  EXPECT_EQ(wish_of<AimAlong>("aim -37.25").degrees, -37.25);
  EXPECT_EQ(wish_of<AimAlong>("  A +1e1\t").degrees, 10);
  EXPECT_EQ(wish_of<TurnBy>("turn -0.5").degrees, -0.5);
  EXPECT_EQ(wish_of<SetSpeed>("v 3").m_s, 3);
  EXPECT_EQ(wish_of<AimAt>("at 12").ball, BallId{12});
  EXPECT_FALSE(wish_of<AimAt>("at 12").pocket);
  EXPECT_EQ(wish_of<AimAt>("at 3 foot-left").pocket, PocketId{3});
  EXPECT_EQ(wish_of<AimAt>("AT 3 Left Foot").pocket, PocketId{3});
  EXPECT_EQ(wish_of<PlaceBall>("place -0.7 .1").position, (physics::Vec2{-0.7, 0.1}));
  EXPECT_EQ(wish_of<PlaceBall>("place -0.7 .1").ball, rules::cue_ball);
  EXPECT_EQ(wish_of<PlaceBall>("place 9 0 0").ball, BallId{9});
  EXPECT_EQ(wish_of<PlaceBall>("place cue 0 0").ball, rules::cue_ball);
  wish_of<ShootNow>("s");
}

TEST(Input, ReadsWhereTheTipIsToBe) {
  EXPECT_EQ(wish_of<SetTip>("tip 0.2 -.1").tip, (physics::Tip{0.2, -0.1}));
  EXPECT_EQ(wish_of<SetTip>("tip centre").tip, physics::Tip{});
  for (const char* line : {"tip", "tip 0.2", "tip left", "tip 0 0 0", "tip nan 0"}) {
    EXPECT_NE(misread_of(line).find("tip SIDE HEIGHT"), std::string::npos) << line;
  }
}

TEST(Input, ReadsCalls) {
  EXPECT_EQ(wish_of<MakeCall>("call 8 hr").call, (rules::Call{BallId{8}, PocketId{0}, false}));
  EXPECT_EQ(wish_of<MakeCall>("call safety").call, (rules::Call{{}, {}, true}));
  EXPECT_EQ(wish_of<MakeCall>("call nothing").call, rules::Call{});
}

TEST(Input, KnowsThePocketsByEitherOrderOfTheirWords) {
  const std::vector<std::pair<std::string, std::string>> names = {
      {"head", "right"}, {"side", "right"}, {"foot", "right"},
      {"foot", "left"},  {"side", "left"},  {"head", "left"}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& [along, side] = names[i];
    for (const std::string& text : {along + "-" + side, side + "-" + along, along + " " + side,
                                    side + " " + along, std::string{along[0], side[0]}}) {
      EXPECT_EQ(pocket_of(text), PocketId(i)) << text;
    }
  }
  for (const char* text : {"", "foot", "left", "lf", "foot-", "middle-left", "foot-left-left"}) {
    EXPECT_FALSE(pocket_of(text)) << text;
  }
}

TEST(Input, ReadsTheOtherWishes) {
  EXPECT_EQ(wish_of<TakeOption>("choose 2").number, 2u);
  EXPECT_FALSE(wish_of<GiveUp>("concede").sure);
  EXPECT_TRUE(wish_of<GiveUp>("concede yes").sure);
  EXPECT_EQ(wish_of<AskHelp>("help aim").topic, "aim");
  wish_of<AskHelp>("?");
  wish_of<Nothing>("  \t ");
  wish_of<LeaveTable>("q");
  wish_of<ShowTable>("t");
  wish_of<TellStatus>("status");
  wish_of<TellInvitation>("invite");
  wish_of<AgreeToRerack>("rerack");
  wish_of<ClaimMatch>("claim");
}

TEST(Input, SaysWhatALineShouldHaveBeen) {
  EXPECT_NE(misread_of("dance").find("no command 'dance'"), std::string::npos);
  for (const char* line :
       {"aim",           "aim left",   "aim 1 2",   "aim nan",       "aim inf",
        "aim 1x",        "turn",       "speed",     "speed fast",    "at",
        "at 0",          "at cue",     "at 16",     "at 3 nowhere",  "at -1",
        "call",          "call 3",     "call 0 fl", "place",         "place 1",
        "place 1 2 3 4", "place x y",  "choose",    "choose 0",      "choose -1",
        "choose one",    "concede no", "shoot now", "help aim turn", "quit please"}) {
    const std::string word = std::string(line).substr(0, std::string(line).find(' '));
    EXPECT_EQ(misread_of(line).rfind("That takes: " + word, 0), 0u)
        << line << ": " << misread_of(line);
  }
}

TEST(Input, ExplainsEveryCommandItLists) {
  const auto all = help_on("");
  EXPECT_GE(all.size(), 17u);
  // The list and the prompt fit into two screens of 24 rows.
  EXPECT_LE(all.size(), 40u);
  for (const std::string& line : all) {
    EXPECT_LE(line.size(), 76u) << line;
    if (line.starts_with("      ")) continue;
    const std::string word = line.substr(2, line.find_first_of(" ,", 2) - 2);
    ASSERT_EQ(help_on(word).size(), 1u);
    EXPECT_EQ(help_on(word)[0].rfind(word, 0), 0u) << line;
    EXPECT_EQ(misread_of(word).find("There is no command"), std::string::npos) << word;
  }
  EXPECT_EQ(help_on("dance")[0], "There is no command 'dance'.");
}

// ---- Lines

class Lines : public ::testing::Test {
 protected:
  support::detail::Pipe pipe_;
  LineReader reader_{pipe_.read_end};

  void type(const std::string& text) {
    ASSERT_EQ(::write(pipe_.write_end, text.data(), text.size()),
              static_cast<ssize_t>(text.size()));
    reader_.fill();
  }
};

TEST_F(Lines, ComeWhole) {
  reader_.fill();
  EXPECT_FALSE(reader_.next());
  type("ai");
  EXPECT_FALSE(reader_.next());
  type("m 3\nshoot\nqu");
  EXPECT_EQ(reader_.next(), "aim 3");
  EXPECT_EQ(reader_.next(), "shoot");
  EXPECT_FALSE(reader_.next());
  EXPECT_FALSE(reader_.at_end());
}

TEST_F(Lines, TheLastNeedsNoEnd) {
  type("quit");
  pipe_.close_write();
  reader_.fill();
  EXPECT_FALSE(reader_.at_end());
  EXPECT_EQ(reader_.next(), "quit");
  EXPECT_TRUE(reader_.at_end());
  EXPECT_FALSE(reader_.next());
}

TEST_F(Lines, AreCutWhereTheyAreTooLong) {
  type(std::string(max_line_bytes, 'x'));
  type(std::string(10, 'x') + "\n");
  EXPECT_EQ(reader_.next()->size(), max_line_bytes);
  EXPECT_EQ(reader_.next(), std::string(10, 'x'));
}

}  // namespace
}  // namespace breakshot::client
