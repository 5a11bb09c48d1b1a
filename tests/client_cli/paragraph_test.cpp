#include "client_cli/paragraph.hpp"

#include <gtest/gtest.h>

namespace breakshot::client {
namespace {

using Lines = std::vector<std::string>;

TEST(Paragraph, BreaksBetweenWords) {
  EXPECT_EQ(wrapped("the cue ball meets", 8, ""), (Lines{"the cue", "ball", "meets"}));
  EXPECT_EQ(wrapped("the cue ball meets", 18, ""), Lines{"the cue ball meets"});
  EXPECT_EQ(wrapped("the cue ball meets", 17, ""), (Lines{"the cue ball", "meets"}));
}

TEST(Paragraph, IndentsAllLinesButTheFirst) {
  EXPECT_EQ(wrapped("shot 1  Ada breaks hard", 14, "        "),
            (Lines{"shot 1  Ada", "        breaks", "        hard"}));
  EXPECT_EQ(wrapped("  Ada breaks", 7, "  "), (Lines{"  Ada", "  breaks"}));
}

TEST(Paragraph, NeverBreaksAWord) {
  EXPECT_EQ(wrapped("behind the headstring now", 6, ""),
            (Lines{"behind", "the", "headstring", "now"}));
  EXPECT_EQ(wrapped("headstring", 3, "    "), Lines{"headstring"});
  EXPECT_EQ(wrapped("a headstring b", 1, "    "), (Lines{"a", "    headstring", "    b"}));
}

TEST(Paragraph, LeavesNothingAsItIs) {
  EXPECT_EQ(wrapped("", 10, "  "), Lines{""});
  EXPECT_EQ(wrapped("     ", 3, "  "), Lines{"     "});
}

}  // namespace
}  // namespace breakshot::client
