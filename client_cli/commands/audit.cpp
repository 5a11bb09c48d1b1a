// `breakshot audit`: random breaks and shots over every combination of models, each checked at
// every event.
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <string_view>
#include <thread>

#include "client_cli/audit/campaign.hpp"
#include "client_cli/audit/random_scenario.hpp"
#include "client_cli/command.hpp"
#include "client_cli/commands/commands.hpp"
#include "client_cli/json.hpp"
#include "common/physics/validation.hpp"

namespace breakshot::client {
namespace {

struct Options {
  std::uint32_t shots = 5000;
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: as many as there are processors
  std::optional<std::uint32_t> scenario;
};

/// What is looked for, in the order in which it is reported.
struct Line {
  const char* name;
  const char* number;
  const char* beyond;
  const char* what;
  const char* unit;
  Worst Findings::*worst;
};

constexpr Line lines[] = {
    {"energyRise", "energyRiseScenario", "energyRiseNotAllowed", "worst energy rise",
     " of the energy at the start", &Findings::rise},
    {"penetration", "penetrationScenario", "penetrationNotAllowed", "worst overlap beyond rounding",
     " m", &Findings::penetration},
    {"escapes", "escapesScenario", "escapesNotAllowed", "balls where none can be", "",
     &Findings::escapes},
    {"stalls", "stallsScenario", "stallsNotAllowed", "stalled shots", "", &Findings::stalls},
    {"mostEvents", "mostEventsScenario", "mostEventsNotAllowed", "most events in a shot", "",
     &Findings::most_events},
};

void print_text(const Findings& found, const Options& options) {
  std::cout << found.shots << " shots, " << found.events << " events, seed " << options.seed << ": "
            << (found.clean() ? "clean" : "NOT CLEAN") << '\n';
  for (const Line& line : lines) {
    const Worst& worst = found.*line.worst;
    std::cout << "  " << line.what << ": " << physics::shown(worst.value) << line.unit;
    if (worst.value > 0) std::cout << ", scenario " << worst.number;
    if (worst.beyond > 0) std::cout << "; not allowed, in " << worst.beyond << " shots";
    std::cout << '\n';
  }
  std::cout << "Scenario N again: breakshot audit --seed " << options.seed
            << " --scenario N | breakshot simulate - --audit\n";
}

void print_json(const Findings& found, const Options& options) {
  std::vector<std::pair<std::string_view, Json>> members = {{"shots", found.shots},
                                                            {"events", found.events},
                                                            {"seed", options.seed},
                                                            {"clean", found.clean()}};
  for (const Line& line : lines) {
    const Worst& worst = found.*line.worst;
    members.push_back({line.name, worst.value});
    members.push_back({line.number, worst.number});
    members.push_back({line.beyond, worst.beyond});
  }
  std::cout << object(members).text() << '\n';
}

/// One line that is written over again, on a terminal only.
void show_progress(const Findings& found, std::uint32_t shots) {
  constexpr std::uint64_t width = 40;
  const std::uint64_t filled = width * found.shots / std::max(shots, 1U);
  std::cerr << "\r[" << std::string(filled, '#') << std::string(width - filled, ' ') << "] "
            << found.shots << " of " << shots << std::flush;
}

int run(const Options& options, const Globals& globals) {
  if (options.scenario) {
    std::cout << wire::text_of(random_scenario(options.seed, *options.scenario)) << '\n';
    return exit_done;
  }
  const bool terminal = isatty(STDERR_FILENO) == 1;
  const unsigned threads =
      options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  const Findings found =
      audit_campaign(options.seed, options.shots, threads, [&](const Findings& so_far) {
        if (terminal) show_progress(so_far, options.shots);
      });
  if (terminal) std::cerr << "\r\033[K";
  if (globals.json) {
    print_json(found, options);
  } else {
    print_text(found, options);
  }
  return found.clean() ? exit_done : exit_failed;
}

}  // namespace

Command add_audit(CLI::App& program, const Globals& globals) {
  auto options = std::make_shared<Options>();
  CLI::App* parser = program.add_subcommand(
      "audit", "Simulate random shots over all models; look for what must not happen");
  parser->add_option("--shots", options->shots, "How many")->capture_default_str();
  parser->add_option("--seed", options->seed, "Which ones: the same seed, the same shots")
      ->capture_default_str();
  parser->add_option("--threads", options->threads, "At once; one for each processor by default");
  parser->add_option("--scenario", options->scenario, "Only print this one, as a scenario file")
      ->type_name("N");
  parser->footer(
      "Looks for energy that rises, overlaps beyond what rounding explains, balls that end\n"
      "where none can be, and shots that stall.\n"
      "Exit status: 0 nothing found, 1 something found, 2 bad usage.");
  return {parser, [options, &globals] { return run(*options, globals); }};
}

}  // namespace breakshot::client
