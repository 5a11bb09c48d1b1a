#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/record/record.hpp"
#include "tests/support/played_match.hpp"

namespace breakshot::record {
namespace {

using support::PlayedMatch;
using Kind = Verdict::Kind;

/// A short match of two, ended by a concession.
const Record& played() {
  static const Record record = [] {
    PlayedMatch match(1, match::GameKind::eight_ball, 2);
    match.play(12);
    return match.record();
  }();
  return record;
}

/// The same record with its digests made good: what a forger would do.
Record rechained(Record record) {
  hash::Digest before = digest_of(record.header);
  for (Entry& entry : record.entries) entry.digest = before = digest_of(before, entry);
  return record;
}

/// The number of the first entry with a shot of more than one event.
std::size_t first_shot(const Record& record) {
  const auto found =
      std::find_if(record.entries.begin(), record.entries.end(), [](const Entry& entry) {
        return entry.outcome.shot && entry.outcome.shot->events.size() > 1;
      });
  return static_cast<std::size_t>(found - record.entries.begin());
}

/// The verdict on a forgery must name entry `at` and say something that begins with `what`.
void expect_divergence(const Record& record, std::size_t at, const std::string& what) {
  const Verdict verdict = verify(record);
  EXPECT_EQ(verdict.kind, Kind::diverged);
  ASSERT_TRUE(verdict.divergence);
  EXPECT_EQ(verdict.divergence->seq, match::Seq(at)) << verdict.divergence->what;
  EXPECT_EQ(verdict.divergence->what.rfind(what, 0), 0u) << verdict.divergence->what;
}

TEST(Replay, VerifiesMatchesOf8Ball) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    PlayedMatch match(seed, match::GameKind::eight_ball, 2);
    match.play(40);
    const Verdict verdict = verify(match.record());
    EXPECT_EQ(verdict, (Verdict{Kind::verified, match.record().entries.size(), std::nullopt}))
        << verdict.divergence->what;
  }
}

TEST(Replay, VerifiesPracticeOfOneAndOfMany) {
  for (const std::uint8_t seats : {std::uint8_t{1}, std::uint8_t{3}}) {
    PlayedMatch match(seats, match::GameKind::practice, seats);
    match.play(20);
    EXPECT_EQ(verify(match.record()).kind, Kind::verified);
  }
}

TEST(Replay, VerifiesWhatWasReadFromAFile) {
  const Reading reading = read_file(file_of(played()));
  EXPECT_EQ(reading.damage, std::nullopt);
  EXPECT_EQ(reading.record, played());
  EXPECT_EQ(verify(*reading.record).kind, Kind::verified);
}

TEST(Replay, CannotVerifyBeforeTheSecretIsRevealed) {
  Record record = played();
  record.entries.pop_back();
  EXPECT_EQ(verify(record), (Verdict{Kind::not_revealed_yet, 0, std::nullopt}));
  record.entries.clear();
  EXPECT_EQ(verify(record), (Verdict{Kind::not_revealed_yet, 0, std::nullopt}));
}

TEST(Replay, ChecksTheChainEvenBeforeTheSecretIsRevealed) {
  Record record = played();
  record.entries.pop_back();
  record.entries[1].id = match::CommandId{0};
  expect_divergence(record, 1, "digest: ");
}

TEST(Replay, CannotVerifyPhysicsThatItDoesNotKnow) {
  Record record = played();
  record.header.physics = physics::physics_version + 1;
  EXPECT_EQ(verify(record), (Verdict{Kind::unknown_physics, 0, std::nullopt}));
}

TEST(Replay, VerifiesWhatEarlierVersionsOfThePhysicsPlayed) {
  for (const std::uint32_t version : earlier_physics) {
    // The paper's table has been there since the first version.
    PlayedMatch match(2, match::GameKind::eight_ball, 2, physics::presets().back(), version);
    match.play(12);
    EXPECT_EQ(match.record().header.physics, version);
    EXPECT_EQ(verify(match.record()).kind, Kind::verified) << version;
  }
  EXPECT_TRUE(can_simulate(1));
  EXPECT_TRUE(can_simulate(2));
  EXPECT_TRUE(can_simulate(physics::physics_version));
  EXPECT_FALSE(can_simulate(0));
  EXPECT_NE(simulated_versions().find(std::to_string(physics::physics_version)), std::string::npos);
}

