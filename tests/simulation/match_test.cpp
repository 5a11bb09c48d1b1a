// Whole matches against the real server, over real sockets, through everything that may happen to
// it.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <variant>

#include "tests/simulation/evening.hpp"

namespace breakshot::simulation {
namespace {

using Clock = std::chrono::steady_clock;

TEST(Simulation, TwoPlayAndOneWatchesAWholeMatchWhoseRecordVerifies) {
  constexpr std::uint64_t seed = 1;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Evening evening(seed);
  evening.begin();
  evening.finish(30);
  const record::Record record = evening.checked_record();
  EXPECT_GE(record.entries.size(), 2u);  // the start and at least one command
  EXPECT_TRUE(record.entries.back().secret);
  const auto listing =
      evening.eve().ask_for<lobby::Listing>(lobby::List{lobby::Filter::finished, std::nullopt});
  ASSERT_EQ(listing.matches.size(), 1u);
  EXPECT_EQ(listing.matches.front().id, record.header.id);
  EXPECT_EQ(listing.matches.front().winner, record.entries.back().outcome.status.winner);
}

TEST(Simulation, APrivateMatchIsPlayedByItsCode) {
  Evening evening(2);
  lobby::Create create;
  create.is_private = true;
  evening.begin(create);
  const auto listing =
      evening.eve().ask_for<lobby::Listing>(lobby::List{lobby::Filter::running, std::nullopt});
  EXPECT_TRUE(listing.matches.empty());
  const lobby::Answer answer =
      evening.eve().ask(lobby::Watch{evening.ada().match(), std::nullopt, {}});
  EXPECT_EQ(std::get<lobby::Refused>(answer).code, lobby::RefusalCode::no_such_match);
  evening.finish(5);
  evening.checked_record();
}

TEST(Simulation, AStoppedServerSaysGoodbyeAndTheMatchGoesOnLater) {
  Evening evening(3);
  do {
    evening.begin();
    for (int i = 0; i < 4 && evening.running(); ++i) evening.step();
  } while (!evening.running());  // now and then a match is over as soon as that
  evening.server().signal(SIGTERM);
  for (Guest* guest : {&evening.ada(), &evening.bob(), &evening.eve()}) {
    EXPECT_EQ(guest->await_goodbye().reason, lobby::GoodbyeReason::stopping);
  }
  EXPECT_EQ(evening.server().wait(), 0);
  evening.resume();  // checks that everybody is back at the same seat
  evening.finish(6);
  evening.checked_record();
}

/// A match that goes on, on a disk that is full.
std::unique_ptr<Evening> evening_on_a_full_disk() {
  for (std::uint64_t seed = 5;; ++seed) {
    auto evening = std::make_unique<Evening>(seed);
    evening->begin();
    evening->server().kill();
    evening->resume({128 * 1024});
    while (evening->running() && evening->step()) {
    }
    // Now and then a match is over before the disk is full.
    if (evening->running()) return evening;
  }
}

TEST(Simulation, AFullDiskRefusesCommandsAndLosesNothing) {
  const auto full = evening_on_a_full_disk();
  Evening& evening = *full;
  evening.ada().ask_for<lobby::Done>(lobby::Ping{});
  evening.server().signal(SIGTERM);
  for (Guest* guest : {&evening.ada(), &evening.bob(), &evening.eve()}) guest->await_goodbye();
  EXPECT_EQ(evening.server().wait(), 0);
  evening.resume();
  evening.finish(3);
  evening.checked_record();
}

TEST(Simulation, AVanishedOpponentLosesTheMatchToAClaim) {
  Evening evening(6, {"--claim-after", "1"});
  evening.begin();
  evening.bob().disconnect();
  const auto deadline = Clock::now() + support::patience;
  std::optional<lobby::Answer> answer;
  while (Clock::now() < deadline) {
    answer = evening.ada().ask(lobby::Claim{evening.ada().match()});
    const auto* refused = std::get_if<lobby::Refused>(&*answer);
    if (refused == nullptr) break;
    ASSERT_EQ(refused->code, lobby::RefusalCode::too_early) << refused->what;
  }
  const auto* news = std::get_if<lobby::EntryNews>(&*answer);
  ASSERT_NE(news, nullptr);
  EXPECT_EQ(news->entry->outcome.status.winner, evening.ada().seat());
  evening.eve().await(news->entry->seq);
  evening.checked_record();
}

TEST(Simulation, AMatchWhoseCreationWasNotAnsweredIsOpenedOnce) {
  Evening evening(7);
  const auto open = [&] { return evening.eve().ask_for<lobby::Listing>(lobby::List{}).matches; };
  const auto lose_the_answer = [&] {
    const auto deadline = Clock::now() + support::patience;
    while (open().empty() && Clock::now() < deadline) {
    }
    evening.ada().disconnect();
    throw Lost{};
  };
  lobby::Create create;
  create.key.emplace().fill(1);
  EXPECT_THROW(evening.ada().ask(create, lose_the_answer), Lost);
  evening.ada().connect(evening.server().port());
  evening.ada().create(create);
  const auto matches = open();
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_EQ(matches.front().id, evening.ada().match());
}

/// Waits until the store has written, or some time has passed: just after a command is kept and
/// before anybody is told.
void await_write(const std::filesystem::path& data) {
  const std::filesystem::path log = data / "breakshot.sqlite-wal";
  std::error_code ignored;
  const auto before = std::filesystem::last_write_time(log, ignored);
  const auto deadline = Clock::now() + std::chrono::milliseconds(100);
  while (std::filesystem::last_write_time(log, ignored) == before && Clock::now() < deadline) {
  }
}

/// A moment between the arrival of a command and the last follower's news of it.
void await_moment(support::RandomAsks& random, const std::filesystem::path& data) {
  const auto delay = std::chrono::microseconds(random.below(20'000));
  if (random.below(2) == 0) {
    await_write(data);
    std::this_thread::sleep_for(delay / 40);
  } else {
    std::this_thread::sleep_for(delay);
  }
}

TEST(Simulation, NothingThatWasToldIsLostWheneverTheServerIsKilled) {
  constexpr std::uint64_t seed = 4;
  constexpr int kills = 20;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Evening evening(seed);
  support::RandomAsks random(seed + 1);
  int killed = 0;
  while (killed < kills) {
    evening.begin();
    for (int commands = 0; killed < kills && commands < 60 && evening.running(); ++commands) {
      if (random.below(2) == 0) {
        evening.step();
        continue;
      }
      bool done = false;
      evening.step([&] {
        if (std::exchange(done, true)) return;
        await_moment(random, evening.data());
        evening.server().kill();
        ++killed;
      });
    }
    evening.finish(5);
    evening.checked_record();
    if (HasFailure()) break;
  }
  EXPECT_EQ(killed, kills);
}

}  // namespace
}  // namespace breakshot::simulation
