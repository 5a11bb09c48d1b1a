// The built client against the built server, each in a process of its own.
#include <gtest/gtest.h>
#include <poll.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "common/record/record.hpp"
#include "tests/support/background.hpp"
#include "tests/support/chance.hpp"
#include "tests/support/pseudo_terminal.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/server_process.hpp"

namespace breakshot::client {
namespace {

using support::Background;
using support::Finished;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Waits until `holds`, for so long that only a program that hangs fails.
template <class Condition>
void await(const Condition& holds) {
  for (int tries = 0; tries < 20'000 && !holds(); ++tries) ::poll(nullptr, 0, 1);
}

/// The lines of the account that tell of shots.
std::string shots_in(const std::string& printed) {
  std::istringstream lines(printed);
  std::string shots;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("shot ")) shots += line + '\n';
  }
  return shots;
}

std::size_t lines_with(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// A server, and a home in which its guests are remembered.
class OnlineProgram : public ::testing::Test {
 protected:
  support::Scratch scratch_;
  std::optional<support::ServerProcess> server_{std::in_place, BREAKSHOT_SERVER_PROGRAM,
                                                scratch_.path() / "data"};

  std::vector<std::string> line(std::vector<std::string> words) const {
    words.insert(words.begin(), BREAKSHOT_PROGRAM);
    words.insert(words.end(), {"--server", "127.0.0.1:" + std::to_string(server_->port())});
    return words;
  }
  std::map<std::string, std::string> home() const {
    return {{"XDG_STATE_HOME", (scratch_.path() / "state").string()}};
  }
  Finished run(const std::vector<std::string>& words) const {
    return support::run(line(words), home());
  }

  /// The first match that `list` shows, waited for.
  std::string match_listed(const std::string& filter, const std::string& guest = "Nan") const {
    const std::string key = "\"match\":\"";
    for (int tries = 0; tries < 1000; ++tries) {
      const Finished listed = run({"list", "--json", filter, "--name", guest});
      const std::size_t at = listed.out.find(key);
      if (at != std::string::npos) return listed.out.substr(at + key.size(), 16);
    }
    return "none";
  }
};

TEST_F(OnlineProgram, TwoBotsPlayAMatchToItsEndWhileSomebodyWatches) {
  Background ann(line({"bot", "--new", "--name", "Ann", "--seed", "1", "--candidates", "60"}),
                 home());
  const std::string match = match_listed("--open");
  Background watcher(line({"watch", match}), home());
  const Finished bob =
      run({"bot", match, "--name", "Bob", "--seed", "2", "--candidates", "60", "--json"});
  EXPECT_EQ(bob.status, 0) << bob.err;
  const Finished ann_done = ann.wait();
  EXPECT_EQ(ann_done.status, 0) << ann_done.err;
  const Finished watched = watcher.wait();
  EXPECT_EQ(watched.status, 0) << watched.err;

  const std::size_t shots = lines_with(bob.out, "\"command\":\"shoot\"");
  EXPECT_GT(shots, 1u) << bob.out;
  EXPECT_EQ(lines_with(ann_done.out, "\nshot "), shots);
  EXPECT_EQ(lines_with(watched.out, "\nshot "), shots);
  EXPECT_TRUE(has(watched.out, " wins the match.")) << watched.out;
  EXPECT_TRUE(has(ann_done.out, "breakshot play " + match)) << ann_done.out;

  const std::string file = (scratch_.path() / "match.breakshot").string();
  const Finished exported = run({"export", match, "-o", file});
  EXPECT_EQ(exported.status, 0) << exported.err;
  EXPECT_TRUE(has(exported.out, file)) << exported.out;
  std::ifstream in(file, std::ios::binary);
  const record::ByteVector bytes{std::istreambuf_iterator<char>(in), {}};
  const record::Reading reading = record::read_file(bytes);
  ASSERT_TRUE(reading.record);
  EXPECT_FALSE(reading.damage);
  EXPECT_EQ(record::file_of(*reading.record), bytes);
  EXPECT_EQ(record::verify(*reading.record).kind, record::Verdict::Kind::verified);

  // What is no plain file is written to as it is, and stays what it is.
  const auto link = scratch_.path() / "link";
  std::filesystem::create_symlink(scratch_.path() / "linked", link);
  std::ofstream(scratch_.path() / "linked").close();
  EXPECT_EQ(run({"export", match, "-o", link.string()}).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(std::filesystem::file_size(link), std::filesystem::file_size(file));
  const Finished streamed = run({"export", match, "-o", "-"});
  EXPECT_EQ(streamed.out, std::string(bytes.begin(), bytes.end()));
  EXPECT_EQ(match_listed("--finished"), match);
}

TEST_F(OnlineProgram, BotsThatNameNoMatchFindEachOther) {
  Background ann(line({"bot", "--name", "Ann", "--candidates", "20", "--shots", "6"}), home());
  match_listed("--open");
  const Finished bob = run({"bot", "--name", "Bob", "--candidates", "20", "--shots", "6"});
  EXPECT_EQ(bob.status, 0) << bob.err;
  EXPECT_TRUE(has(bob.out, "Ann against Bob")) << bob.out;
  EXPECT_EQ(ann.wait().status, 0);
}

TEST_F(OnlineProgram, ABotConcedesAtItsCapOfShots) {
  Background ann(line({"bot", "--new", "--name", "Ann", "--candidates", "20", "--shots", "1"}),
                 home());
  const Finished bob =
      run({"bot", match_listed("--open"), "--name", "Bob", "--candidates", "20", "--shots", "1"});
  EXPECT_EQ(bob.status, 0) << bob.err;
  EXPECT_EQ(lines_with(bob.out, "\nshot "), 1u) << bob.out;
  EXPECT_TRUE(has(bob.out, " concedes")) << bob.out;
  EXPECT_EQ(ann.wait().status, 0);
}

TEST_F(OnlineProgram, ABotPractisesAlone) {
  const Finished bot = run({"bot", "--new", "--game", "practice", "--candidates", "40"});
  EXPECT_EQ(bot.status, 0) << bot.err;
  EXPECT_GT(lines_with(bot.out, "\nshot "), 3u) << bot.out;
}

TEST_F(OnlineProgram, PrivateMatchesAreReachedByTheirCode) {
  Background ann(line({"bot", "--private", "--name", "Ann", "--candidates", "20", "--shots", "2"}),
                 home());
  std::string code;
  for (int tries = 0; tries < 1000 && code.empty(); ++tries) {
    const std::string out = run({"list", "--mine", "--name", "Bob", "--json"}).out;
    EXPECT_EQ(out, "");
    const std::string printed = ann.printed();
    const std::size_t at = printed.find("--code ");
    if (at != std::string::npos && printed.size() > at + 17) code = printed.substr(at + 7, 10);
  }
  EXPECT_TRUE(has(run({"list", "--open"}).out, "No such match"));
  const Finished bob =
      run({"bot", "--code", code, "--name", "Bob", "--candidates", "20", "--shots", "2"});
  EXPECT_EQ(bob.status, 0) << bob.err;
  EXPECT_EQ(ann.wait().status, 0);
  EXPECT_TRUE(has(run({"watch", "--code", code}).out, "Ann against Bob"));
  EXPECT_TRUE(has(run({"list", "--mine", "--name", "Ann", "--json"}).out, code));
  // Or by their seat. Nobody else knows of them.
  const std::string id = match_listed("--mine", "Ann");
  EXPECT_TRUE(has(run({"replay", id, "--name", "Ann"}).out, "Ann against Bob"));
  EXPECT_EQ(run({"verify", id, "--name", "Ann"}).status, 0);
  EXPECT_EQ(run({"verify", id, "--name", "Eve"}).status, 2);
  EXPECT_EQ(run({"verify", id}).status, 2);
}

TEST_F(OnlineProgram, APlayerAimsLooksAndShootsInATerminal) {
  std::vector<std::string> words =
      line({"play", "--new", "--game", "practice", "--name", "Ann", "--speed", "50"});
  support::OnTerminal program([&] {
    ::setenv("TERM", "xterm-256color", 1);
    ::setenv("LC_ALL", "C.UTF-8", 1);
    support::detail::become(words, home());
  });
  ASSERT_TRUE(program.wait_for("to see how.")) << program.seen();
  program.type("aim 3\r");
  // The line of aim is drawn, and then said, before anything is struck.
  ASSERT_TRUE(program.wait_for("Aim 3.00 degrees")) << program.seen();
  EXPECT_EQ(program.seen().find("shot 1 "), std::string::npos);
  program.type("shoot\r");
  ASSERT_TRUE(program.wait_for("shot 1 ")) << program.seen();
  // The next prompt comes once the balls have been seen to stop.
  const auto prompts = [](const std::string& seen) { return lines_with(seen, "Your shot"); };
  EXPECT_TRUE(program.wait_until([&](const std::string& seen) { return prompts(seen) > 1; }));
  program.type("quit\r");
  EXPECT_EQ(program.finish(), 0);
  EXPECT_TRUE(program.modes_are_as_before());
}

TEST_F(OnlineProgram, AScriptPlaysAPractice) {
  const std::string script =
      "help\naim nowhere\nshoot\nplace 0 -0.4 0.3\nplace 5 5\nat 1\nspeed 4\nspeed 99\nstatus\n"
      "table\nshoot\nconcede\nconcede yes\nthis is never read\n";
  Background ann(line({"play", "--game", "practice", "--name", "Ann"}), home(), script);
  const Finished played = ann.wait();
  EXPECT_EQ(played.status, 0) << played.err;
  for (const char* said :
       {"Your shot", "at BALL [POCKET]", "That takes: aim DEGREES", "Aim first",
        "That was refused: position", "The speed must be above 0", "Aim ", "4.00 m/s", "shot 1 ",
        "That cannot be taken back", "breakshot replay "}) {
    EXPECT_TRUE(has(played.out, said)) << said << " in\n" << played.out;
  }
  EXPECT_FALSE(has(played.out, "\x1b")) << played.out;
}

TEST_F(OnlineProgram, APersonPlaysABot) {
  // Enough safeties for any race to six shots, after which the bot gives up at its turn.
  std::string script = "place -0.7 0\nat 1\nspeed 8\nshoot\n";
  for (int i = 0; i < 12; ++i) script += "choose 1\naim 10\ncall safety\nspeed 1\nshoot\n";
  Background ann(line({"play", "--new", "--name", "Ann"}), home(), script);
  const Finished bob =
      run({"bot", match_listed("--open"), "--name", "Bob", "--candidates", "20", "--shots", "2"});
  EXPECT_EQ(bob.status, 0) << bob.err;
  const Finished played = ann.wait();
  EXPECT_EQ(played.status, 0) << played.err;
  EXPECT_TRUE(has(played.out, "Others join with:")) << played.out;
  EXPECT_TRUE(has(played.out, "Bob sits down.")) << played.out;
  EXPECT_TRUE(has(played.out, "shot 2 ")) << played.out;
}

TEST_F(OnlineProgram, APlayerComesBackToTheSeat) {
  Background first(line({"play", "--new", "--name", "Ann"}), home(), "quit\n");
  const std::string match = match_listed("--open");
  Background bob(line({"bot", match, "--name", "Bob", "--candidates", "20", "--shots", "1"}),
                 home());
  const Finished left = first.wait();
  EXPECT_EQ(left.status, 0) << left.err;
  EXPECT_TRUE(has(left.out, "The match waits for you: breakshot play " + match)) << left.out;
  Background again(line({"play", "--name", "Ann", "--json"}), home(), "concede yes\n");
  const Finished back = again.wait();
  EXPECT_EQ(back.status, 0) << back.err;
  EXPECT_TRUE(has(back.out, "{\"match\":\"" + match)) << back.out;
  EXPECT_TRUE(has(back.out, "\"command\":\"concede\"")) << back.out;
  EXPECT_EQ(bob.wait().status, 0);
}

TEST_F(OnlineProgram, BotsGoOnThroughAServerThatIsKilled) {
  const std::string port = std::to_string(server_->port());
  const std::vector<std::string> thinking = {"--candidates", "3000", "--error", "2",
                                             "--shots",      "500"};
  auto ann_line = line({"bot", "--new", "--race", "50", "--name", "Ann", "--seed", "1"});
  ann_line.insert(ann_line.end(), thinking.begin(), thinking.end());
  Background ann(ann_line, home());
  auto bob_line = line({"bot", match_listed("--open"), "--name", "Bob", "--seed", "2"});
  bob_line.insert(bob_line.end(), thinking.begin(), thinking.end());
  Background bob(bob_line, home());
  await([&] { return has(ann.printed(), "\nshot 1 "); });
  // At any moments, while the bots think, shoot, or are on their way back.
  support::Chance chance(5);
  for (int kills = 0; kills < 20; ++kills) {
    ::poll(nullptr, 0, 100 + static_cast<int>(chance.below(300)));
    ASSERT_FALSE(has(ann.printed(), "wins the match")) << "after " << kills << " kills";
    server_->kill();
    server_.emplace(BREAKSHOT_SERVER_PROGRAM, scratch_.path() / "data",
                    std::vector<std::string>{"--port", port});
  }
  const Finished ann_done = ann.wait();
  const Finished bob_done = bob.wait();
  EXPECT_EQ(ann_done.status, 0) << ann_done.err;
  EXPECT_EQ(bob_done.status, 0) << bob_done.err;
  EXPECT_TRUE(has(ann_done.err, "connection lost")) << ann_done.err;
  EXPECT_TRUE(has(ann_done.err, "connected again")) << ann_done.err;
  // Nothing was told twice and nothing left out: both heard the same.
  EXPECT_EQ(shots_in(ann_done.out), shots_in(bob_done.out));
  const std::string out = (scratch_.path() / "m").string();
  EXPECT_EQ(run({"export", match_listed("--finished"), "-o", out}).status, 0);
  EXPECT_EQ(support::run({BREAKSHOT_PROGRAM, "verify", out}).status, 0);
}

TEST_F(OnlineProgram, ABotClaimsTheMatchOfWhoHasVanished) {
  server_.emplace(BREAKSHOT_SERVER_PROGRAM, scratch_.path() / "other",
                  std::vector<std::string>{"--claim-after", "1"});
  Background ann(line({"play", "--new", "--name", "Ann"}), home(), "quit\n");
  const Finished bob = run({"bot", match_listed("--open"), "--name", "Bob", "--candidates", "20"});
  EXPECT_EQ(bob.status, 0) << bob.err;
  EXPECT_TRUE(has(bob.out, "Ann is away.")) << bob.out;
  EXPECT_TRUE(has(bob.out, "Bob wins the match")) << bob.out;
}

TEST_F(OnlineProgram, SaysWhatCannotBe) {
  const std::vector<std::pair<std::vector<std::string>, int>> wrong = {
      {{"watch"}, 2},
      {{"watch", "nonsense"}, 2},
      {{"watch", "0123456789abcdef"}, 1},
      {{"export", "0123456789abcdef"}, 1},
      {{"bot", "0123456789abcdef"}, 1},
      {{"bot", "--code", "ABCDE01234"}, 1},
      {{"bot", "--new", "0123456789abcdef"}, 2},
      {{"bot", "--race", "0"}, 2},
      {{"bot", "--race", "101"}, 2},
      {{"bot", "--game", "snooker"}, 2},
      {{"bot", "--new", "--preset", "snooker"}, 1},
      {{"bot", "--name", " "}, 2},
      {{"list", "--limit", "0"}, 2},
  };
  for (const auto& [words, status] : wrong) {
    const Finished finished = run(words);
    EXPECT_EQ(finished.status, status) << words.front() << ' ' << words.back() << finished.err;
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(finished.err.rfind("breakshot: ", 0), 0u) << finished.err;
  }
}

TEST_F(OnlineProgram, SaysWhereNoServerIs) {
  server_->kill();
  for (const char* command : {"list", "bot"}) {
    const Finished finished = run({command});
    EXPECT_EQ(finished.status, 1);
    EXPECT_TRUE(has(finished.err, "no server is listening there")) << finished.err;
  }
}

}  // namespace
}  // namespace breakshot::client
