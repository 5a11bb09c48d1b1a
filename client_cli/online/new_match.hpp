// What the command line may say about the match at which to play.
#pragma once

#include <string>

#include "client_cli/online/match_name.hpp"
#include "client_cli/online/player.hpp"

namespace breakshot::client {

/// MATCH, --code or --new, and the settings of a new match.
class OpeningOptions {
 public:
  void add_to(CLI::App& parser);
  /// CommandError, with exit_usage, for what does not go together.
  Opening opening() const;

 private:
  lobby::Create create() const;

  MatchOptions match_;
  bool new_ = false;
  bool private_ = false;
  unsigned race_to_ = 1;
  unsigned seats_ = 1;
  std::string preset_;
  match::GameKind game_ = match::GameKind::eight_ball;
};

}  // namespace breakshot::client
