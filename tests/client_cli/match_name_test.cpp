#include "client_cli/online/match_name.hpp"

#include <gtest/gtest.h>

#include "client_cli/command.hpp"
#include "client_cli/fetch.hpp"
#include "common/lobby/name.hpp"
#include "tests/client_cli/one_match_server.hpp"

namespace breakshot::client {
namespace {

TEST(MatchName, IsAnIdOrACode) {
  const auto id = match_name_of("0123456789abcDEF");
  ASSERT_TRUE(id);
  EXPECT_EQ(id->id, match::MatchId{0x0123456789abcdef});
  EXPECT_FALSE(id->code);
  const auto code = match_name_of("abcde0l234");
  ASSERT_TRUE(code);
  EXPECT_FALSE(code->id);
  EXPECT_EQ(code->code, "ABCDE01234");
}

TEST(MatchName, IsNothingElse) {
  for (const char* text :
       {"", "0123456789abcde", "0123456789abcdef0", "0123456789abcdeg", "-123456789abcdef",
        "0x23456789abcdef", " 123456789abcdef", "ABCDE0123", "ABCDE01234X", "ABCDE0123!"}) {
    EXPECT_FALSE(match_name_of(text)) << text;
  }
}

/// What the options make of a command line, or the complaint.
std::string made_of(const std::vector<const char*>& words) {
  CLI::App app;
  MatchOptions options;
  options.add_to(app);
  std::vector<const char*> line = {"breakshot"};
  line.insert(line.end(), words.begin(), words.end());
  try {
    app.parse(static_cast<int>(line.size()), line.data());
    const MatchName name = options.required_name();
    return name.id ? "id" : *name.code;
  } catch (const CLI::ParseError&) {
    return "parse error";
  } catch (const CommandError& error) {
    EXPECT_EQ(error.status(), exit_usage);
    return error.what();
  }
}

TEST(MatchOptions, TakesOneName) {
  EXPECT_EQ(made_of({"0123456789abcdef"}), "id");
  EXPECT_EQ(made_of({"--code", "abcde-nope"}).rfind("--code: abcde-nope:", 0), 0u);
  EXPECT_EQ(made_of({"--code", "abcde01234"}), "ABCDE01234");
  EXPECT_EQ(made_of({"abcde01234"}), "ABCDE01234");
  EXPECT_EQ(made_of({"0123456789abcdef", "--code", "ABCDE01234"}), "parse error");
  EXPECT_EQ(made_of({"nonsense"}).rfind("nonsense: names no match", 0), 0u);
  EXPECT_EQ(made_of({}), "say which match: MATCH or --code CODE");
}

TEST(GuestOf, RefusesWhatCannotBeAName) {
  for (const char* name : {"", " Ann", "Ann\n", "\xff"}) {
    EXPECT_THROW(guest_of(name), CommandError) << name;
  }
  EXPECT_EQ(lobby::name_fault(user_name()), std::nullopt);
}

TEST(FetchRecord, SaysWhyThereIsNone) {
  OneMatchServer server;
  const ServerAddress address{"127.0.0.1", server.port()};
  const auto what = [&](const std::string& name) {
    const auto fetched = fetch_record(address, stranger(), name);
    const auto* failure = std::get_if<Failure>(&fetched);
    return failure == nullptr ? "fetched" : failure->what;
  };
  EXPECT_EQ(what("nonsense"), "names no match: that takes 16 hexadecimal digits or an invite code");
  // The match has not started, so it has no header.
  EXPECT_NE(what("0000000000001234").find("parts of the record"), std::string::npos);
}

}  // namespace
}  // namespace breakshot::client
