#include "client_cli/play/session.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "client_cli/command_error.hpp"
#include "client_cli/draw/table_grid.hpp"
#include "client_cli/draw/terminal.hpp"
#include "client_cli/paragraph.hpp"
#include "client_cli/words.hpp"

namespace breakshot::client {
namespace {

constexpr Milliseconds a_while{60'000};
/// Rows of the screen that the picture of the table leaves to the text.
constexpr int rows_for_text = 8;
constexpr int most_picture_rows = 28;

}  // namespace

Session::Session(Connection& connection, MatchView view, const Surroundings& surroundings)
    : around_(surroundings),
      connection_(connection),
      teller_(surroundings.out, surroundings.json, surroundings.abilities.interactive),
      viewer_(surroundings.speed),
      lines_(surroundings.input_fd),
      live_from_(view.info.next),
      player_(connection, std::move(view),
              [this](const MatchView& now, const News& news) { heard(now, news); }) {}

int Session::run() {
  teller_.begin(player_.view(), around_.server);
  say_how_to_claim();
  while (!is_over(player_.view()) && !leaving_) {
    ask_if_due();
    const bool listens = around_.abilities.interactive || is_asked();
    if (!listens) {
      player_.hear(a_while);
    } else if (const auto line = lines_.next()) {
      handle(*line);
    } else if (lines_.at_end()) {
      leaving_ = true;
    } else if (!player_.hear(a_while, lines_.fd())) {
      lines_.fill();
    }
  }
  say_goodbye();
  return player_.view().gone.empty() ? exit_done : exit_failed;
}

// ---- What is told

void Session::heard(const MatchView& view, const News& news) {
  const auto* entry = std::get_if<EntryPtr>(&news);
  if (entry != nullptr && (*entry)->outcome.shot && (*entry)->seq >= live_from_ &&
      around_.abilities.interactive && !around_.json) {
    show_shot(view, **entry);
  }
  // Whatever is being typed is not part of the news.
  if (around_.abilities.interactive) around_.out << "\r\x1b[K";
  teller_.tell(view, news);
  if (entry == nullptr) {
    say_how_to_claim();
    if (asked_for_ == view.next) prompt();
    return;
  }
  viewer_.follow(**entry);
  if ((*entry)->outcome.shot || std::holds_alternative<match::Start>((*entry)->command)) {
    stance_ = Stance{std::nullopt, stance_.speed_m_s, {}, {}};
  }
}

void Session::show_shot(const MatchView& view, const record::Entry& entry) {
  around_.out.flush();
  Terminal terminal(around_.abilities);
  viewer_.show(terminal, view, entry, [this] {
    connection_.serve();
    return true;
  });
}

void Session::say(const std::string& line) {
  if (around_.json) return;
  if (around_.abilities.interactive) {
    const auto columns = static_cast<std::size_t>(terminal_size().columns);
    for (const auto& part : wrapped(line, columns, "  ")) around_.out << part << '\n';
  } else {
    around_.out << line << '\n';
  }
  around_.out.flush();
}

void Session::say(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) say(line);
}

bool Session::is_asked() const {
  return is_my_turn(player_.view()) && is_up_to_date(player_.view());
}

void Session::ask_if_due() {
  if (!is_asked() || asked_for_ == player_.view().next) return;
  asked_for_ = player_.view().next;
  show_table(true);
  const auto& game = player_.view().last->outcome.status.game;
  for (std::size_t i = 0; i < game.options.size(); ++i) {
    say("  choose " + std::to_string(i + 1) + ": " + words_of(game.options[i]));
  }
  if (!game.options.empty()) {
    say("It is for you to choose.");
  } else {
    say("Your shot" + std::string(game.breaking ? ", the break" : "") +
        (game.ball_in_hand == rules::BallInHand::behind_head_string
             ? ", with the cue ball in hand behind the head string (place X Y)"
         : game.ball_in_hand == rules::BallInHand::anywhere
             ? ", with the cue ball in hand (place X Y)"
             : "") +
        ". Type help to see how.");
  }
  prompt();
}

void Session::prompt() {
  if (around_.abilities.interactive && !around_.json) around_.out << "> " << std::flush;
}

void Session::say_how_to_claim() {
  const bool told = std::exchange(told_to_claim_, opponent_is_away(player_.view()));
  if (told || !told_to_claim_) return;
  const auto minutes = std::chrono::ceil<std::chrono::minutes>(player_.claim_after()).count();
  say("Whoever is away for " + std::to_string(minutes) + (minutes == 1 ? " minute" : " minutes") +
      " can be claimed against: claim.");
}

void Session::show_table(bool unasked) {
  if (around_.json || !player_.view().last) return;
  Picture picture = viewer_.picture(player_.view());
  if (is_asked()) draw_aim(stance_, moment(), picture);
  if (!around_.abilities.interactive) {
    if (!unasked) say(plain_text_of(picture, plain_columns));
    return;
  }
  TerminalSize size = terminal_size();
  size.rows = std::clamp(size.rows - rows_for_text, 8, most_picture_rows);
  around_.out << scrolling_text_of(grid_of(picture, {}, size, around_.abilities),
                                   around_.abilities.colours)
              << '\n'
              << std::flush;
}

void Session::say_goodbye() {
  const MatchView& view = player_.view();
  const std::string id = words_of(view.info.id);
  if (!view.gone.empty()) return;
  if (is_over(view)) {
    say("See it again with: breakshot replay " + id + " --server " + around_.server);
  } else if (stage_of(view) == match::Stage::gathering) {
    connection_.ask(lobby::Leave{view.info.id});
    say("The match had not started; you have given up your seat.");
  } else {
    say("The match waits for you: breakshot play " + id + " --server " + around_.server);
  }
}

// ---- What is typed

void Session::handle(const std::string& line) {
  const auto input = input_of(line);
  if (const auto* misread = std::get_if<Misread>(&input)) {
    say(misread->what);
  } else {
    std::visit([this](const auto& wish) { handle(wish); }, std::get<Input>(input));
  }
  if (leaving_ || is_over(player_.view())) return;
  // A new question brings its own prompt.
  if (asked_for_ == player_.view().next || !is_asked()) prompt();
}

Moment Session::moment() const {
  const MatchView& view = player_.view();
  const match::Outcome& outcome = view.last->outcome;
  return {view.info.settings.game, view.info.settings.scene, outcome.table, outcome.status.game};
}

bool Session::may_prepare() {
  if (!is_asked()) {
    say("It is not your turn.");
    return false;
  }
  if (!moment().game.options.empty()) {
    say("Choose first: choose N.");
    return false;
  }
  return true;
}

template <class Change>
void Session::prepare(const Change& change) {
  if (!may_prepare()) return;
  if (const auto problem = change()) return say(*problem);
  if (around_.abilities.interactive && stance_.direction) show_table(true);
  say(preview(stance_, moment()));
}

void Session::handle(const AimAlong& aim) {
  prepare([&] { return aim_along(stance_, aim.degrees); });
}

void Session::handle(const AimAt& aim) {
  prepare([&] { return aim_at(stance_, moment(), aim.ball, aim.pocket); });
}

void Session::handle(const TurnBy& turn) {
  prepare([&] { return turn_by(stance_, turn.degrees); });
}

void Session::handle(const SetSpeed& speed) {
  prepare([&] { return set_speed(stance_, speed.m_s); });
}

void Session::handle(const SetTip& tip) {
  prepare([&] { return set_tip(stance_, moment(), tip.tip); });
}

void Session::handle(const MakeCall& call) {
  prepare([&] { return set_call(stance_, moment(), call.call); });
}

void Session::handle(const PlaceBall& place) {
  if (may_prepare()) give(match::Place{place.ball, place.position});
}

void Session::handle(const ShootNow&) {
  if (!may_prepare()) return;
  if (const auto problem = missing(stance_, moment())) return say(*problem);
  give(match::Shoot{*stance_.direction, stance_.speed_m_s, stance_.call, stance_.tip});
}

void Session::handle(const TakeOption& option) {
  const MatchView& view = player_.view();
  const auto options =
      is_asked() ? view.last->outcome.status.game.options : std::vector<rules::Option>{};
  if (options.empty()) return say("There is nothing to choose from now.");
  if (option.number < 1 || option.number > options.size()) {
    return say("Choose a number from 1 to " + std::to_string(options.size()) + ".");
  }
  give(match::Choose{options[option.number - 1]});
}

void Session::handle(const TellStatus&) {
  const MatchView& view = player_.view();
  if (!view.last) return say("The match has not started; it waits for every seat.");
  const Names names = names_of(view);
  const std::string score = score_text(view.last->outcome.status, names);
  if (!score.empty()) say(score);
  say(status_text(view.last->outcome.status, names));
  if (is_asked() && moment().game.options.empty()) say(preview(stance_, moment()));
}

void Session::handle(const TellInvitation&) {
  const MatchView& view = player_.view();
  say("To play: " + join_line(view.info, around_.server));
  say("To watch: breakshot watch " +
      (view.info.code ? "--code " + *view.info.code : words_of(view.info.id)) + " --server " +
      around_.server);
}

void Session::handle(const GiveUp& wish) {
  if (!wish.sure) return say("That cannot be taken back. If you mean it: concede yes.");
  give(match::Concede{});
}

void Session::handle(const ClaimMatch&) {
  report(player_.claim());
}

void Session::give(const match::Command& command) {
  if (!player_.view().last) return say("The match has not started; it waits for every seat.");
  report(player_.act(command));
}

void Session::report(const std::optional<lobby::Refused>& refused) {
  if (refused) say("That was refused: " + refused->what + ".");
}

}  // namespace breakshot::client
