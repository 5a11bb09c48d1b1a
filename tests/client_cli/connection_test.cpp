// The connection against servers in a thread of the test's own, which hang up, stay silent or talk
// nonsense.
#include "client_cli/online/connection.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "client_cli/command_error.hpp"
#include "client_cli/online/match_view.hpp"
#include "tests/client_cli/one_match_server.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/subprocess.hpp"

namespace breakshot::client {
namespace {

using support::LoopbackServer;
using support::Peer;

constexpr Milliseconds long_enough{20'000};

Patience hasty() {
  Patience patience;
  patience.first_retry = Milliseconds(1);
  patience.longest_retry = Milliseconds(4);
  return patience;
}

ServerAddress at(std::uint16_t port) {
  return {"127.0.0.1", port};
}

void ignore(const std::string&) {}

Connection stranger(std::uint16_t port, const Patience& patience = hasty()) {
  return {at(port), Guest{"Ann", std::nullopt}, ignore, patience};
}

match::Seq seq(std::size_t n) {
  return match::Seq(n);
}

/// Plays a match of five entries and returns the numbers of the entries as one text: in the order
/// in which they were told, and, with a plus, in that of the record fetched at last.
std::string play(Connection& connection) {
  std::string told;
  std::size_t next = 0;
  const auto hear = [&](std::size_t entries) {
    while (next < entries) {
      const auto news = connection.next(long_enough);
      if (!news) return;
      if (const auto* entry = std::get_if<EntryPtr>(&*news)) {
        told += std::to_string(static_cast<std::uint32_t>((*entry)->seq)) + " ";
        ++next;
      }
    }
  };
  const auto created =
      connection.ask(lobby::Create{"", match::GameKind::practice, 1, 1, false, {}});
  const match::MatchId id = std::get<lobby::MatchNews>(created).info.id;
  EXPECT_TRUE(std::holds_alternative<lobby::Done>(connection.ask(lobby::Contribute{id, {9}})));
  hear(1);
  const std::vector<match::Command> commands = {
      match::Place{physics::BallId{0}, {-0.7, 0.1}}, match::Place{physics::BallId{5}, {0, 0.2}},
      match::Place{physics::BallId{0}, {-0.8, 0.1}}, match::Concede{}};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const auto answer =
        connection.ask(lobby::Act{id, seq(i + 1), match::CommandId{100 + i}, commands[i]});
    const auto* news = std::get_if<lobby::EntryNews>(&answer);
    if (news == nullptr) return told + "refused";
    EXPECT_EQ(news->entry->seq, seq(i + 1));
    hear(i + 2);
  }
  const auto fetched = connection.fetch({id, std::nullopt, {}});
  for (const auto& entry : std::get<record::Record>(fetched).entries) {
    told += '+' + std::to_string(static_cast<std::uint32_t>(entry.seq));
  }
  return told;
}

const std::string whole_match = "0 1 2 3 4 +0+1+2+3+4";

TEST(Connection, TellsEachEntryOnce) {
  OneMatchServer server;
  Connection connection = stranger(server.port());
  EXPECT_EQ(play(connection), whole_match);
}

TEST(Connection, ContinuesWhereItWasWhereverItIsCut) {
  int steps = 0;
  {
    OneMatchServer server;
    Connection connection = stranger(server.port());
    play(connection);
    steps = server.steps();
  }
  ASSERT_GT(steps, 12);
  // The hello of the first attempt is not repeated: its two steps come before all others.
  for (int cut_at = 3; cut_at <= steps; ++cut_at) {
    OneMatchServer server(cut_at);
    int lost = 0;
    Connection connection(
        at(server.port()), Guest{"Ann", std::nullopt},
        [&](const std::string& what) { lost += what.starts_with("connection lost"); }, hasty());
    EXPECT_EQ(play(connection), whole_match) << "cut at step " << cut_at << " of " << steps;
    EXPECT_TRUE(server.has_cut()) << cut_at;
    EXPECT_EQ(lost, 1) << cut_at;
  }
}

TEST(Connection, FollowsFromTheEntryThatIsAskedFor) {
  OneMatchServer server;
  Connection connection = stranger(server.port());
  play(connection);
  const auto answer = connection.ask(lobby::Watch{match::MatchId{0x1234}, std::nullopt, seq(3)});
  ASSERT_TRUE(std::holds_alternative<lobby::MatchNews>(answer));
  const auto news = connection.next(long_enough);
  ASSERT_TRUE(news);
  EXPECT_EQ(std::get<EntryPtr>(*news)->seq, seq(3));
}

TEST(Connection, KeepsANewGuestsTokenAndShowsItAgain) {
  const support::Scratch scratch;
  const TokenStore store(scratch.path());
  OneMatchServer server;
  for (int i = 0; i < 2; ++i) {
    const Connection connection(at(server.port()), Guest{"Ann", store}, ignore, hasty());
    EXPECT_EQ(connection.welcome().token.has_value(), i == 0);
    EXPECT_EQ(store.load(at(server.port()), "Ann"), OneMatchServer::token);
  }
}

TEST(Connection, BecomesANewGuestWhereTheServerKnowsTheTokenNoMore) {
  const support::Scratch scratch;
  const TokenStore store(scratch.path());
  OneMatchServer server;
  store.save(at(server.port()), "Ann", lobby::Token{7});
  std::vector<std::string> notices;
  const Connection connection(
      at(server.port()), Guest{"Ann", store},
      [&](const std::string& what) { notices.push_back(what); }, hasty());
  EXPECT_EQ(store.load(at(server.port()), "Ann"), OneMatchServer::token);
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_NE(notices[0].find("Ann"), std::string::npos);
  // The old token is not lost, and the notice says where it is.
  const std::string aside = store.file_of(at(server.port()), "Ann").string() + '~';
  EXPECT_NE(notices[0].find(aside), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(aside));
}

/// What the CommandError says with which `act` ends.
template <class Act>
std::string complaint_of(const Act& act) {
  try {
    act();
  } catch (const CommandError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(Connection, SaysWhereNoServerListens) {
  std::uint16_t port = 0;
  {
    const OneMatchServer gone;
    port = gone.port();
  }
  EXPECT_EQ(
      complaint_of([&] { stranger(port); }),
      "cannot connect to 127.0.0.1:" + std::to_string(port) + ": no server is listening there");
}

TEST(Connection, RepeatsWhatAServerOfAnotherVersionSays) {
  LoopbackServer server([](Peer& peer) {
    while (const auto asked = peer.hear()) {
      peer.tell(asked->id, lobby::Refused{lobby::RefusalCode::unsupported_version, std::nullopt,
                                          "this server speaks version 9"});
    }
  });
  const std::string complaint = complaint_of([&] { stranger(server.port()); });
  EXPECT_NE(complaint.find("this server speaks version 9"), std::string::npos) << complaint;
}

TEST(Connection, DoesNotComeBackOnceItIsTakenOver) {
  std::atomic<int> connections{0};
  LoopbackServer server([&](Peer& peer) {
    ++connections;
    while (const auto asked = peer.hear()) {
      if (std::holds_alternative<lobby::Hello>(asked->request)) {
        peer.tell(asked->id, lobby::Welcome{"Ann", std::nullopt, "test", 0});
      } else {
        peer.tell(lobby::RequestId{0},
                  lobby::Goodbye{lobby::GoodbyeReason::taken_over, "elsewhere"});
        return;
      }
    }
  });
  {
    Connection connection = stranger(server.port());
    const std::string complaint = complaint_of([&] { connection.ask(lobby::List{}); });
    EXPECT_NE(complaint.find("elsewhere"), std::string::npos) << complaint;
  }
  EXPECT_EQ(connections, 1);
}

TEST(Connection, AsksAgainWhatWasUnavailable) {
  std::atomic<int> asked_for{0};
  LoopbackServer server([&](Peer& peer) {
    while (const auto asked = peer.hear()) {
      if (std::holds_alternative<lobby::Hello>(asked->request)) {
        peer.tell(asked->id, lobby::Welcome{"Ann", std::nullopt, "test", 0});
      } else if (++asked_for == 1) {
        peer.tell(asked->id, lobby::Refused{lobby::RefusalCode::unavailable, std::nullopt,
                                            "the disk is full"});
      } else {
        peer.tell(asked->id, lobby::Listing{{}, false});
      }
    }
  });
  Connection connection = stranger(server.port());
  EXPECT_TRUE(std::holds_alternative<lobby::Listing>(connection.ask(lobby::List{})));
  EXPECT_EQ(asked_for, 2);
}

TEST(Connection, GivesUpOnAServerThatStaysSilent) {
  LoopbackServer server([](Peer& peer) {
    while (const auto asked = peer.hear()) {
      if (!std::holds_alternative<lobby::Hello>(asked->request)) continue;
      peer.tell(asked->id, lobby::Welcome{"Ann", std::nullopt, "test", 0});
    }
  });
  Patience patience = hasty();
  patience.answer = Milliseconds(20);
  patience.give_up = Milliseconds(0);
  Connection connection = stranger(server.port(), patience);
  const std::string complaint = complaint_of([&] { connection.ask(lobby::List{}); });
  EXPECT_NE(complaint.find("the server does not answer"), std::string::npos) << complaint;
}

TEST(Connection, AsksASilentServerWhetherItIsThere) {
  std::atomic<int> pings{0};
  LoopbackServer server([&](Peer& peer) {
    while (const auto asked = peer.hear()) {
      if (std::holds_alternative<lobby::Hello>(asked->request)) {
        peer.tell(asked->id, lobby::Welcome{"Ann", std::nullopt, "test", 0});
      } else if (std::holds_alternative<lobby::Ping>(asked->request)) {
        peer.tell(asked->id, lobby::Done{});
        if (++pings == 3) return;
      }
    }
  });
  Patience patience = hasty();
  patience.quiet = Milliseconds(10);
  patience.give_up = Milliseconds(0);
  // The server hangs up after the third ping: until then the silence is none.
  {
    Connection connection = stranger(server.port(), patience);
    complaint_of([&] { connection.next(long_enough); });
  }
  EXPECT_EQ(pings, 3);
}

TEST(Connection, RefusesWhatIsNotTheProtocol) {
  for (const std::vector<std::uint8_t>& nonsense :
       {std::vector<std::uint8_t>{0xff, 0xff, 0xff, 0xff},
        std::vector<std::uint8_t>{0, 0, 0, 2, 0xff, 0xff}}) {
    LoopbackServer server([&](Peer& peer) {
      peer.hear();
      peer.say(nonsense);
      peer.hear();
    });
    const std::string complaint = complaint_of([&] { stranger(server.port()); });
    EXPECT_NE(complaint.find("127.0.0.1"), std::string::npos) << complaint;
  }
}

TEST(Connection, ReturnsWhereSomethingElseWantsAttention) {
  OneMatchServer server;
  Connection connection = stranger(server.port());
  support::detail::Pipe pipe;
  ASSERT_EQ(::write(pipe.write_end, "x", 1), 1);
  EXPECT_FALSE(connection.next(long_enough, pipe.read_end));
}

}  // namespace
}  // namespace breakshot::client
