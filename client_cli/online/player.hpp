// A seat at a match: keeps the view of it, contributes to the seed, and carries out commands.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "client_cli/online/connection.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/online/match_view.hpp"

namespace breakshot::client {

/// Sit down at any suitable match: one's own that is still running, else an open one with the same
/// settings, else a new one.
struct AnyMatch {
  lobby::Create settings;
};
/// How a player comes to a match.
using Opening = std::variant<lobby::Create, MatchName, AnyMatch>;

/// Sits down; a new match gets a key of its own. CommandError where the server does not let the
/// guest.
MatchView sit_down(Connection& connection, const Opening& opening);

class Player {
 public:
  /// Called after each piece of news, when the view shows it.
  using Heard = std::function<void(const MatchView&, const News&)>;

  /// `connection` must outlive the player.
  Player(Connection& connection, MatchView view, Heard heard);

  const MatchView& view() const { return view_; }

  /// Hears one piece of news; false if none came in time, or once `other` can be read.
  bool hear(Milliseconds patience, int other = -1);

  /// Gives `command` as the next entry. When it has been accepted, all news up to it has been
  /// heard.
  std::optional<lobby::Refused> act(const match::Command& command);

  /// How long an opponent must have been away before the match can be claimed.
  Milliseconds claim_after() const { return Milliseconds(connection_.welcome().claim_after_ms); }
  /// Asks for the match, since the opponent has vanished.
  std::optional<lobby::Refused> claim();

 private:
  std::optional<lobby::Refused> carry_out(const lobby::Request& request);
  void contribute_if_asked();

  Connection& connection_;
  MatchView view_;
  Heard heard_;
  match::Contribution contribution_;
  bool contributed_ = false;
};

}  // namespace breakshot::client
