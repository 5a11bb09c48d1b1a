// Tells people, or with --json programs, how a followed match goes: a line for everything that
// happens, written at once.
#pragma once

#include <optional>
#include <ostream>
#include <vector>

#include "client_cli/account.hpp"
#include "client_cli/json.hpp"
#include "client_cli/online/match_view.hpp"

namespace breakshot::client {

/// What the lobby knows of a match.
Json json_of(const lobby::MatchInfo& info);

class Teller {
 public:
  /// `wraps`: `out` is the terminal, and what is told to people is broken between words.
  Teller(std::ostream& out, bool json, bool wraps = false)
      : out_(out), json_(json), wraps_(wraps && !json) {}

  /// What is known when one begins to follow; a join line for those who sit at an open match.
  void begin(const MatchView& view, const std::string& server);
  void tell(const MatchView& view, const News& news);

 private:
  void tell(const MatchView& view, const lobby::MatchNews& news);
  void tell(const MatchView& view, const EntryPtr& entry);
  void tell(const MatchView& view, const lobby::MatchGone& gone);
  void say(const std::string& line);

  std::ostream& out_;
  bool json_;
  bool wraps_;
  std::vector<lobby::SeatInfo> seats_;
  std::optional<Account> account_;
};

/// How somebody else joins an open match: the whole command line.
std::string join_line(const lobby::MatchInfo& info, const std::string& server);

/// What changed at the seats, in sentences: "Bob sits down.", "Ann is away."
std::vector<std::string> seat_changes(const std::vector<lobby::SeatInfo>& before,
                                      const std::vector<lobby::SeatInfo>& after);

}  // namespace breakshot::client
