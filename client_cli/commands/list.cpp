// breakshot list: the matches of a server.
#include <algorithm>
#include <ctime>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "client_cli/commands/commands.hpp"
#include "client_cli/online/connection.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/online/teller.hpp"
#include "client_cli/words.hpp"

namespace breakshot::client {
namespace {

struct Options {
  bool open = false;
  bool running = false;
  bool mine = false;
  bool finished = false;
  std::string name;
  std::size_t limit = 50;
};

std::vector<lobby::Filter> filters_of(const Options& options) {
  std::vector<lobby::Filter> filters;
  if (options.open) filters.push_back(lobby::Filter::open);
  if (options.running) filters.push_back(lobby::Filter::running);
  if (options.mine) filters.push_back(lobby::Filter::mine);
  if (options.finished) filters.push_back(lobby::Filter::finished);
  if (filters.empty()) filters = {lobby::Filter::open, lobby::Filter::running};
  return filters;
}

/// The newest matches of one filter, page by page.
std::vector<lobby::MatchInfo> matches_of(Connection& connection, lobby::Filter filter,
                                         std::size_t limit) {
  std::vector<lobby::MatchInfo> all;
  lobby::List request{filter, std::nullopt};
  while (true) {
    const auto answer = connection.ask(request);
    if (const auto* refused = std::get_if<lobby::Refused>(&answer)) refuse(*refused);
    const auto* page = std::get_if<lobby::Listing>(&answer);
    if (page == nullptr) throw CommandError("the server's answer makes no sense here");
    all.insert(all.end(), page->matches.begin(), page->matches.end());
    if (!page->more || page->matches.empty() || all.size() >= limit) break;
    request.after = lobby::Position{all.back().created_unix_ms, all.back().id};
  }
  if (all.size() > limit) all.resize(limit);
  return all;
}

/// "2024-06-11 18:30", in the user's own time.
std::string date_text(std::int64_t unix_ms) {
  const auto seconds = static_cast<std::time_t>(unix_ms / 1000);
  std::tm local{};
  if (::localtime_r(&seconds, &local) == nullptr) return "?";
  std::string text(32, '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local));
  return text;
}

std::string game_text(const match::Settings& settings) {
  if (settings.game == match::GameKind::practice) return "practice";
  return words_of(settings.game) + " to " + std::to_string(settings.race_to);
}

std::string players_text(const lobby::MatchInfo& info) {
  std::string text;
  for (std::size_t i = 0; i < info.seats.size(); ++i) {
    const std::string& name = info.seats[i].name;
    text += (i == 0 ? "" : ", ") + (name.empty() ? "(free)" : name);
  }
  return text;
}

std::string stage_text(const lobby::MatchInfo& info) {
  switch (info.stage) {
    case match::Stage::gathering:
      return "open";
    case match::Stage::running:
      return "running";
    case match::Stage::finished:
      break;
  }
  return "finished";
}

std::string score_text(const lobby::MatchInfo& info) {
  if (info.settings.game == match::GameKind::practice) return "";
  std::string text;
  for (const std::uint32_t racks : info.score)
    text += (text.empty() ? "" : ":") + std::to_string(racks);
  return text;
}

/// Each column as wide as its widest cell.
void print_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line += std::string(widths[i] - row[i].size() + 2, ' ');
    }
    std::cout << line << '\n';
  }
}

int list(const Options& options, const Globals& globals) {
  const Guest guest = options.mine || !options.name.empty()
                          ? guest_of(options.name.empty() ? user_name() : options.name)
                          : stranger();
  Connection connection(server_of(globals), guest, notice_on_standard_error());
  std::vector<std::vector<std::string>> rows = {
      {"MATCH", "STAGE", "GAME", "TABLE", "OPENED", "SCORE", "PLAYERS"}};
  for (const lobby::Filter filter : filters_of(options)) {
    for (const auto& info : matches_of(connection, filter, options.limit)) {
      if (globals.json) {
        std::cout << json_of(info).text() << '\n';
      } else {
        rows.push_back({words_of(info.id), stage_text(info), game_text(info.settings),
                        info.settings.preset, date_text(info.created_unix_ms), score_text(info),
                        players_text(info) + (info.code ? "  code " + *info.code : "")});
      }
    }
  }
  if (globals.json) return exit_done;
  if (rows.size() > 1) {
    print_table(rows);
  } else {
    std::cout << "No such match.\n";
  }
  return exit_done;
}

}  // namespace

Command add_list(CLI::App& program, const Globals& globals) {
  const auto options = std::make_shared<Options>();
  CLI::App* parser = program.add_subcommand("list", "List the matches of a server");
  parser->add_flag("--open", options->open, "Those with a free seat (with --running: the default)");
  parser->add_flag("--running", options->running, "Those that are being played");
  parser->add_flag("--mine", options->mine, "Those at which --name sits, private ones as well");
  parser->add_flag("--finished", options->finished, "Those that are over");
  parser->add_option("--name", options->name, "Ask as this guest (default: your user name)")
      ->type_name("NAME");
  parser->add_option("--limit", options->limit, "At most so many of each kind, the newest")
      ->check(CLI::Range(1, 100000).description(""))
      ->type_name("N")
      ->capture_default_str();
  return {parser, [options, &globals] { return list(*options, globals); }};
}

}  // namespace breakshot::client
