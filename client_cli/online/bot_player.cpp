#include "client_cli/online/bot_player.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "client_cli/command_error.hpp"
#include "common/rules/groups.hpp"

namespace breakshot::client {
namespace {

constexpr Milliseconds a_while{60'000};
constexpr Milliseconds a_moment{100};
/// Shots of both players without a ball pocketed after which a table is a stalemate to the bot.
constexpr unsigned stalemate_shots = 24;
/// It gives up the match rather than try more shots of one position that cannot be played.
constexpr std::size_t most_refusals = 3;

bot::Position position_of(const MatchView& view) {
  const match::Outcome& outcome = view.last->outcome;
  return {view.info.settings.game, view.info.settings.scene, outcome.table, outcome.status.game};
}

/// Whether the bot should now say that it agrees to rack again.
bool agrees_to_rerack(const MatchView& view) {
  const match::Status& status = view.last->outcome.status;
  if (view.info.settings.game != match::GameKind::eight_ball || status.game.breaking) return false;
  const std::size_t me = rules::number(*view.you);
  const std::size_t other = rules::number(rules::other(*view.you));
  if (status.rerack_agreed[me]) return false;
  if (view.shots_dry >= stalemate_shots) return true;
  return status.rerack_agreed[other] && view.shots_dry >= stalemate_shots / 2;
}

class BotSeat {
 public:
  BotSeat(Player& player, const BotPlan& plan) : player_(player), plan_(plan) {}

  void play() {
    while (!is_over(player_.view())) {
      if (!may_act() || !act()) wait();
    }
  }

 private:
  /// For news; and if none comes from an opponent who is away, claims the match.
  void wait() {
    const auto patience = std::min(a_while, player_.claim_after() + a_moment);
    if (player_.hear(patience) || !opponent_is_away(player_.view())) return;
    // Too early, or he has come back at this moment: either way there will be news or time.
    player_.claim();
  }

  bool may_act() const {
    const MatchView& view = player_.view();
    return view.you && view.last && stage_of(view) == match::Stage::running && is_up_to_date(view);
  }

  /// Whether there was something to do.
  bool act() {
    const MatchView& view = player_.view();
    if (agrees_to_rerack(view)) {
      give(match::AgreeRerack{});
      return true;
    }
    if (!is_my_turn(view)) return false;
    if (plan_.most_shots && view.shots >= *plan_.most_shots) {
      give(match::Concede{});
      return true;
    }
    bot::Effort effort = plan_.effort;
    effort.turn = static_cast<std::uint32_t>(view.next);
    effort.skip = refusals_;
    const bot::Decision decision = bot::decide(position_of(view), effort);
    if (decision.place && !give(*decision.place)) return true;
    std::visit([&](const auto& command) { give(command); }, decision.act);
    return true;
  }

  bool give(const match::Command& command) {
    const auto refused = player_.act(command);
    if (!refused) {
      // A place that was taken says nothing yet about the shot that is to follow from it.
      if (!std::holds_alternative<match::Place>(command)) refusals_ = 0;
      return true;
    }
    // The match has moved on meanwhile: the news of it is on its way.
    const bool moved_on = refused->detail == match::RefusalCode::wrong_sequence ||
                          refused->detail == match::RefusalCode::finished ||
                          refused->detail == match::RefusalCode::not_your_turn;
    if (moved_on) {
      player_.hear(a_while);
      return false;
    }
    if (std::holds_alternative<match::Concede>(command)) refuse(*refused);
    if (++refusals_ >= most_refusals) give(match::Concede{});
    return false;
  }

  Player& player_;
  const BotPlan& plan_;
  std::size_t refusals_ = 0;
};

}  // namespace

void play_as_bot(Player& player, const BotPlan& plan) {
  BotSeat(player, plan).play();
}

}  // namespace breakshot::client
