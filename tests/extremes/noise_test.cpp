// Perturbed normals: none at all and the most that is allowed.
#include "tests/extremes/extreme.hpp"

namespace breakshot::physics {
namespace {

using namespace support;

TEST(Noise, OfScaleZeroGivesTheBitsOfNoneInEveryScene) {
  for (Scene scene : every_table()) {
    const State state = racked(scene, 1e-3);
    const Strike strike{BallId{0}, {1, 0}, 6, {}};
    const Shot absent = shot_of(scene, state, strike, seed_of(9), limits_for(scene, 0.3));
    scene.perturbation = Perturbation{0, 0};
    EXPECT_EQ(shot_of(scene, state, strike, seed_of(9), limits_for(scene, 0.3)), absent)
        << name_of(scene);
  }
}

TEST(Noise, OfTheGreatestScaleGivesSoundShots) {
  for (Scene scene : every_table()) {
    scene.perturbation = Perturbation{1, 1};
    for (const double gap : {0.0, 1e-9, rack_gap_m}) {
      for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const Shot shot = shot_of(scene, racked(scene, gap), Strike{BallId{0}, {1, 0}, 8, {}},
                                  seed_of(seed), limits_for(scene, 0.3));
        expect_sound(scene, shot, name_of(scene) + " seed " + std::to_string(seed));
      }
    }
  }
}

}  // namespace
}  // namespace breakshot::physics
