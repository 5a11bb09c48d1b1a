#include "client_cli/server_address.hpp"

#include <gtest/gtest.h>

#include "common/lobby/lobby.hpp"

namespace breakshot::client {
namespace {

using lobby::default_port;

TEST(ServerAddress, TakesTheDefaultPortWhereNoneIsGiven) {
  EXPECT_EQ(server_address_of("pool.example"), (ServerAddress{"pool.example", default_port}));
  EXPECT_EQ(server_address_of("[::1]"), (ServerAddress{"::1", default_port}));
  EXPECT_EQ(server_address_of("fe80::1"), (ServerAddress{"fe80::1", default_port}));
}

TEST(ServerAddress, ReadsThePort) {
  EXPECT_EQ(server_address_of("127.0.0.1:9"), (ServerAddress{"127.0.0.1", 9}));
  EXPECT_EQ(server_address_of("[::1]:65535"), (ServerAddress{"::1", 65535}));
}

TEST(ServerAddress, RefusesWhatIsNoAddress) {
  for (const char* text : {"", ":9", "host:", "host:0", "host:65536", "host:9x", "host: 9", "[]:9",
                           "[::1", "[::1]9", "host:-1"}) {
    EXPECT_FALSE(server_address_of(text)) << text;
  }
}

TEST(ServerAddress, WritesWhatItReads) {
  for (const char* text : {"127.0.0.1:9", "[::1]:80", "pool.example:7665"}) {
    const auto address = server_address_of(text);
    ASSERT_TRUE(address) << text;
    EXPECT_EQ(text_of(*address), text);
  }
}

}  // namespace
}  // namespace breakshot::client
