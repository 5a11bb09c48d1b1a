#include "client_cli/audit/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "client_cli/audit/random_scenario.hpp"
#include "common/physics/cloth.hpp"
#include "common/physics/timeline.hpp"

namespace breakshot::client {
namespace {

/// Balls that have ended where no ball may be placed.
std::size_t escapes_of(const wire::Scenario& scenario, const physics::Shot& shot) {
  const physics::State state = physics::state_after(shot);
  return state.balls.empty() ? 0 : physics::faults_of(scenario.scene, state).size();
}

void take_shot(Findings& findings, const wire::Scenario& scenario, const physics::Shot& shot,
               std::uint32_t number) {
  const physics::Audit audit = physics::audit(scenario.scene, shot);
  const auto events = static_cast<double>(shot.events.size());
  findings.events += shot.events.size();
  findings.most_events.take(events, number, physics::never<double>);
  if (audit.energy_start_J > 0) {
    findings.rise.take(audit.worst_rise_J / audit.energy_start_J, number, allowed_rise);
  }
  findings.penetration.take(audit.worst_excess_m, number, 0);
  findings.escapes.take(static_cast<double>(escapes_of(scenario, shot)), number, 0);
}

}  // namespace

void Worst::take(double found, std::uint32_t in, double allowed) {
  beyond += found > allowed;
  if (found > value) {
    value = found;
    number = in;
  }
}

void Worst::take(const Worst& other) {
  beyond += other.beyond;
  // Of equals the first scenario stands, whichever thread ran it.
  if (other.value > value || (other.value == value && other.number < number)) {
    value = other.value;
    number = other.number;
  }
}

void Findings::take(const Findings& other) {
  shots += other.shots;
  events += other.events;
  rise.take(other.rise);
  penetration.take(other.penetration);
  escapes.take(other.escapes);
  stalls.take(other.stalls);
  most_events.take(other.most_events);
}

bool Findings::clean() const {
  return rise.beyond + penetration.beyond + escapes.beyond + stalls.beyond == 0;
}

Findings audited(const wire::Scenario& scenario, std::uint32_t number) {
  Findings findings;
  findings.shots = 1;
  const auto outcome = physics::simulate(scenario.scene, scenario.state, scenario.strike,
                                         scenario.seed, scenario.limits);
  if (const auto* shot = std::get_if<physics::Shot>(&outcome)) {
    take_shot(findings, scenario, *shot, number);
  } else {
    findings.stalls.take(1, number, 0);
  }
  return findings;
}

Findings audit_campaign(std::uint64_t seed, std::uint32_t shots, unsigned threads,
                        const std::function<void(const Findings&)>& progress) {
  std::atomic<std::uint32_t> next = 0;
  std::mutex guard;
  Findings all;
  const auto work = [&] {
    constexpr std::uint32_t batch = 64;
    for (std::uint32_t from = next.fetch_add(batch); from < shots; from = next.fetch_add(batch)) {
      Findings some;
      for (std::uint32_t number = from; number < std::min(shots, from + batch); ++number) {
        some.take(audited(random_scenario(seed, number), number));
      }
      const std::lock_guard lock(guard);
      all.take(some);
    }
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < threads; ++i) workers.emplace_back(work);
  const auto found = [&] {
    const std::lock_guard lock(guard);
    return all;
  };
  while (found().shots < shots) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    progress(found());
  }
  return found();
}

}  // namespace breakshot::client
