// `breakshot simulate FILE`: runs one scenario offline and prints what happened.
#include <fstream>
#include <iostream>
#include <iterator>

#include "client_cli/command.hpp"
#include "client_cli/commands/commands.hpp"
#include "client_cli/simulation_report.hpp"
#include "common/physics/audit.hpp"
#include "common/physics/simulation.hpp"
#include "common/physics/validation.hpp"
#include "common/wire/scenario.hpp"

namespace breakshot::client {
namespace {

struct Options {
  std::string file;
  std::string method = "exact";
  std::string scalar = "double";
  std::optional<double> step_s;
  std::optional<double> until_s;
  std::vector<double> slices_s;
  bool audit = false;
};

constexpr int exit_stalled = 3;

std::string text_of_file(const std::string& name) {
  if (name == "-") {
    return {std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
  }
  std::ifstream file(name, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.good() && !file.eof()) throw CommandError(name + ": cannot be read", exit_usage);
  return text;
}

void check(const Options& options) {
  if (options.method != "exact") {
    throw CommandError("--method: " + options.method + ": this build knows exact", exit_usage);
  }
  if (options.scalar != "double") {
    throw CommandError("--scalar: " + options.scalar + ": this build knows double", exit_usage);
  }
  if (options.step_s) {
    throw CommandError("--dt: the exact method has no time step", exit_usage);
  }
  if (options.until_s && !(*options.until_s >= 0 && *options.until_s < physics::never<double>)) {
    throw CommandError("--until: must be a time of at least 0", exit_usage);
  }
  for (const double slice : options.slices_s) {
    if (!(slice >= 0)) throw CommandError("--slices: must be times of at least 0", exit_usage);
  }
}

wire::Scenario scenario_of(const std::string& file) {
  auto reading = wire::read_scenario(text_of_file(file));
  if (auto* scenario = std::get_if<wire::Scenario>(&reading)) return std::move(*scenario);
  std::string what;
  for (const physics::Fault& fault : std::get<std::vector<physics::Fault>>(reading)) {
    if (!what.empty()) what += "\nbreakshot: ";
    what += file + ": " + (fault.field.empty() ? "" : fault.field + ": ") + fault.what;
  }
  throw CommandError(what, exit_usage);
}

Simulated simulate(const wire::Scenario& scenario, const Options& options) {
  physics::Simulation simulation(scenario.scene, scenario.state, scenario.strike, scenario.seed,
                                 scenario.limits);
  const double until = options.until_s.value_or(physics::never<double>);
  for (const double slice : options.slices_s) simulation.advance_to(std::min(slice, until));
  if (simulation.advance_to(until) == physics::Progress::paused) {
    return {simulation.shot_until(until), Ending::until, {}};
  }
  auto outcome = std::move(simulation).take();
  if (auto* stalled = std::get_if<physics::Stalled>(&outcome)) {
    return {std::move(stalled->so_far), Ending::stalled, std::move(stalled->balls)};
  }
  auto& shot = std::get<physics::Shot>(outcome);
  const bool rest = shot.stop == physics::Stop::rest;
  return {std::move(shot), rest ? Ending::rest : Ending::horizon, {}};
}

int run(const Options& options) {
  check(options);
  const wire::Scenario scenario = scenario_of(options.file);
  const Simulated simulated = simulate(scenario, options);
  std::optional<physics::Audit> audit;
  if (options.audit) audit = physics::audit(scenario.scene, simulated.shot);
  print_report(std::cout, simulated, audit);
  return simulated.ending == Ending::stalled ? exit_stalled : exit_done;
}

}  // namespace

Command add_simulate(CLI::App& program, const Globals&) {
  auto options = std::make_shared<Options>();
  CLI::App* parser = program.add_subcommand(
      "simulate", "Simulate a scenario file offline; print its events as JSON, one a line");
  parser->add_option("FILE", options->file, "The scenario, as JSON; - for standard input")
      ->required();
  parser->add_option("--method", options->method, "How to step: exact")->capture_default_str();
  parser->add_option("--dt", options->step_s, "Time step of methods that have one")->type_name("S");
  parser->add_option("--scalar", options->scalar, "Number type: double")->capture_default_str();
  parser
      ->add_option("--until", options->until_s, "Stop at this time; the final state is that of it")
      ->type_name("S");
  parser->add_option("--slices", options->slices_s, "Advance in slices that end at these times")
      ->delimiter(',')
      ->type_name("T1,T2,..");
  parser->add_flag("--audit", options->audit, "Report energy rises and penetrations");
  parser->footer(
      "Exit status: 0 done, 2 bad input, 3 the shot stalled.\n"
      "The format of scenarios and of the output is described in docs/scenarios.md.");
  return {parser, [options] { return run(*options); }};
}

}  // namespace breakshot::client
