#include "tests/golden/set.hpp"

#include "common/record/record.hpp"
#include "tests/golden/scenes.hpp"
#include "tests/golden/starts.hpp"

namespace breakshot::golden {
namespace {

using namespace physics;

/// Three digits, so that names sort by number.
std::string digits_of(std::size_t number) {
  const auto digit = [](std::size_t n) { return static_cast<char>('0' + n % 10); };
  return {digit(number / 100), digit(number / 10), digit(number)};
}

/// 3, 5 and 11 have no common divisor: 165 numbers in a row meet every combination once.
Models models_of(std::size_t number) {
  return {number % 3, number % 5, number % 11};
}

/// Crowds always touch.
Models crowd_models_of(std::size_t number) {
  return {number % 3, 1 + number % 4, number % 11};
}

/// Where balls do not slow down, or do so late among near cushions, time ends the shot.
double horizon_s(const Scene& scene, bool crowd) {
  if (crowd) return 3;
  return std::holds_alternative<Frictionless>(scene.bed.motion) ? 6 : 30;
}

ShotSeed seed_of(Draws& draws, std::size_t number) {
  ShotSeed seed;
  for (std::uint8_t& byte : seed.seed) byte = static_cast<std::uint8_t>(draws.below(256));
  seed.shot = static_cast<std::uint32_t>(number);
  return seed;
}

}  // namespace

GoldenShot golden_shot(std::size_t number) {
  Draws draws(number);
  const bool crowd = number >= combinations;
  auto [name, scene] = scene_of(crowd ? crowd_models_of(number) : models_of(number), crowd, draws);
  Start start =
      crowd ? crowd_of(scene, 25 + (number - combinations), draws) : start_of(scene, draws);
  const ShotSeed seed = seed_of(draws, number);
  const Limits limits{most_golden_events, horizon_s(scene, crowd)};
  return {digits_of(number) + "-" + name + start.name,
          std::move(scene),
          std::move(start.state),
          start.strike,
          seed,
          limits};
}

std::string name_of(const GoldenShot& shot, std::uint32_t physics) {
  return "physics-" + std::to_string(physics) + '/' + shot.name;
}

std::string digest_of(const GoldenShot& shot, std::uint32_t physics) {
  Limits limits = shot.limits;
  limits.physics = physics;
  const auto outcome = simulate(shot.scene, shot.state, shot.strike, shot.seed, limits);
  const auto* ended = std::get_if<Shot>(&outcome);
  return ended == nullptr ? "stalled" : hash::hex_of(record::simulation_digest(*ended));
}

}  // namespace breakshot::golden
