// The commands that need no server, run as a user runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/client_cli/match_files.hpp"
#include "tests/support/subprocess.hpp"

namespace breakshot::client {
namespace {

support::Finished breakshot(std::vector<std::string> words) {
  words.insert(words.begin(), BREAKSHOT_PROGRAM);
  return support::run(words, {{"NO_COLOR", ""}, {"COLUMNS", "80"}});
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// A match whose stored table differs from what was played, by one ulp, digests and all.
record::Record forged_match() {
  record::Record record = finished_match();
  double& x = record.entries[1].outcome.table.balls[0].position.x;
  x = std::nextafter(x, 1.0);
  hash::Digest digest = record::digest_of(record.header);
  for (record::Entry& entry : record.entries) {
    entry.digest = digest = record::digest_of(digest, entry);
  }
  return record;
}

/// A match of which the last entry, with the secret, has not been played.
record::Record unfinished_match() {
  record::Record record = finished_match();
  record.entries.pop_back();
  return record;
}

TEST(Verify, ExitsWithZeroWhereEveryBitIsTheSame) {
  const MatchFiles files;
  const auto ran = breakshot({"verify", files.finished()});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, files.finished() + ": verified, " +
                         std::to_string(finished_match().entries.size()) + " entries\n");
  EXPECT_EQ(ran.err, "");
}

TEST(Verify, NamesTheFirstEntryThatDiverges) {
  const MatchFiles files;
  const std::string file = files.write("forged.breakshot", forged_match());
  const auto ran = breakshot({"verify", file});
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(ran.out.rfind(file + ": diverged at entry 1: ", 0), 0u) << ran.out;
  const auto json = breakshot({"--json", "verify", file});
  EXPECT_EQ(json.status, 1);
  EXPECT_TRUE(contains(json.out, "\"verdict\":\"diverged\"")) << json.out;
  EXPECT_TRUE(contains(json.out, "\"entry\":1,")) << json.out;
}

TEST(Verify, SaysWhereAFileIsDamaged) {
  const MatchFiles files;
  const auto ran = breakshot({"verify", files.cut()});
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(ran.out.rfind(files.cut() + ": damaged at byte ", 0), 0u) << ran.out;
}

TEST(Verify, ExitsWithThreeBeforeTheSecretIsRevealed) {
  const MatchFiles files;
  const auto ran = breakshot({"verify", files.write("running.breakshot", unfinished_match())});
  EXPECT_EQ(ran.status, 3);
  EXPECT_TRUE(contains(ran.out, "not revealed yet")) << ran.out;
}

TEST(Verify, ExitsWithTwoWhereThereIsNothingToRead) {
  const MatchFiles files;
  const std::string text = files.write("text", record::ByteVector{'h', 'i'});
  for (const std::string& file : {text, files.path("missing"), files.path("")}) {
    const auto ran = breakshot({"verify", file});
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err.rfind("breakshot: " + file + ": ", 0), 0u) << ran.err;
  }
  EXPECT_EQ(breakshot({"verify"}).status, 2);
}

TEST(Verify, JudgesEveryFileAndExitsWithTheWorst) {
  const MatchFiles files;
  const std::string running = files.write("running.breakshot", unfinished_match());
  auto ran = breakshot({"verify", files.finished(), running});
  EXPECT_EQ(ran.status, 3);
  ran = breakshot({"verify", files.cut(), running, files.finished(), "--json"});
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(lines_in(ran.out), 3u);
  ran = breakshot({"verify", files.path("missing"), files.cut(), files.finished(), "--json"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(lines_in(ran.out), 3u);
  EXPECT_TRUE(contains(ran.out, "\"verdict\":\"unreadable\"")) << ran.out;
  EXPECT_TRUE(contains(ran.out, "\"verdict\":\"damaged\"")) << ran.out;
  EXPECT_TRUE(contains(ran.out, "\"verdict\":\"verified\"")) << ran.out;
}

TEST(Replay, TellsTheMatchWhereThereIsNoTerminal) {
  const MatchFiles files;
  const auto ran = breakshot({"replay", files.finished()});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "player 0 against player 1"));
  EXPECT_TRUE(contains(ran.out, "shot 1    player 0 breaks at "));
  EXPECT_TRUE(contains(ran.out, " wins the match"));
  EXPECT_FALSE(contains(ran.out, "\x1b"));
}

TEST(Replay, TellsOneShotWithItsEventsWhereAsked) {
  const MatchFiles files;
  const auto ran = breakshot({"replay", files.finished(), "--shot", "2", "--step"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "shot 2 "));
  EXPECT_FALSE(contains(ran.out, "shot 1 "));
  EXPECT_TRUE(contains(ran.out, "0.000000 s  cue ball is struck"));
}

TEST(Replay, PrintsAnObjectForEveryEntryAsJson) {
  const MatchFiles files;
  const auto ran = breakshot({"replay", files.finished(), "--json"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(lines_in(ran.out), finished_match().entries.size());
  EXPECT_EQ(ran.out.rfind("{\"entry\":0,\"command\":\"start\"", 0), 0u) << ran.out;
}

TEST(Replay, ShowsTheValidPrefixOfADamagedFileAndSaysSo) {
  const MatchFiles files;
  const auto ran = breakshot({"replay", files.cut()});
  EXPECT_EQ(ran.status, 1);
  EXPECT_TRUE(contains(ran.out, "shot 1 "));
  EXPECT_EQ(ran.err.rfind("breakshot: " + files.cut() + ": damaged at byte ", 0), 0u) << ran.err;
}

TEST(Replay, RefusesWhatItCannotDo) {
  const MatchFiles files;
  EXPECT_EQ(breakshot({"replay", files.finished(), "--shot", "999"}).status, 2);
  EXPECT_EQ(breakshot({"replay", files.finished(), "--speed", "1001"}).status, 2);
  EXPECT_EQ(breakshot({"replay", files.path("missing")}).status, 2);
}

TEST(Render, WritesPicturesOfAnyMomentAndOfTheFigures) {
  const MatchFiles files;
  const std::string png = files.path("a.png");
  const std::string svg = files.path("a.svg");
  const std::vector<std::vector<std::string>> lines = {
      {"render", files.finished(), "-o", png, "--size", "200"},
      {"render", files.finished(), "-o", png, "--shot", "2", "--time", "0.5", "--paths",
       "--vectors", "--cue", "--caption", "--size", "200x100"},
      {"render", "--figure", "1", "-o", png, "--size", "200"},
      {"render", "--figure", "4", "--preset", "paper", "-o", svg}};
  for (const auto& line : lines) {
    const auto ran = breakshot(line);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.out + ran.err, "");
    const std::string& file = line.back() == svg ? svg : png;
    EXPECT_GT(std::filesystem::file_size(file), 500u);
    std::filesystem::remove(file);
  }
}

TEST(Render, SaysWhatItCannotDraw) {
  const MatchFiles files;
  const std::string match = files.finished();
  const std::string png = files.path("a.png");
  const std::vector<std::pair<int, std::vector<std::string>>> lines = {
      {2, {"render", match}},
      {2, {"render", "-o", png}},
      {2, {"render", match, "-o", files.path("a.bmp")}},
      {2, {"render", match, "-o", png, "--shot", "999"}},
      {2, {"render", match, "-o", png, "--time", "1e9"}},
      {2, {"render", match, "-o", png, "--time", "-1"}},
      {2, {"render", match, "-o", png, "--size", "10x10"}},
      {2, {"render", match, "-o", png, "--size", "16385"}},
      {2, {"render", "--figure", "1", "-o", png, "--shot", "2"}},
      {2, {"render", "--figure", "1", "-o", png, "--caption"}},
      {2, {"render", match, "-o", png, "--size", "wide"}},
      {2, {"render", match, "-o", png, "--figure", "1"}},
      {2, {"render", "--figure", "5", "-o", png}},
      {2, {"render", "--figure", "1", "--preset", "none", "-o", png}},
      {1, {"render", match, "-o", "/nonexistent/a.png"}}};
  for (const auto& [status, line] : lines) {
    const auto ran = breakshot(line);
    EXPECT_EQ(ran.status, status) << testing::PrintToString(line) << ran.err;
    EXPECT_EQ(ran.err.rfind("breakshot: ", 0), 0u) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(png));
  }
}

}  // namespace
}  // namespace breakshot::client
