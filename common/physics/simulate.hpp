// The loop: from one event to the next, until rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "common/physics/event.hpp"
#include "common/physics/perturbation.hpp"
#include "common/physics/scene.hpp"
#include "common/physics/version.hpp"

namespace breakshot::physics {

/// What one simulation keeps to.
struct Limits {
  std::size_t max_events = 1'000'000;
  std::optional<double> horizon_s;  ///< stop here, s > 0; required where balls may never rest
  std::uint32_t physics = physics_version;  ///< whose bits it gives, [1, physics_version]
};

/// Events in one shot of a match.
inline constexpr std::size_t max_match_events = 20'000;

/// Simulates one shot to its end. The input must be free of faults (`faults_of`), and `limits` must
/// have a horizon if `may_never_rest(scene)`.
std::variant<Shot, Stalled> simulate(const Scene& scene, const State& state,
                                     const std::optional<Strike>& strike, const ShotSeed& seed,
                                     const Limits& limits = {});

/// Whether a moving ball of the scene may move for ever: no friction in some phase of its motion.
bool may_never_rest(const Scene& scene);

}  // namespace breakshot::physics
