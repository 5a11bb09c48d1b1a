#include "client_cli/stored_match.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "client_cli/account.hpp"
#include "tests/client_cli/match_files.hpp"

namespace breakshot::client {
namespace {

using physics::BallId;

const record::Record& played() {
  return finished_match();
}

TEST(StoredMatch, HasAShotForEveryStroke) {
  const std::vector<StoredShot> shots = shots_of(played());
  std::size_t strokes = 0;
  for (const record::Entry& entry : played().entries) {
    strokes += std::holds_alternative<match::Shoot>(entry.command) ? 1 : 0;
  }
  ASSERT_GT(strokes, 4u);
  ASSERT_EQ(shots.size(), strokes);
  for (std::size_t i = 0; i < shots.size(); ++i) EXPECT_EQ(shots[i].number, i + 1);
  EXPECT_TRUE(shots.front().before.game.breaking);
}

TEST(StoredMatch, KnowsTheBallsThatWereDownBeforeEachShot) {
  for (const StoredShot& shot : shots_of(played())) {
    const physics::Timeline timeline(shot.shot());
    // Whatever is not on the table has been pocketed.
    EXPECT_EQ(timeline.balls().size() + shot.pocketed.size(), 16u) << shot.number;
    for (const BallId ball : shot.pocketed) {
      const auto& balls = timeline.balls();
      EXPECT_EQ(std::count(balls.begin(), balls.end(), ball), 0);
    }
  }
}

TEST(StoredMatch, TheCueVectorStartsAtTheCueBall) {
  const StoredShot first = shots_of(played()).front();
  const CueVector cue = cue_vector_of(*first.entry);
  EXPECT_EQ(cue.from, physics::Timeline(first.shot()).state(rules::cue_ball, 0).position);
  EXPECT_EQ(cue.direction, first.command().direction);
  EXPECT_EQ(cue.speed_m_s, first.command().speed_m_s);
}

TEST(StoredMatch, SpottedAndRerackedBallsAreNoLongerDown) {
  PocketedBalls pocketed;
  match::Outcome outcome;
  outcome.ruling = rules::Ruling{};
  outcome.ruling->pocketed = {BallId{8}, BallId{3}, BallId{0}};
  outcome.table.balls = {{BallId{0}, {}, {}, {}}, {BallId{8}, {}, {}, {}}};
  pocketed.follow(outcome);
  EXPECT_EQ(pocketed.balls(), (std::vector{BallId{3}}));
  outcome.ruling.reset();
  outcome.table.balls = {{BallId{0}, {}, {}, {}}, {BallId{3}, {}, {}, {}}};
  pocketed.follow(outcome);
  EXPECT_TRUE(pocketed.balls().empty());
}

TEST(StoredMatch, SaysWhichShotsThereAre) {
  const std::vector<StoredShot> shots = shots_of(played());
  EXPECT_EQ(shot_of(shots, 2).number, 2u);
  for (const std::uint32_t number : {0u, static_cast<std::uint32_t>(shots.size() + 1)}) {
    try {
      shot_of(shots, number);
      FAIL() << number;
    } catch (const CommandError& error) {
      EXPECT_EQ(error.status(), exit_usage);
      EXPECT_NE(std::string(error.what()).find("shots 1 to " + std::to_string(shots.size())),
                std::string::npos);
    }
  }
  EXPECT_THROW(shot_of({}, 1), CommandError);
}

TEST(StoredMatch, OpensFilesAndNamesWhatIsWrongWithThem) {
  const MatchFiles files;
  EXPECT_EQ(open_match(files.finished(), {}).record, played());
  EXPECT_FALSE(open_match(files.finished(), {}).damage);

  const StoredMatch damaged = open_match(files.cut(), {});
  ASSERT_TRUE(damaged.damage);
  EXPECT_LT(damaged.record.entries.size(), played().entries.size());
  EXPECT_EQ(damage_text(damaged).rfind("damaged at byte ", 0), 0u);

  const std::string text = files.write("text.txt", record::ByteVector{'h', 'i'});
  for (const std::string& name : {text, files.path("missing.breakshot"), files.path("")}) {
    try {
      open_match(name, {});
      FAIL() << name;
    } catch (const CommandError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name + ": ", 0), 0u) << error.what();
      EXPECT_EQ(error.status(), exit_usage);
    }
  }
}

TEST(Account, TellsEveryEntryAndEveryShotOnce) {
  const std::vector<std::string> lines = account_of(played());
  EXPECT_EQ(lines.at(0), "8-ball, race to 1, on the club table: player 0 against player 1");
  const auto starting_with = [&](const std::string& start) {
    return std::count_if(lines.begin(), lines.end(),
                         [&](const std::string& line) { return line.rfind(start, 0) == 0; });
  };
  EXPECT_EQ(starting_with("shot "), std::ssize(shots_of(played())));
  EXPECT_EQ(starting_with("Rack 1."), 1);
  EXPECT_NE(lines.back().find("wins the match"), std::string::npos) << lines.back();
}

TEST(Account, TellsEveryEventWhereAsked) {
  std::size_t events = 0;
  for (const StoredShot& shot : shots_of(played())) events += shot.shot().events.size();
  EXPECT_EQ(account_of(played(), true).size(), account_of(played()).size() + events);
}

}  // namespace
}  // namespace breakshot::client
