// What is said and heard over a connection, right and wrong.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/net/exchange.hpp"

namespace breakshot::net {
namespace {

/// A well-formed ping whose frame has exactly `size` bytes in its body: an unknown field, which
/// every reader must pass over, makes up for the rest.
wire::ByteVector ping_of_size(std::size_t size) {
  wire::ByteVector frame = wire::frame_of(lobby::Asked{lobby::RequestId{1}, lobby::Ping{}});
  const std::size_t missing = size - (frame.size() - wire::frame_header_bytes);
  // Field 1000, length-delimited, with a length in three bytes.
  const std::size_t length = missing - 5;
  for (const std::size_t byte :
       {0xc2UL, 0x3eUL, (length & 0x7f) | 0x80, ((length >> 7) & 0x7f) | 0x80, length >> 14}) {
    frame.push_back(static_cast<std::uint8_t>(byte));
  }
  frame.resize(frame.size() + length, 'x');
  const auto header = wire::frame_header(static_cast<std::uint32_t>(size));
  std::copy(header.begin(), header.end(), frame.begin());
  return frame;
}

TEST(Talk, IsHeardBetweenOpenedAndClosed) {
  Exchange exchange;
  LineClient client(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  const lobby::Asked hello{lobby::RequestId{7}, lobby::Hello{1, "Ada", std::nullopt}};
  client.say(hello);
  client.say(lobby::Asked{lobby::RequestId{8}, lobby::Ping{}});
  const Asked first = exchange.hear<Asked>();
  EXPECT_EQ(first.connection, id);
  EXPECT_EQ(first.asked, hello);
  EXPECT_EQ(exchange.hear<Asked>().asked.id, lobby::RequestId{8});
  client.close();
  EXPECT_EQ(exchange.hear<hub::Closed>().connection, id);
}

TEST(Talk, IsHeardHoweverItsBytesArrive) {
  Exchange exchange;
  LineClient client(exchange.port());
  exchange.opened();
  const lobby::Asked hello{lobby::RequestId{7}, lobby::Hello{1, "Ada", std::nullopt}};
  for (const std::uint8_t byte : wire::frame_of(hello)) client.send({&byte, 1});
  EXPECT_EQ(exchange.hear<Asked>().asked, hello);
}

TEST(Talk, IsToldToAllThatAreMeant) {
  Exchange exchange;
  LineClient ada(exchange.port());
  const hub::ConnectionId first = exchange.opened();
  LineClient bob(exchange.port());
  const hub::ConnectionId second = exchange.opened();
  LineClient eve(exchange.port());
  const hub::ConnectionId third = exchange.opened();
  exchange.order([&](Switchboard& board) {
    for (const auto id : {first, second}) board.treat(id, hub::Standing::guest);
  });
  exchange.tell({first, second, hub::ConnectionId{999}}, big_news(5));
  exchange.tell({third}, lobby::Done{});
  EXPECT_EQ(ada.hear_a<lobby::EntryNews>(), big_news(5));
  EXPECT_EQ(bob.hear_a<lobby::EntryNews>(), big_news(5));
  eve.hear_a<lobby::Done>();
}

TEST(Talk, GoesOnAfterAWrongRequest) {
  Exchange exchange;
  LineClient client(exchange.port());
  exchange.opened();
  client.say(lobby::Asked{lobby::RequestId{3}, lobby::Hello{1, " ", std::nullopt}});
  const auto told = client.hear();
  ASSERT_TRUE(told);
  EXPECT_EQ(told->id, lobby::RequestId{3});
  const auto& refused = std::get<lobby::Refused>(told->answer);
  EXPECT_EQ(refused.code, lobby::RefusalCode::bad_request);
  EXPECT_NE(refused.what.find("hello.name"), std::string::npos) << refused.what;
  client.say(lobby::Ping{});
  EXPECT_TRUE(std::holds_alternative<lobby::Ping>(exchange.hear<Asked>().asked.request));
}

TEST(Talk, EndsWithBytesThatAreNotOfTheProtocolAndOthersGoOn) {
  Exchange exchange;
  LineClient good(exchange.port());
  exchange.opened();
  LineClient bad(exchange.port());
  const hub::ConnectionId bad_id = exchange.opened();
  bad.send(wire::ByteVector{0, 0, 0, 2, 0xff, 0xff});
  EXPECT_EQ(bad.hear_a<lobby::Goodbye>().reason, lobby::GoodbyeReason::bad_protocol);
  EXPECT_FALSE(bad.hear());
  bad.close();
  EXPECT_EQ(exchange.hear<hub::Closed>().connection, bad_id);
  good.say(lobby::Ping{});
  exchange.hear<Asked>();
}

TEST(Talk, EndsWithAFrameBeyondTheLimitWhichGrowsAfterHello) {
  Exchange exchange;
  LineClient stranger(exchange.port());
  exchange.opened();
  stranger.send(ping_of_size(wire::max_hello_frame));
  exchange.hear<Asked>();
  stranger.send(ping_of_size(wire::max_hello_frame + 1));
  EXPECT_EQ(stranger.hear_a<lobby::Goodbye>().reason, lobby::GoodbyeReason::bad_protocol);
  stranger.close();
  exchange.hear<hub::Closed>();

  LineClient guest(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  exchange.order([&](Switchboard& board) { board.treat(id, hub::Standing::guest); });
  guest.send(ping_of_size(wire::max_request_frame));
  exchange.hear<Asked>();
  guest.send(ping_of_size(wire::max_request_frame + 1));
  EXPECT_EQ(guest.hear_a<lobby::Goodbye>().reason, lobby::GoodbyeReason::bad_protocol);
}

TEST(Talk, IsSlowedDownForWhoeverAsksTooFast) {
  Limits limits = patient_limits();
  limits.request_burst = 2;
  limits.request_interval = std::chrono::milliseconds(20);
  Exchange exchange(limits);
  LineClient client(exchange.port());
  exchange.opened();
  const auto before = std::chrono::steady_clock::now();
  for (std::uint32_t i = 1; i <= 7; ++i) client.say(lobby::Ping{});
  for (std::uint32_t i = 1; i <= 7; ++i) {
    EXPECT_EQ(exchange.hear<Asked>().asked.id, lobby::RequestId{i});
  }
  // The burst, and then one an interval: a slow machine only makes it longer.
  EXPECT_GE(std::chrono::steady_clock::now() - before, 4 * limits.request_interval);
}

/// Says pings and is answered each of them, while hardly anything is read and written at a time.
void talk_in_batches(const Limits& limits) {
  constexpr std::uint32_t count = 1000;
  Exchange exchange(limits);
  LineClient client(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  wire::ByteVector pings;
  for (std::uint32_t i = 1; i <= count; ++i) {
    const auto frame = wire::frame_of(lobby::Asked{lobby::RequestId{i}, lobby::Ping{}});
    pings.insert(pings.end(), frame.begin(), frame.end());
  }
  client.send(pings);
  for (std::uint32_t i = 1; i <= count; ++i) {
    ASSERT_EQ(exchange.hear<Asked>().asked.id, lobby::RequestId{i});
  }
  exchange.order([&](Switchboard& board) {
    for (std::uint32_t i = 1; i <= count; ++i) {
      board.tell({id}, lobby::Told{lobby::RequestId{i}, lobby::Done{}});
    }
    board.report_drained(id);
  });
  for (std::uint32_t i = 1; i <= count; ++i) {
    const auto told = client.hear();
    ASSERT_TRUE(told);
    ASSERT_EQ(told->id, lobby::RequestId{i});
  }
  EXPECT_EQ(exchange.hear<hub::Drained>().connection, id);
}

TEST(Talk, IsHeardAndToldInManyBatches) {
  Limits limits = patient_limits();
  limits.request_interval = std::chrono::microseconds(0);
  limits.read_batch = 100;
  {
    SCOPED_TRACE("few bytes at a time");
    limits.write_batch = 50;
    talk_in_batches(limits);
  }
  {
    SCOPED_TRACE("few frames at a time");
    limits.write_batch = Limits{}.write_batch;
    limits.write_batch_frames = 7;
    talk_in_batches(limits);
  }
}

TEST(Talk, EndsInClosedWhenTheOtherSideResets) {
  Exchange exchange;
  LineClient client(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  client.reset();
  EXPECT_EQ(exchange.hear<hub::Closed>().connection, id);
}

TEST(Talk, IsSentToItsEndBeforeClosing) {
  Exchange exchange;
  LineClient client(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  exchange.order([&](Switchboard& board) {
    board.treat(id, hub::Standing::player);
    for (std::uint32_t i = 0; i < 50; ++i) board.tell({id}, lobby::Told{{}, big_news(i)});
    board.close(id);
    board.tell({id}, lobby::Told{{}, lobby::Done{}});  // too late
  });
  client.say(lobby::Ping{});  // not heard any more
  for (std::uint32_t i = 0; i < 50; ++i) EXPECT_EQ(seq_of(client.hear_a<lobby::EntryNews>()), i);
  EXPECT_FALSE(client.hear());
  client.close();
  EXPECT_EQ(exchange.hear<hub::Closed>().connection, id);
}

TEST(Talk, HasDrainedOnlyWhenTheSocketHasTakenAllOfIt) {
  Exchange exchange;
  LineClient client({"127.0.0.1", 4096});
  client.connect(exchange.port());
  const hub::ConnectionId id = exchange.opened();
  exchange.order([&](Switchboard& board) { board.report_drained(id); });
  EXPECT_EQ(exchange.hear<hub::Drained>().connection, id) << "nothing waits";
  // More than the system keeps for a connection, so that some of it waits here.
  constexpr std::uint32_t count = 120;
  exchange.order([&](Switchboard& board) {
    board.treat(id, hub::Standing::player);
    for (std::uint32_t i = 0; i < count; ++i) board.tell({id}, lobby::Told{{}, big_news(i)});
    board.report_drained(id);
  });
  EXPECT_TRUE(exchange.silent());
  for (std::uint32_t i = 0; i < count; ++i) client.hear_a<lobby::EntryNews>();
  EXPECT_EQ(exchange.hear<hub::Drained>().connection, id);
}

}  // namespace
}  // namespace breakshot::net
