// `breakshot simulate FILE`: runs one scenario offline and prints what happened.
#include <algorithm>
#include <iostream>

#include "client_cli/command.hpp"
#include "client_cli/commands/commands.hpp"
#include "client_cli/read_input.hpp"
#include "client_cli/simulation_report.hpp"
#include "common/physics/audit.hpp"
#include "common/physics/validation.hpp"
#include "common/record/record.hpp"
#include "common/study/simulation.hpp"
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
  std::uint32_t physics = physics::physics_version;
  bool audit = false;
};

constexpr int exit_stalled = 3;

study::Method method_of(const Options& options) {
  if (options.method == "literal") return study::Literal{options.step_s};
  if (options.method == "exact") {
    if (!options.step_s) return study::Exact{};
    throw CommandError("--dt: the exact method has no time step", exit_usage);
  }
  if (options.method != "fixed" && options.method != "swept") {
    throw CommandError(
        "--method: " + options.method + ": must be one of exact, fixed, swept, literal",
        exit_usage);
  }
  if (!options.step_s) {
    throw CommandError("--dt: the " + options.method + " method needs a time step", exit_usage);
  }
  if (options.method == "fixed") return study::FixedStep{*options.step_s};
  return study::SweptStep{*options.step_s};
}

study::Scalar scalar_of(const Options& options) {
  const auto& names = study::scalar_names;
  const auto found = std::find(names.begin(), names.end(), options.scalar);
  if (found != names.end()) return static_cast<study::Scalar>(found - names.begin());
  throw CommandError(
      "--scalar: " + options.scalar + ": must be one of float, double, longdouble, reference",
      exit_usage);
}

void check(const Options& options) {
  if (options.until_s && !(*options.until_s >= 0 && *options.until_s < physics::never<double>)) {
    throw CommandError("--until: must be a time of at least 0", exit_usage);
  }
  for (const double slice : options.slices_s) {
    if (!(slice >= 0)) throw CommandError("--slices: must be times of at least 0", exit_usage);
  }
  if (options.physics < 1 || options.physics > physics::physics_version) {
    throw CommandError("--physics: must be from 1 to " + std::to_string(physics::physics_version),
                       exit_usage);
  }
}

wire::Scenario scenario_of(const std::string& file) {
  auto reading = wire::read_scenario(read_input(file));
  if (auto* scenario = std::get_if<wire::Scenario>(&reading)) return std::move(*scenario);
  std::string what;
  for (const physics::Fault& fault : std::get<std::vector<physics::Fault>>(reading)) {
    if (!what.empty()) what += "\nbreakshot: ";
    what += file + ": " + (fault.field.empty() ? "" : fault.field + ": ") + fault.what;
  }
  throw CommandError(what, exit_usage);
}

Simulated simulate(const wire::Scenario& scenario, const study::Method& method,
                   const Options& options) {
  physics::Limits limits = scenario.limits;
  limits.physics = options.physics;
  study::Simulation simulation(
      method, scalar_of(options),
      {scenario.scene, scenario.state, scenario.strike, scenario.seed, limits});
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
  const study::Method method = method_of(options);
  const wire::Scenario scenario = scenario_of(options.file);
  if (const auto refusal = refusal_of(method, scenario.scene)) {
    const bool step = refusal->field == "dt";
    throw CommandError(
        (step ? "--dt: " : options.file + ": " + refusal->field + ": ") + refusal->what,
        exit_usage);
  }
  if (const auto newer = record::newer_part_of(scenario.scene, options.physics)) {
    throw CommandError("--physics: " + *newer, exit_usage);
  }
  const Simulated simulated = simulate(scenario, method, options);
  std::optional<physics::Audit> audit;
  if (options.audit) audit = physics::audit(scenario.scene, simulated.shot, options.physics);
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
  parser
      ->add_option("--method", options->method,
                   "How to step: exact; fixed or swept, with a constant step; literal, the paper's")
      ->type_name("METHOD")
      ->capture_default_str();
  parser
      ->add_option("--dt", options->step_s,
                   "Time step of fixed and swept; of literal, the length of a frame: without it, "
                   "the whole shot")
      ->type_name("S");
  parser
      ->add_option("--scalar", options->scalar,
                   "Number type: float, double, longdouble, reference (50 digits)")
      ->type_name("TYPE")
      ->capture_default_str();
  parser
      ->add_option("--until", options->until_s, "Stop at this time; the final state is that of it")
      ->type_name("S");
  parser->add_option("--slices", options->slices_s, "Advance in slices that end at these times")
      ->delimiter(',')
      ->type_name("T1,T2,..");
  parser
      ->add_option("--physics", options->physics,
                   "Version of the physics whose bits to give: that of a record's header")
      ->type_name("N")
      ->capture_default_str();
  parser->add_flag("--audit", options->audit, "Report energy rises and penetrations");
  parser->footer(
      "Exit status: 0 done, 2 bad input, 3 the shot stalled.\n"
      "The format of scenarios and of the output is described in docs/scenarios.md.");
  return {parser, [options] { return run(*options); }};
}

}  // namespace breakshot::client
