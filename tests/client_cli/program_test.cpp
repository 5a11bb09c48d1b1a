// The built program from outside: what every command has in common.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/subprocess.hpp"

namespace breakshot {
namespace {

TEST(Program, PrintsItsVersion) {
  const auto ran = support::run({BREAKSHOT_PROGRAM, "--version"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.out.rfind("breakshot ", 0), 0u) << ran.out;
  EXPECT_EQ(ran.err, "");
}

TEST(Program, HelpNamesTheGlobalOptions) {
  const auto ran = support::run({BREAKSHOT_PROGRAM, "--help"});
  EXPECT_EQ(ran.status, 0);
  for (const char* option : {"--server", "--json", "--colour", "--version"}) {
    EXPECT_NE(ran.out.find(option), std::string::npos) << option << " in\n" << ran.out;
  }
}

TEST(Program, ExitsWithTwoWhereTheLineCannotBeUnderstood) {
  for (const char* word : {"--nonsense", "nonsense"}) {
    const auto ran = support::run({BREAKSHOT_PROGRAM, word});
    EXPECT_EQ(ran.status, 2) << word;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err.rfind("breakshot: ", 0), 0u) << ran.err;
  }
  EXPECT_EQ(support::run({BREAKSHOT_PROGRAM}).status, 2);
  EXPECT_EQ(support::run({BREAKSHOT_PROGRAM, "nonsense"}).err.rfind("breakshot: nonsense: ", 0),
            0u);
}

}  // namespace
}  // namespace breakshot
