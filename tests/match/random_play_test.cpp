// Whole matches played at random, with senseless asks in between: whatever is asked, a match stays
// one that could be played.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/rules/groups.hpp"
#include "tests/support/match_fold.hpp"
#include "tests/support/random_asks.hpp"

namespace breakshot::match {
namespace {

using support::eight_ball_settings;
using support::practice_settings;
using support::RandomAsks;

std::uint32_t racks_won(const Match& match) {
  std::uint32_t sum = 0;
  for (const std::uint32_t won : match.status.score) sum += won;
  return sum;
}

/// What holds for every running or finished match.
void expect_playable(const Match& match) {
  const Status& status = match.status;
  const rules::GameStatus& game = status.game;
  ASSERT_TRUE(physics::faults_of(match.settings.scene, match.table).empty());
  ASSERT_LE(match.table.balls.size(), 16u);
  ASSERT_TRUE(std::is_sorted(match.table.balls.begin(), match.table.balls.end(),
                             [](const auto& a, const auto& b) { return a.id < b.id; }));
  ASSERT_NE(rules::find(match.table, rules::cue_ball), nullptr);
  ASSERT_LT(number(game.turn), match.settings.seats);
  ASSERT_EQ(status.score.size(), match.settings.seats);
  ASSERT_EQ(status.rerack_agreed.size(), match.settings.seats);
  ASSERT_EQ(game.groups.size(), match.settings.seats);
  ASSERT_EQ(status.end.has_value(), status.stage == Stage::finished);
  ASSERT_TRUE(status.stage == Stage::running || game.options.empty());

  if (match.settings.game == GameKind::practice) {
    ASSERT_EQ(racks_won(match), 0u);
    ASSERT_TRUE(game.options.empty());
    return;
  }
  const bool raced = status.end == MatchEnd::race_won;
  ASSERT_EQ(racks_won(match), raced ? status.rack : status.rack - 1);
  ASSERT_EQ(status.winner.has_value(), status.stage == Stage::finished);
  ASSERT_EQ(game.groups[0], rules::opposite(game.groups[1]));
  for (const std::uint32_t won : status.score) ASSERT_LE(won, match.settings.race_to);
  if (status.stage == Stage::finished) return;

  const bool spotting = std::find(game.options.begin(), game.options.end(),
                                  rules::Option::spot_eight) != game.options.end();
  ASSERT_EQ(rules::find(match.table, rules::eight_ball_id) == nullptr, spotting);
  ASSERT_TRUE(!game.breaking || match.table.balls.size() == 16u);
  ASSERT_TRUE(std::is_sorted(game.options.begin(), game.options.end()));
}

/// What an accepted ask may have changed.
void expect_step(const Match& before, const Ask& ask, const Accepted& accepted) {
  const Match& after = accepted.next;
  ASSERT_EQ(static_cast<std::uint32_t>(after.next), static_cast<std::uint32_t>(before.next) + 1);
  ASSERT_EQ(accepted.outcome.table, after.table);
  ASSERT_EQ(accepted.outcome.status, after.status);
  const bool shot = std::holds_alternative<Shoot>(ask.command);
  ASSERT_EQ(accepted.outcome.shot.has_value(), shot);
  ASSERT_EQ(after.shots, before.shots + (shot ? 1 : 0));
  ASSERT_EQ(after.settings, before.settings);
  ASSERT_EQ(after.seed, before.seed);
  ASSERT_GE(after.status.rack, before.status.rack);
  if (shot && after.racks == before.racks && accepted.outcome.ruling) {
    const auto& down = accepted.outcome.ruling->pocketed;
    const auto cue_balls = std::count(down.begin(), down.end(), rules::cue_ball);
    ASSERT_EQ(after.table.balls.size(),
              before.table.balls.size() - down.size() + static_cast<std::size_t>(cue_balls));
  }
}

struct Played {
  Match match;
  std::vector<Ask> accepted;
  std::size_t refused = 0;
};

/// Plays until the match ends or `most` commands have been accepted.
Played play(const Settings& settings, std::uint64_t seed, std::size_t most) {
  physics::Seed match_seed{};
  for (std::size_t i = 0; i < 8; ++i) match_seed[i] = static_cast<std::uint8_t>(seed >> (8 * i));
  RandomAsks asks(seed);
  Played played{support::started(settings, match_seed), {}, 0};
  while (played.match.status.stage == Stage::running && played.accepted.size() < most) {
    const bool sense = asks.below(3) == 0;
    const Ask ask = sense ? asks.sensible(played.match) : asks.senseless(played.match);
    const Match before = played.match;
    auto result = apply(played.match, ask);
    EXPECT_EQ(played.match, before);
    if (const auto* refused = std::get_if<Refusal>(&result)) {
      EXPECT_FALSE(refused->what.empty());
      ++played.refused;
      continue;
    }
    auto& accepted = std::get<Accepted>(result);
    expect_step(before, ask, accepted);
    expect_playable(accepted.next);
    if (::testing::Test::HasFatalFailure()) return played;
    played.accepted.push_back(ask);
    played.match = std::move(accepted.next);
  }
  return played;
}

TEST(RandomPlay, KeepsEveryEightBallMatchPlayable) {
  std::size_t won_at_the_table = 0;
  std::size_t refused = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Played played = play(eight_ball_settings(2), seed, 400);
    if (HasFatalFailure()) return;
    if (played.match.status.end == MatchEnd::race_won) ++won_at_the_table;
    refused += played.refused;
  }
  EXPECT_GT(won_at_the_table, 5u) << "random play should reach the ends of matches";
  EXPECT_GT(refused, 1'000u) << "and try what is not allowed";
}

TEST(RandomPlay, KeepsEveryPracticePlayable) {
  for (std::uint64_t seed = 101; seed <= 110; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    play(practice_settings(static_cast<std::uint8_t>(1 + seed % 4)), seed, 60);
    if (HasFatalFailure()) return;
  }
}

TEST(RandomPlay, FoldingTheSameAsksTwiceGivesEqualMatches) {
  for (std::uint64_t seed = 201; seed <= 205; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Played played = play(eight_ball_settings(1), seed, 100);
    if (HasFatalFailure()) return;
    Match folded = support::started(eight_ball_settings(1), played.match.seed);
    for (const Ask& ask : played.accepted) {
      auto result = apply(folded, ask);
      ASSERT_TRUE(std::holds_alternative<Accepted>(result));
      folded = std::get<Accepted>(std::move(result)).next;
    }
    EXPECT_EQ(folded, played.match);
  }
}

}  // namespace
}  // namespace breakshot::match
