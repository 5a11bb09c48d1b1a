// Sitting down and playing, against servers in a thread of the test's own.
#include "client_cli/online/player.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client_cli/command_error.hpp"
#include "tests/support/loopback_server.hpp"

namespace breakshot::client {
namespace {

using support::LoopbackServer;
using support::Peer;

/// Hangs up on every other Create, and refuses the others.
void lose_every_other_answer(Peer& peer, std::vector<lobby::Create>& asked) {
  while (const auto heard = peer.hear()) {
    if (std::holds_alternative<lobby::Hello>(heard->request)) {
      peer.tell(heard->id, lobby::Welcome{"Ann", std::nullopt, "test", 0});
    } else if (std::holds_alternative<lobby::List>(heard->request)) {
      peer.tell(heard->id, lobby::Listing{{}, false});
    } else if (const auto* create = std::get_if<lobby::Create>(&heard->request)) {
      asked.push_back(*create);
      if (asked.size() % 2 == 1) return;
      peer.tell(heard->id,
                lobby::Refused{lobby::RefusalCode::too_many, std::nullopt, "no more room"});
    }
  }
}

TEST(SitDown, AsksForANewMatchAgainWithTheSameKeyAndForAnotherWithAnother) {
  std::vector<lobby::Create> asked;
  {
    LoopbackServer server([&](Peer& peer) { lose_every_other_answer(peer, asked); });
    Patience patience;
    patience.first_retry = Milliseconds(1);
    Connection connection(
        {"127.0.0.1", server.port()}, Guest{"Ann", std::nullopt}, [](const std::string&) {},
        patience);
    for (const Opening& opening : {Opening(lobby::Create{}), Opening(AnyMatch{})}) {
      EXPECT_THROW(sit_down(connection, opening), CommandError);
    }
  }
  ASSERT_EQ(asked.size(), 4u);
  EXPECT_EQ(asked[0], asked[1]);
  EXPECT_EQ(asked[2], asked[3]);
  EXPECT_TRUE(asked[0].key);
  EXPECT_TRUE(asked[2].key);
  EXPECT_NE(asked[0].key, asked[2].key);
}

}  // namespace
}  // namespace breakshot::client