TEST(Replay, TellsAnEarlierVersionOfThePhysicsFromThePresentOne) {
  Record record = played();
  record.header.physics = 2;
  EXPECT_EQ(verify(rechained(record)).kind, Kind::diverged);
}

TEST(Replay, RefusesAnEarlierVersionOfThePhysicsForASceneThatItDidNotHave) {
  Record record = played();  // on the table with everything
  record.header.physics = 1;
  expect_divergence(rechained(record), 0, "header: scene.bed.motion: spinning came with version 2");
  // Nor before its secret is revealed.
  record.entries.pop_back();
  expect_divergence(rechained(record), 0, "header: scene.bed.motion: spinning came with version 2");
}

TEST(Replay, KnowsWhatVersion1OfThePhysicsHad) {
  using physics::Scene;
  const Scene plain = physics::presets()[3].scene;
  const Scene full = physics::presets()[0].scene;
  EXPECT_EQ(newer_part_of(plain, 1), std::nullopt);
  EXPECT_EQ(newer_part_of(physics::presets().back().scene, 1), std::nullopt);
  EXPECT_EQ(newer_part_of(full, physics::physics_version), std::nullopt);
  const auto part = [&](auto change) {
    Scene scene = plain;
    change(scene);
    return newer_part_of(scene, 1).value_or("");
  };
  const auto begins = [](const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
  };
  EXPECT_TRUE(
      begins(part([&](Scene& s) { s.cushions = full.cushions; }), "scene.cushions: han2005"));
  EXPECT_TRUE(begins(part([&](Scene& s) { s.pockets = full.pockets; }), "scene.pockets: jawed"));
  EXPECT_TRUE(
      begins(part([&](Scene& s) { s.ball_ball = full.ball_ball; }), "scene.ballBall: frictional"));
  EXPECT_TRUE(begins(
      part([](Scene& s) {
        s.cushions = physics::FreeCushions{{}, {{{0, 0}, 1, {1, 0}, {0, 1}, physics::Mirror{}}}};
      }),
      "scene.cushions: arcs"));
  EXPECT_TRUE(begins(part([](Scene& s) {
                       s.cushions =
                           physics::FreeCushions{{{{0, 0}, {1, 0}, physics::Mirror{}},
                                                  {{1, 0}, {1, 1}, physics::Stronge2000{}}}};
                     }),
                     "scene.cushions: stronge2000"));
}

TEST(Replay, NamesTheFirstEventThatDiverges) {
  Record record = played();
  const std::size_t at = first_shot(record);
  ASSERT_LT(at, record.entries.size());
  physics::Shot& shot = *record.entries[at].outcome.shot;
  std::visit([&](auto& event) { event.time_s = std::nextafter(event.time_s, shot.end_s); },
             shot.events[1]);
  expect_divergence(record, at, "shot.events[1].time_s: ");
  expect_divergence(rechained(record), at, "shot.events[1].time_s: ");
  EXPECT_EQ(verify(record).entries_verified, at);
}

TEST(Replay, NamesTheFirstEntryThatDiverges) {
  const std::size_t at = first_shot(played());
  const auto forged = [&](auto change) {
    Record record = played();
    change(record.entries[at]);
    return rechained(record);
  };
  expect_divergence(forged([](Entry& e) { e.outcome.shot.reset(); }), at, "shot: absent stored");
  expect_divergence(forged([](Entry& e) { e.outcome.shot->segments.back().position.y += 0.001; }),
                    at, "shot.segments[");
  expect_divergence(forged([](Entry& e) { e.outcome.ruling->illegal_break ^= true; }), at,
                    "ruling.illegal_break: ");
  expect_divergence(forged([](Entry& e) { e.outcome.table.balls.pop_back(); }), at, "table.balls");
  expect_divergence(forged([](Entry& e) { e.outcome.status.score[1] += 1; }), at,
                    "status.score[1]: ");
}

