// The server as a program: what it refuses, what it prints, how it ends.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <future>
#include <string>
#include <vector>

#include "server/config.hpp"
#include "server/shell/shell.hpp"
#include "tests/support/line_client.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/server_process.hpp"

namespace breakshot::server {
namespace {

using support::Finished;
using support::Scratch;
using support::ServerProcess;

Finished run_server(std::vector<std::string> options) {
  options.insert(options.begin(), BREAKSHOT_SERVER_PROGRAM);
  return support::run(options);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Program, HelpsAndSaysItsVersion) {
  const Finished help = run_server({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* option : {"--bind", "--port", "--data", "--log-level", "--config"}) {
    EXPECT_TRUE(has(help.out, option)) << option;
  }
  const Finished version = run_server({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(has(version.out, "breakshot-server ")) << version.out;
}

TEST(Program, RefusesABadConfigurationWithTheReason) {
  const Scratch scratch;
  const std::string file = (scratch.path() / "config").string();
  std::ofstream(file) << "prot = 1\n";
  const std::vector<std::pair<std::vector<std::string>, std::string>> bad = {
      {{"--port", "65536"}, "--port"},
      {{"--port", "-1"}, "--port"},
      {{"--port", "pool"}, "--port"},
      {{"--bind", "example.org"}, "'example.org' is no IPv4 or IPv6 address"},
      {{"--log-level", "loud"}, "--log-level"},
      {{"--data", ""}, "--data"},
      {{"--connections", "0"}, "--connections"},
      {{"--claim-after", "0"}, "--claim-after"},
      {{"--config", file}, "prot"},
      {{"--config", file + "2"}, file + "2"},
      {{"--prot", "1"}, "--prot"},
      {{"more"}, "more"},
  };
  for (const auto& [options, reason] : bad) {
    const Finished finished = run_server(options);
    EXPECT_EQ(finished.status, 2) << options.front();
    EXPECT_EQ(finished.out, "");
    EXPECT_TRUE(has(finished.err, reason)) << finished.err;
  }
}

TEST(Program, ReadsOptionsFromAFile) {
  const Scratch scratch;
  const std::string file = (scratch.path() / "config").string();
  std::ofstream(file) << "port = 1234\nbind = \"::1\"\nlog-level = \"warn\"\nclaim-after = 5\n";
  const std::vector<const char*> words = {"breakshot-server", "--config", file.c_str()};
  const auto config = config_of(static_cast<int>(words.size()), words.data());
  ASSERT_TRUE(std::holds_alternative<Config>(config)) << std::get<Exit>(config).err;
  const Config& read = std::get<Config>(config);
  EXPECT_EQ(read.shell.port, 1234);
  EXPECT_EQ(read.shell.address, "::1");
  EXPECT_EQ(read.log_level, "warn");
  EXPECT_EQ(read.shell.hub.claim_after, std::chrono::seconds(5));
}

TEST(Program, SaysHowOthersJoin) {
  EXPECT_EQ(join_command("127.0.0.1", 7665), "breakshot play --server 127.0.0.1:7665");
  EXPECT_EQ(join_command("::1", 7665), "breakshot play --server [::1]:7665");
  EXPECT_FALSE(has(join_command("0.0.0.0", 7665), "0.0.0.0")) << "nobody can connect to that";
}

TEST(Program, FailsClearlyWhereItCannotServe) {
  const Scratch scratch;
  const std::string file = (scratch.path() / "file").string();
  std::ofstream(file) << "no directory";
  const Finished no_directory = run_server({"--port", "0", "--data", file});
  EXPECT_EQ(no_directory.status, 1);
  EXPECT_TRUE(has(no_directory.err, file)) << no_directory.err;

  const std::string data = (scratch.path() / "data").string();
  const ServerProcess server(BREAKSHOT_SERVER_PROGRAM, data);
  const std::string other = (scratch.path() / "other").string();
  const std::string port = std::to_string(server.port());
  const Finished port_in_use = run_server({"--port", port, "--data", other});
  EXPECT_EQ(port_in_use.status, 1);
  EXPECT_TRUE(has(port_in_use.err, port)) << port_in_use.err;
  const Finished data_in_use = run_server({"--port", "0", "--data", data});
  EXPECT_EQ(data_in_use.status, 1);
  EXPECT_TRUE(has(data_in_use.err, data)) << data_in_use.err;

  std::ofstream(scratch.path() / "other" / "breakshot.sqlite", std::ios::trunc)
      << std::string(5000, 'x');
  const Finished no_database = run_server({"--port", "0", "--data", other});
  EXPECT_EQ(no_database.status, 1);
  EXPECT_TRUE(has(no_database.err, "breakshot.sqlite")) << no_database.err;
}

TEST(Program, StopsCleanlyOnEitherSignal) {
  const Scratch scratch;
  for (const int signal : {SIGTERM, SIGINT}) {
    ServerProcess server(BREAKSHOT_SERVER_PROGRAM, scratch.path() / "data");
    support::LineClient client(server.port());
    client.say(lobby::Hello{lobby::protocol_version, "Ada", std::nullopt});
    client.hear_a<lobby::Welcome>();
    server.signal(signal);
    EXPECT_EQ(client.hear_a<lobby::Goodbye>().reason, lobby::GoodbyeReason::stopping);
    EXPECT_FALSE(client.hear());
    client.close();
    EXPECT_EQ(server.wait(), 0);
  }
}

TEST(Program, StopsAlthoughClientsStay) {
  const Scratch scratch;
  shell::Settings settings;
  settings.database = scratch.path() / "matches.db";
  settings.net.close_deadline = std::chrono::milliseconds(50);
  shell::Shell shell(settings);
  const auto stopped = std::async(std::launch::async, [&] { shell.run(); });
  support::LineClient stranger(shell.port());
  support::LineClient guest(shell.port());
  guest.say(lobby::Hello{lobby::protocol_version, "Ada", std::nullopt});
  guest.hear_a<lobby::Welcome>();
  ::kill(::getpid(), SIGTERM);
  EXPECT_EQ(guest.hear_a<lobby::Goodbye>().reason, lobby::GoodbyeReason::stopping);
  EXPECT_EQ(stopped.wait_for(support::patience), std::future_status::ready);
}

}  // namespace
}  // namespace breakshot::server
