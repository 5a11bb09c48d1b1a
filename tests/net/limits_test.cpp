// Every limit of carrying is reached, and what happens then happens to nobody else.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <deque>
#include <string>
#include <vector>

#include "tests/net/exchange.hpp"

namespace breakshot::net {
namespace {

using lobby::GoodbyeReason;
using std::chrono::milliseconds;

TEST(Deadline, OfHelloIsForStrangersOnly) {
  Limits limits = patient_limits();
  limits.hello_deadline = milliseconds(50);
  Exchange exchange(limits);
  exchange.welcome_as(hub::Standing::guest);
  LineClient guest(exchange.port());
  const hub::ConnectionId guest_id = exchange.opened();
  exchange.welcome_as(hub::Standing::stranger);
  LineClient stranger(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  EXPECT_EQ(stranger.hear_a<lobby::Goodbye>().reason, GoodbyeReason::idle);
  EXPECT_FALSE(stranger.hear());
  stranger.close();
  EXPECT_EQ(exchange.hear<hub::Closed>().connection, id);
  guest.say(lobby::Ping{});
  EXPECT_EQ(exchange.hear<Asked>().connection, guest_id);
}

TEST(Deadline, OfSilenceEndsAConnection) {
  Limits limits = patient_limits();
  limits.idle_deadline = milliseconds(50);
  Exchange exchange(limits);
  LineClient client(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  exchange.order([&](Switchboard& board) { board.treat(id, hub::Standing::player); });
  EXPECT_EQ(client.hear_a<lobby::Goodbye>().reason, GoodbyeReason::idle);
}

TEST(Deadline, OfWritingEndsAConnectionThatTakesNothing) {
  Limits limits = patient_limits();
  limits.write_deadline = milliseconds(50);
  Exchange exchange(limits);
  LineClient client({"127.0.0.1", 4096});
  client.connect(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  exchange.order([&](Switchboard& board) {
    board.treat(id, hub::Standing::player);
    for (std::uint32_t i = 0; i < 120; ++i) board.tell({id}, lobby::Told{{}, big_news(i)});
  });
  EXPECT_EQ(exchange.hear<hub::Closed>().connection, id);
}

TEST(Deadline, OfClosingEndsAConnectionThatStays) {
  Limits limits = patient_limits();
  limits.close_deadline = milliseconds(50);
  Exchange exchange(limits);
  LineClient client(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  exchange.order([&](Switchboard& board) { board.close(id); });
  EXPECT_FALSE(client.hear());
  EXPECT_EQ(exchange.hear<hub::Closed>().connection, id) << "although the client has not closed";
}

/// Tells two connections news until far more waits than `limits` let one of them have. The reader
/// must get all, whatever becomes of the other.
void flood(Exchange& exchange, LineClient& reader, const std::vector<hub::ConnectionId>& both,
           std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    exchange.tell(both, big_news(i));
    EXPECT_EQ(seq_of(reader.hear_a<lobby::EntryNews>()), i);
  }
}

/// Of two at the same match, with that standing, one does not read.
void overflow(const Limits& limits, hub::Standing standing) {
  Exchange exchange(limits);
  LineClient slow({"127.0.0.1", 4096});
  slow.connect(exchange.port());
  const hub::ConnectionId slow_id = exchange.opened();
  LineClient reader(exchange.port());
  const hub::ConnectionId reader_id = exchange.opened();
  exchange.order([&](Switchboard& board) {
    board.treat(slow_id, standing);
    board.treat(reader_id, standing);
  });
  flood(exchange, reader, {slow_id, reader_id}, 120);

  // What it got is whole and has no gap, so it knows from where to watch again.
  std::uint32_t next = 0;
  while (true) {
    const auto told = slow.hear();
    ASSERT_TRUE(told) << "closed without a goodbye";
    if (const auto* goodbye = std::get_if<lobby::Goodbye>(&told->answer)) {
      EXPECT_EQ(goodbye->reason, GoodbyeReason::too_slow);
      break;
    }
    EXPECT_EQ(seq_of(std::get<lobby::EntryNews>(told->answer)), next++);
  }
  EXPECT_LT(next, 120u);
  EXPECT_FALSE(slow.hear());
  slow.close();
  EXPECT_EQ(exchange.hear<hub::Closed>().connection, slow_id);
}

TEST(Queue, OfASlowReaderEndsInGoodbyeAndOthersGoOn) {
  Limits limits = patient_limits();
  limits.guest_queue = 1024 * 1024;
  overflow(limits, hub::Standing::guest);
}

TEST(Queue, OfAPlayerHasItsEndToo) {
  Limits limits = patient_limits();
  limits.player_queue = 1024 * 1024;
  overflow(limits, hub::Standing::player);
}

TEST(Queue, OfAPlayerIsLonger) {
  Limits limits = patient_limits();
  limits.guest_queue = 1024 * 1024;
  Exchange exchange(limits);
  LineClient slow({"127.0.0.1", 4096});
  slow.connect(exchange.port());
  const hub::ConnectionId slow_id = exchange.opened();
  LineClient reader(exchange.port());
  const hub::ConnectionId reader_id = exchange.opened();
  exchange.order([&](Switchboard& board) {
    board.treat(slow_id, hub::Standing::player);
    board.treat(reader_id, hub::Standing::guest);
  });
  flood(exchange, reader, {slow_id, reader_id}, 120);
  for (std::uint32_t i = 0; i < 120; ++i) EXPECT_EQ(seq_of(slow.hear_a<lobby::EntryNews>()), i);
}

TEST(Queue, OfAStrangerHoldsHardlyAnything) {
  Exchange exchange;
  LineClient stranger(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  exchange.tell({id}, big_news(1));
  EXPECT_EQ(stranger.hear_a<lobby::Goodbye>().reason, GoodbyeReason::too_slow);
}

TEST(Connections, HaveALimitAndPlacesAreFreedAgain) {
  Limits limits = patient_limits();
  limits.connections = 2;
  Exchange exchange(limits);
  LineClient first(exchange.port());
  const hub::ConnectionId first_id = exchange.opened();
  LineClient second(exchange.port());
  exchange.opened();
  LineClient third(exchange.port());
  third.say(lobby::Ping{});
  EXPECT_EQ(third.hear_a<lobby::Goodbye>().reason, GoodbyeReason::too_many);
  EXPECT_FALSE(third.hear());
  first.close();
  EXPECT_EQ(exchange.hear<hub::Closed>().connection, first_id) << "the third is not heard of";
  LineClient fourth(exchange.port());
  exchange.opened();
  fourth.say(lobby::Ping{});
  exchange.hear<Asked>();
}

TEST(Connections, HaveALimitForEachAddress) {
  Limits limits = patient_limits();
  limits.connections_per_address = 1;
  Exchange exchange(limits);
  LineClient first(exchange.port());
  exchange.opened();
  LineClient second(exchange.port());
  EXPECT_EQ(second.hear_a<lobby::Goodbye>().reason, GoodbyeReason::too_many);
  LineClient elsewhere({"127.0.0.2", 0});
  elsewhere.connect(exchange.port());
  exchange.opened();
  first.close();
  exchange.hear<hub::Closed>();
  LineClient again(exchange.port());
  exchange.opened();
}

TEST(Connections, ThatAreTurnedAwayInNumbersAreJustClosed) {
  Limits limits = patient_limits();
  limits.connections = 1;
  limits.turned_away = 1;
  Exchange exchange(limits);
  LineClient first(exchange.port());
  exchange.opened();
  LineClient second(exchange.port());
  second.hear_a<lobby::Goodbye>();
  LineClient third(exchange.port());
  EXPECT_FALSE(third.hear());
}

TEST(Connections, AreAcceptedAgainAfterTheSystemHadNoDescriptorsLeft) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer of undefined behaviour, in the same build, looks at objects "
                  "through a pipe: it needs descriptors of its own";
#endif
  Limits limits = patient_limits();
  limits.accept_pause = milliseconds(5);
  Exchange exchange(limits);
  LineClient client;  // has its descriptor already
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const int lowest_free = ::dup(0);
  ASSERT_GE(lowest_free, 0);
  ::close(lowest_free);
  rlimit none = before;
  none.rlim_cur = static_cast<rlim_t>(lowest_free);
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  client.connect(exchange.port());
  client.send(wire::frame_of(lobby::Asked{lobby::RequestId{1}, lobby::Ping{}}));
  exchange.order([](Switchboard&) {});
  EXPECT_TRUE(exchange.silent());
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  exchange.opened();
  exchange.hear<Asked>();
}

TEST(Connections, WaitInAShortLineUntilTheyAreAccepted) {
  Limits limits = patient_limits();
  limits.backlog = 2;
  boost::asio::io_context context;  // not run yet: nobody is accepted
  std::size_t opened = 0;
  std::deque<LineClient> clients;
  Switchboard board(context, "127.0.0.1", 0, limits, [&](const Heard& heard) {
    if (std::holds_alternative<hub::Opened>(heard)) ++opened;
    if (opened == clients.size()) context.stop();
  });
  std::size_t in_line = 0;
  do {
    clients.emplace_back();
    if (!clients.back().connects(board.port(), milliseconds(100))) break;
  } while (++in_line < 20);
  EXPECT_LE(in_line, 3u) << "Linux lets one more wait than it is told";
  context.run_for(patience);
  EXPECT_EQ(opened, clients.size()) << "whoever found no place in the line has tried again";
}

TEST(Listening, SaysWhyItCannotBe) {
  Exchange exchange;
  boost::asio::io_context context;
  const auto attempt = [&](const std::string& address, std::uint16_t port) -> std::string {
    try {
      Switchboard board(context, address, port, Limits{}, [](Heard) {});
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(attempt("127.0.0.1", exchange.port()), "cannot listen at 127.0.0.1 port " +
                                                       std::to_string(exchange.port()) +
                                                       ": Address already in use");
  EXPECT_EQ(attempt("localhost", 0), "cannot listen at 'localhost': it is no IPv4 or IPv6 address");
  EXPECT_NE(attempt("192.0.2.1", 0), "") << "nobody has this address";
}

TEST(Listening, EndsWhenToldAndReportsWhenEverybodyIsGone) {
  Exchange exchange;
  LineClient client(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  std::promise<void> empty;
  exchange.order([&](Switchboard& board) {
    board.stop_listening();
    board.when_empty([&] { empty.set_value(); });
  });
  EXPECT_THROW(LineClient{exchange.port()}, std::system_error);
  exchange.order([&](Switchboard& board) { board.close(id); });
  EXPECT_FALSE(client.hear());
  client.close();
  EXPECT_EQ(empty.get_future().wait_for(patience), std::future_status::ready);
}

}  // namespace
}  // namespace breakshot::net
