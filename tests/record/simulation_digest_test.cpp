#include <gtest/gtest.h>

#include "common/record/bytes.hpp"
#include "common/record/limits.hpp"
#include "common/record/record.hpp"
#include "tests/record/fixed_record.hpp"

namespace breakshot::record {
namespace {

template <class Change>
hash::Digest digest_after(Change change) {
  physics::Shot shot = fixed_shot();
  change(shot);
  return simulation_digest(shot);
}

// Written out by hand from docs/record.md.
TEST(SimulationDigest, IsOfTheEventsAndTheFinalState) {
  const physics::BallId ball{7};
  physics::Shot shot;
  shot.events = {physics::Struck{0, ball}, physics::BallPocket{0.5, 0, ball, physics::PocketId{4}}};
  shot.segments = {{ball, physics::Phase::roll, 0, {1, 2}, {3, 4}, {}},
                   {ball, physics::Phase::pocketed, 0.5, {5, 6}, {}, {}}};
  shot.end_s = 0.5;
  Writer expected;
  const auto u8 = [&](std::uint8_t value) { expected.number(value); };
  const auto u32 = [&](std::uint32_t value) { expected.number(value); };
  const auto f64 = [&](double value) { expected.number(value); };
  expected.raw(hash::bytes_of("breakshot.simulate.1"));
  u32(2);
  u8(0), f64(0), u32(7);
  u8(3), f64(0.5), u32(0), u32(7), u8(4);
  f64(0.5), u8(0);
  u32(1);
  u32(7), u8(4), f64(5), f64(6), f64(0), f64(0);
  u32(1), u32(7);
  EXPECT_EQ(simulation_digest(shot), hash::sha256(expected.bytes()));
}

// Written out by hand from docs/record.md: what spins at the end comes last, where anything does.
TEST(SimulationDigest, IsOfFinalSpinWhereThereIsAny) {
  const physics::BallId still{2}, spinning{7};
  physics::Shot shot;
  shot.segments = {{still, physics::Phase::rest, 0, {1, 2}, {}, {}},
                   {spinning, physics::Phase::spin, 0, {3, 4}, {}, {}, {0, 0, 5}, {0, 0, -2}}};
  shot.end_s = 0.5;
  shot.stop = physics::Stop::horizon;
  Writer expected;
  const auto u8 = [&](std::uint8_t value) { expected.number(value); };
  const auto u32 = [&](std::uint32_t value) { expected.number(value); };
  const auto f64 = [&](double value) { expected.number(value); };
  expected.raw(hash::bytes_of("breakshot.simulate.1"));
  u32(0);
  f64(0.5), u8(1);
  u32(2);
  u32(2), u8(0), f64(1), f64(2), f64(0), f64(0);
  u32(7), u8(3), f64(3), f64(4), f64(0), f64(0);
  u32(0);
  u32(1), u32(7), f64(0), f64(0), f64(4);
  EXPECT_EQ(simulation_digest(shot), hash::sha256(expected.bytes()));
}

TEST(SimulationDigest, DependsOnEveryEventAndOnWhereBallsEnd) {
  const hash::Digest digest = simulation_digest(fixed_shot());
  EXPECT_NE(digest_after([](auto& s) { s.events.pop_back(); }), digest);
  EXPECT_NE(digest_after([](auto& s) { s.segments.back().position.x = 0.5; }), digest);
  EXPECT_NE(digest_after([](auto& s) { s.end_s = 3; }), digest);
  EXPECT_NE(digest_after([](auto& s) { s.stop = physics::Stop::horizon; }), digest);
}

TEST(SimulationDigest, IsTheSameForMinusZero) {
  EXPECT_EQ(digest_after([](auto& s) { s.segments.back().velocity.x = -0.0; }),
            simulation_digest(fixed_shot()));
}

TEST(SimulationDigest, HasNoLimits) {
  physics::Shot shot = fixed_shot();
  shot.events.resize(max_events + 1, shot.events.back());
  EXPECT_NO_THROW(simulation_digest(shot));
}

}  // namespace
}  // namespace breakshot::record
