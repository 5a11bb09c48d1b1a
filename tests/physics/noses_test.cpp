// The first of many noses, found in packs, is the one that asking each of them gives.
#include "common/physics/noses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/chance.hpp"
#include "tests/support/scenes.hpp"

namespace breakshot::physics {
namespace {

using support::Chance;

constexpr double radius = 0.028575;
constexpr double top_speed = 20;

Noses<double>::Meeting one_by_one(const std::vector<Nose<double>>& noses, const Path<double>& path,
                                  double until_s) {
  Noses<double>::Meeting first{until_s, 0};
  for (std::uint32_t i = 0; i < noses.size(); ++i) {
    const double t = cushion_time(path, noses[i], radius, top_speed, first.time_s);
    if (t < first.time_s) first = {t, i};
  }
  return first;
}

Vec2 somewhere(Chance& chance, double reach) {
  return {chance.between(-reach, reach), chance.between(-reach, reach)};
}

/// Noses anywhere, some of them twice, so that two are met at one time.
std::vector<Nose<double>> noses_anywhere(Chance& chance, std::size_t count) {
  std::vector<Nose<double>> noses;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && chance.below(8) == 0) {
      noses.push_back(noses[chance.below(i)]);
      continue;
    }
    CushionSegment segment;
    segment.from = somewhere(chance, 1.2);
    segment.to = segment.from + somewhere(chance, 2);
    noses.push_back(nose_of<double>(segment));
  }
  return noses;
}

/// Some touch a nose, to the last bit or so; some move along one, or hardly at all.
Path<double> path_anywhere(Chance& chance, const std::vector<Nose<double>>& noses,
                           const Scene& scene) {
  Vec2 position = somewhere(chance, 1.2);
  Vec2 velocity = somewhere(chance, 5);
  const Nose<double>& nose = noses[chance.below(noses.size())];
  if (chance.below(4) == 0) {
    const double gap = chance.coin() ? 0 : chance.between(-1, 1) * 0x1p-50;
    position = nose.from + nose.along * (nose.extent / 2) + nose.inward * (radius + gap);
  }
  switch (chance.below(6)) {
    case 0:
      velocity = nose.along;
      break;
    case 1:
      velocity = velocity * std::exp2(-static_cast<double>(chance.below(1000)));
      break;
    case 2:
      velocity = {0, velocity.y};
      break;
    default:
      break;
  }
  const BasicVec3<double> spin{chance.between(-90, 90), chance.between(-90, 90), 0};
  return Cloth<double>(scene).path_from(BallId{0}, chance.coin() ? 0 : chance.between(0, 30),
                                        position, {velocity, spin});
}

TEST(Noses, GiveTheFirstThatAskingEachOfThemGives) {
  Chance chance(1);
  std::size_t met = 0;
  Scene spinning = support::cloth();
  spinning.bed.motion = Spinning{};
  for (const Scene& scene : {support::gas(), support::cloth(), spinning}) {
    for (int round = 0; round < 300; ++round) {
      const std::vector<Nose<double>> noses = noses_anywhere(chance, 1 + chance.below(70));
      const Noses<double> packs(noses, noses.size(), radius, top_speed);
      for (int shot = 0; shot < 60; ++shot) {
        const Path<double> path = path_anywhere(chance, noses, scene);
        const double until =
            chance.coin() ? never<double> : path.segment.start_s + chance.between(0, 2);
        const auto expected = one_by_one(noses, path, until);
        const auto found = packs.first(path, until);
        ASSERT_EQ(found.time_s, expected.time_s);
        if (expected.time_s < until) {
          ASSERT_EQ(found.nose, expected.nose);
          ++met;
        }
      }
    }
  }
  EXPECT_GT(met, 20'000u);
}

TEST(Noses, AreMetAlikeByBallsThatTouchThemAndMoveAlong) {
  // On a slant rounding decides whether such a ball moves towards the nose, and whether it is
  // pulled.
  Chance chance(3);
  std::size_t at_once = 0;
  for (int round = 0; round < 100'000; ++round) {
    const std::vector<Nose<double>> noses = noses_anywhere(chance, 3);
    const Noses<double> packs(noses, noses.size(), radius, top_speed);
    const Nose<double>& nose = noses[chance.below(3)];
    const double gap = chance.between(-4, 8) * 0x1p-54;
    const Path<double> path =
        Cloth<double>(support::cloth())
            .path_from(BallId{0}, 0,
                       nose.from + nose.along * (nose.extent / 2) + nose.inward * (radius + gap),
                       {nose.along * chance.between(0.1, 3), {}});
    const double until = chance.coin() ? path.end_s : chance.between(0, 1);
    const auto expected = one_by_one(noses, path, until);
    ASSERT_EQ(packs.first(path, until).time_s, expected.time_s);
    at_once += expected.time_s == 0;
  }
  EXPECT_GT(at_once, 100u);
}

TEST(Noses, AreOnlyAsManyAsAreAskedFor) {
  Chance chance(2);
  const std::vector<Nose<double>> noses = noses_anywhere(chance, 7);
  EXPECT_TRUE(Noses<double>(noses, 0, radius, top_speed).empty());
  const Noses<double> three(noses, 3, radius, top_speed);
  const std::vector<Nose<double>> first_three(noses.begin(), noses.begin() + 3);
  for (int shot = 0; shot < 2'000; ++shot) {
    const Path<double> path = path_anywhere(chance, noses, support::gas());
    const auto expected = one_by_one(first_three, path, never<double>);
    ASSERT_EQ(three.first(path, never<double>).time_s, expected.time_s);
  }
}

}  // namespace
}  // namespace breakshot::physics
