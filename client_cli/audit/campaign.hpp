// Simulates many scenarios and keeps the worst of each thing that must not happen.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "common/physics/audit.hpp"
#include "common/wire/scenario.hpp"

namespace breakshot::client {

/// The greatest value of something, and the number of the scenario that has it.
struct Worst {
  double value = 0;
  std::uint32_t number = 0;
  std::uint64_t beyond = 0;  ///< scenarios in which it is more than is allowed

  void take(double found, std::uint32_t in, double allowed);
  void take(const Worst& other);
};

/// What a campaign has found.
struct Findings {
  std::uint64_t shots = 0;
  std::uint64_t events = 0;
  Worst rise;         ///< of the energy at one instant, as a share of the energy at the start
  Worst penetration;  ///< of balls, cushions or both, beyond the stated bound, m
  Worst escapes;      ///< balls that are not where a ball can be
  Worst stalls;
  Worst most_events;

  void take(const Findings& other);
  /// Nothing happened that must not.
  bool clean() const;
};

/// A rise of the energy that rounding explains, as a share of the energy at the start.
inline constexpr double allowed_rise = 1e-12;

/// Simulates and audits one scenario, which carries `number`.
Findings audited(const wire::Scenario& scenario, std::uint32_t number);

/// Runs scenarios 0 to `shots` of a seed on `threads` threads. `progress` is called now and then,
/// from this thread, with what has been found so far.
Findings audit_campaign(std::uint64_t seed, std::uint32_t shots, unsigned threads,
                        const std::function<void(const Findings&)>& progress);

}  // namespace breakshot::client