TEST(Replay, NamesTheEntryWhoseCommandWasChanged) {
  Record record = played();
  const std::size_t at = first_shot(record);
  auto& shoot = std::get<match::Shoot>(record.entries[at].command);
  shoot.speed_m_s = std::nextafter(shoot.speed_m_s, 0);
  expect_divergence(rechained(record), at, "shot.");
  shoot.direction = {3, 4};
  expect_divergence(rechained(record), at, "command: refused: direction: ");
  shoot = std::get<match::Shoot>(played().entries[at].command);
  record.entries[at].author.seat = rules::Seat(1 - rules::number(*record.entries[at].author.seat));
  expect_divergence(rechained(record), at, "command: refused: ");
}

TEST(Replay, NamesTheEntryWhoseDigestIsWrong) {
  Record record = played();
  record.entries[2].digest[31] ^= 1;
  expect_divergence(record, 2, "digest: ");
  record = played();
  record.entries[2].id = match::CommandId{0};
  expect_divergence(record, 2, "digest: ");
}

TEST(Replay, NamesTheEntryThatIsMissing) {
  Record record = played();
  record.entries.erase(record.entries.begin() + 2);
  expect_divergence(record, 2, "seq: 3 stored, 2 is the next");
}

TEST(Replay, ChecksTheSecretAgainstItsCommitment) {
  Record record = played();
  (*record.entries.back().secret)[0] ^= 1;
  expect_divergence(rechained(record), record.entries.size() - 1, "secret: its commitment is ");
}

TEST(Replay, FindsASecretThatFitsItsCommitmentButNotTheRack) {
  Record record = played();
  (*record.entries.back().secret)[0] ^= 1;
  record.header.commitment = match::commitment_of(*record.entries.back().secret);
  expect_divergence(rechained(record), 0, "table.balls[");
}

TEST(Replay, FindsAContributionThatWasChanged) {
  Record record = played();
  record.header.players[1].contribution[5] ^= 1;
  expect_divergence(record, 0, "table.balls[");
  expect_divergence(rechained(record), 0, "table.balls[");
}

TEST(Replay, FindsAHeaderThatWasChanged) {
  Record record = played();
  record.header.players[1].name = "somebody else";
  expect_divergence(record, 0, "digest: ");
  record.header.settings.scene.ball.radius_m = -1;
  expect_divergence(record, 0, "header: scene.ball.radius: ");
  record.header.players.pop_back();
  expect_divergence(record, 0, "header: players: 1 listed, one for each of 2 seats is right");
}

TEST(Replay, FindsASecretRevealedBeforeTheEnd) {
  Record record = played();
  const match::Secret secret = *record.entries.back().secret;
  record.entries.resize(3);
  record.entries.back().secret = secret;
  expect_divergence(rechained(record), 2, "secret: revealed before the match was finished");
  record = played();
  record.entries[2].secret = secret;
  expect_divergence(rechained(record), 2, "secret: revealed before the match was finished");
}

TEST(Replay, FindsEntriesAfterTheEnd) {
  Record record = played();
  Entry more = record.entries.back();
  more.seq = match::Seq(record.entries.size());
  record.entries.back().secret.reset();
  record.entries.push_back(more);
  expect_divergence(rechained(record), record.entries.size() - 1, "command: refused: ");
}

TEST(Replay, FindsValuesThatCannotBeRecorded) {
  Record record = played();
  const std::size_t at = first_shot(record);
  record.entries[at].outcome.shot->end_s = std::nan("");
  expect_divergence(record, at, "outcome.shot.end_s: not a finite number");
}

}  // namespace
}  // namespace breakshot::record
