// breakshot watch: follows a match as a spectator.
#include <unistd.h>

#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "client_cli/commands/commands.hpp"
#include "client_cli/draw/abilities.hpp"
#include "client_cli/draw/table_grid.hpp"
#include "client_cli/draw/terminal.hpp"
#include "client_cli/online/connection.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/online/match_view.hpp"
#include "client_cli/online/shot_viewer.hpp"
#include "client_cli/online/teller.hpp"
#include "client_cli/words.hpp"

namespace breakshot::client {
namespace {

constexpr Milliseconds a_moment{50};
constexpr Milliseconds a_while{60'000};
/// How long the end of a match is seen before the screen is given back.
constexpr Milliseconds last_look{3'000};

struct Options {
  MatchOptions match;
  std::string name;
  double speed = 1;
  bool from_start = false;
};

/// Lines of text, for whatever is no terminal.
void watch_in_lines(Connection& connection, MatchView& view, Teller& teller) {
  while (!is_over(view)) {
    const auto news = connection.next(a_while);
    if (!news) continue;
    take(view, *news);
    teller.tell(view, *news);
  }
}

/// The table in a terminal, until the match ends or the viewer quits.
class Screen {
 public:
  Screen(Connection& connection, MatchView& view, const Options& options, Terminal& terminal)
      : connection_(connection),
        view_(view),
        terminal_(terminal),
        viewer_(options.speed),
        live_from_(options.from_start ? match::Seq{} : view.info.next) {}

  void say(const std::string& what) { line_ = what; }

  void run() {
    while (!is_over(view_)) {
      draw();
      if (const auto news = connection_.next(a_moment, STDIN_FILENO)) {
        hear(*news);
      } else if (wants_to_quit(terminal_.key(Milliseconds::zero()))) {
        quit_ = true;
      }
      if (quit_) return;
    }
    draw();
    terminal_.key(last_look);
  }

 private:
  void hear(const News& news) {
    if (const auto* seats = std::get_if<lobby::MatchNews>(&news)) {
      for (const auto& change : seat_changes(view_.info.seats, seats->info.seats)) line_ = change;
    }
    const auto* entry = std::get_if<EntryPtr>(&news);
    if (entry != nullptr && (*entry)->outcome.shot && (*entry)->seq >= live_from_) {
      line_.clear();
      const PlaybackKey key = viewer_.show(terminal_, view_, **entry, [this] {
        connection_.serve();
        return true;
      });
      quit_ = key == PlaybackKey::quit;
    }
    take(view_, news);
    if (entry == nullptr) return;
    viewer_.follow(**entry);
    const auto& outcome = (*entry)->outcome;
    if (!outcome.ruling) return;
    line_ = ruling_text(*outcome.ruling, (*entry)->author.seat.value_or(match::Seat{}),
                        names_of(view_));
  }

  static bool wants_to_quit(const std::optional<Key>& key) {
    return key &&
           (*key == Key(U'q') || *key == Key(Special::escape) || *key == Key(Special::closed));
  }

  void draw() {
    std::vector<std::string> lines = {line_};
    if (!view_.last) {
      lines.push_back("The match has not started.");
    } else {
      lines.push_back(status_text(view_.last->outcome.status, names_of(view_)));
    }
    lines.push_back("q quit");
    terminal_.show(grid_of(viewer_.picture(view_), lines, terminal_.size(), terminal_.abilities()));
  }

  Connection& connection_;
  MatchView& view_;
  Terminal& terminal_;
  ShotViewer viewer_;
  match::Seq live_from_;
  std::string line_;
  bool quit_ = false;
};

int watch(const Options& options, const Globals& globals) {
  const MatchName which = options.match.required_name();
  const Guest guest = guest_or_stranger(options.name);
  Screen* screen = nullptr;
  const auto plain_notice = notice_on_standard_error();
  Connection connection(server_of(globals), guest, [&](const std::string& what) {
    if (screen == nullptr) return plain_notice(what);
    screen->say(what);
  });
  const auto answer = connection.ask(lobby::Watch{which.id, which.code, {}});
  if (const auto* refused = std::get_if<lobby::Refused>(&answer)) refuse(*refused);
  const auto* news = std::get_if<lobby::MatchNews>(&answer);
  if (news == nullptr) throw CommandError("the server's answer makes no sense here");
  MatchView view = view_of(*news);

  const Abilities abilities = abilities_of(globals.colour);
  if (globals.json || !abilities.interactive) {
    Teller teller(std::cout, globals.json);
    teller.begin(view, globals.server);
    watch_in_lines(connection, view, teller);
  } else {
    {
      Terminal terminal(abilities);
      Screen shown(connection, view, options, terminal);
      screen = &shown;
      shown.run();
      screen = nullptr;
    }
    if (view.last) std::cout << status_text(view.last->outcome.status, names_of(view)) << '\n';
  }
  if (!view.gone.empty()) throw CommandError("the match is gone: " + view.gone);
  return exit_done;
}

}  // namespace

Command add_watch(CLI::App& program, const Globals& globals) {
  const auto options = std::make_shared<Options>();
  CLI::App* parser = program.add_subcommand("watch", "Watch a match until it ends");
  options->match.add_to(*parser);
  parser
      ->add_option("--speed", options->speed,
                   "How fast shots are shown: 0.01 to 1000, 1 is real time")
      ->check(CLI::Range(min_speed, max_speed).description(""))
      ->type_name("X")
      ->capture_default_str();
  parser->add_flag("--from-start", options->from_start,
                   "Show the shots that were played before, too");
  add_guest_name(*parser, options->name);
  return {parser, [options, &globals] { return watch(*options, globals); }};
}

}  // namespace breakshot::client
