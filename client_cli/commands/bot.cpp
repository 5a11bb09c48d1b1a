// breakshot bot: plays by itself to the end of a match.
#include <cmath>
#include <cstring>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "client_cli/commands/commands.hpp"
#include "client_cli/online/bot_player.hpp"
#include "client_cli/online/connection.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/online/new_match.hpp"
#include "client_cli/online/teller.hpp"
#include "common/physics/angle.hpp"

namespace breakshot::client {
namespace {

struct Options {
  OpeningOptions opening;
  std::string name = "bot";
  std::optional<std::uint64_t> seed;
  std::optional<std::uint32_t> most_shots;
  double error_degrees = 0.8;
  double speed_error_percent = 5;
  std::size_t candidates = bot::Effort{}.candidates;
};

physics::Seed seed_of(const std::optional<std::uint64_t>& number) {
  physics::Seed seed{};
  if (!number) {
    const auto bytes = entropy();
    std::memcpy(seed.data(), bytes.data(), seed.size());
    return seed;
  }
  for (std::size_t i = 0; i < sizeof *number; ++i) {
    seed[i] = static_cast<std::uint8_t>(*number >> (8 * i));
  }
  return seed;
}

int play(const Options& options, const Globals& globals) {
  const Opening opening = options.opening.opening();
  Connection connection(server_of(globals), guest_of(options.name), notice_on_standard_error());
  BotPlan plan;
  plan.effort.seed = seed_of(options.seed);
  plan.effort.candidates = options.candidates;
  plan.effort.hand = {options.error_degrees * physics::pi / 180, options.speed_error_percent / 100};
  plan.most_shots = options.most_shots;

  Teller teller(std::cout, globals.json);
  MatchView view = sit_down(connection, opening);
  teller.begin(view, globals.server);
  Player player(connection, std::move(view),
                [&](const MatchView& now, const News& news) { teller.tell(now, news); });
  play_as_bot(player, plan);
  if (!player.view().gone.empty()) return exit_failed;
  return exit_done;
}

}  // namespace

Command add_bot(CLI::App& program, const Globals& globals) {
  const auto options = std::make_shared<Options>();
  CLI::App* parser = program.add_subcommand("bot", "Let the computer play a match to its end");
  parser->footer(
      "Without MATCH, --code or --new it goes back to a match of its own, joins an open "
      "one or opens one.");
  options->opening.add_to(*parser);
  parser->add_option("--name", options->name, "The guest as whom it plays")
      ->type_name("NAME")
      ->capture_default_str();
  parser->add_option("--seed", options->seed, "Think and strike the same in the same position")
      ->type_name("N");
  parser->add_option("--shots", options->most_shots, "Concede once the match has had so many shots")
      ->type_name("MAX");
  parser->add_option("--error", options->error_degrees, "Its greatest error of direction, degrees")
      ->check(CLI::Range(0.0, 45.0).description(""))
      ->type_name("DEG")
      ->capture_default_str();
  parser
      ->add_option("--speed-error", options->speed_error_percent,
                   "Its greatest error of speed, percent")
      ->check(CLI::Range(0.0, 90.0).description(""))
      ->type_name("PCT")
      ->capture_default_str();
  parser->add_option("--candidates", options->candidates, "How many shots it looks at, at most")
      ->check(CLI::Range(1, 100000).description(""))
      ->type_name("N")
      ->capture_default_str();
  return {parser, [options, &globals] { return play(*options, globals); }};
}

}  // namespace breakshot::client
