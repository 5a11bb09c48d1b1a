// A person at a seat of a match: what is shown, what is asked, and what becomes of the answers.
#pragma once

#include <ostream>
#include <string>
#include <variant>

#include "client_cli/draw/abilities.hpp"
#include "client_cli/online/player.hpp"
#include "client_cli/online/shot_viewer.hpp"
#include "client_cli/online/teller.hpp"
#include "client_cli/play/input.hpp"
#include "client_cli/play/line_reader.hpp"
#include "client_cli/play/stance.hpp"

namespace breakshot::client {

struct Surroundings {
  std::ostream& out;
  /// Interactive: shots are played as moving pictures, and lines are read at any time. Otherwise
  /// they are read, one by one, only when it is the player's turn, so that a script can play.
  Abilities abilities;
  int input_fd = 0;
  bool json = false;   ///< what happens as JSON lines, and nothing else
  double speed = 1;    ///< of the moving pictures
  std::string server;  ///< as others may write it
};

class Session {
 public:
  Session(Connection& connection, MatchView view, const Surroundings& surroundings);

  /// Until the match is over or the player leaves; the exit status.
  int run();

 private:
  // What is told.
  void heard(const MatchView& view, const News& news);
  void show_shot(const MatchView& view, const record::Entry& entry);
  void say(const std::string& line);
  void say(const std::vector<std::string>& lines);
  void ask_if_due();
  void prompt();
  void show_table(bool unasked);
  void say_goodbye();
  /// Once each time that somebody begins to be away.
  void say_how_to_claim();

  // What is typed.
  void handle(const std::string& line);
  void handle(const Nothing&) {}
  void handle(const AimAlong& aim);
  void handle(const AimAt& aim);
  void handle(const TurnBy& turn);
  void handle(const SetSpeed& speed);
  void handle(const SetTip& tip);
  void handle(const MakeCall& call);
  void handle(const PlaceBall& place);
  void handle(const ShootNow&);
  void handle(const TakeOption& option);
  void handle(const ShowTable&) { show_table(false); }
  void handle(const TellStatus&);
  void handle(const TellInvitation&);
  void handle(const GiveUp& wish);
  void handle(const AgreeToRerack&) { give(match::AgreeRerack{}); }
  void handle(const ClaimMatch&);
  void handle(const AskHelp& help) { say(help_on(help.topic)); }
  void handle(const LeaveTable&) { leaving_ = true; }

  /// Lets `change` work on the stance, and shows what came of it or why it did not.
  template <class Change>
  void prepare(const Change& change);
  bool may_prepare();
  void give(const match::Command& command);
  void report(const std::optional<lobby::Refused>& refused);
  bool is_asked() const;
  Moment moment() const;

  Surroundings around_;
  Connection& connection_;
  Teller teller_;
  ShotViewer viewer_;
  LineReader lines_;
  Stance stance_;
  match::Seq live_from_;
  std::optional<match::Seq> asked_for_;  ///< the entry that the player has been asked for
  bool told_to_claim_ = false;
  bool leaving_ = false;
  Player player_;  ///< last: it tells the others as soon as it is made
};

}  // namespace breakshot::client
