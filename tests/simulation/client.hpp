// A client who does what comes to mind, most of it sensible, and watches closely what it is told:
// every request is answered once, every followed entry comes once and in order.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/lobby/lobby.hpp"
#include "tests/support/chance.hpp"
#include "tests/support/random_asks.hpp"

namespace breakshot::simulation {

/// What goes round by word of mouth: the matches and codes that clients have heard of.
struct Gossip {
  std::vector<match::MatchId> matches;
  std::vector<lobby::InviteCode> codes;
};

class Client {
 public:
  Client(std::string name, std::uint64_t seed)
      : name_(std::move(name)), chance_(seed), asks_(seed) {}

  // ---- The connection

  void connected();
  void disconnected();
  bool is_connected() const { return connected_; }

  /// What it says next, if anything comes to mind.
  std::optional<lobby::Asked> speak(Gossip& gossip);
  /// Hears what it is told. Throws Broken if it must not be told that.
  void hear(const lobby::Told& told, Gossip& gossip);

  // ---- What it knows

  const std::optional<lobby::Token>& token() const { return token_; }
  std::size_t unanswered() const { return unanswered_.size(); }
  /// By match: the number of the entry that it is to be told next.
  const std::map<match::MatchId, std::uint32_t>& follows() const { return follows_; }

  struct Counts {
    std::size_t refused = 0;
    std::size_t repeats_answered = 0;  ///< a command sent again, answered with its entry
    std::size_t wishes_repeated = 0;   ///< a Create sent again, answered with a match
    std::size_t fetched = 0;
  };
  const Counts& counts() const { return counts_; }

 private:
  /// What it has been told about a match.
  struct Known {
    lobby::MatchInfo info;
    std::optional<match::Seat> you;
    std::optional<match::Outcome> last;  ///< of the newest entry that it was told
    std::uint32_t next = 0;              ///< the number after that one
  };
  struct Open {
    lobby::Request request;
    std::uint32_t next = 0;  ///< of a fetch: the number that comes next
  };

  lobby::Asked say(lobby::Request request);
  lobby::Request something(Gossip& gossip);
  lobby::Request wish();
  std::optional<lobby::Request> about_a_match(Gossip& gossip);
  std::optional<lobby::Request> command();
  match::Match as_seen(const Known& known) const;
  const Known* some_known();
  const Known* some_own();

  void hear_unasked(const lobby::Answer& answer);
  void hear_answer(lobby::RequestId id, const lobby::Answer& answer, Gossip& gossip);
  void learn(const lobby::MatchNews& news);
  void learn(const lobby::EntryNews& news);
  void follow_on(const lobby::EntryNews& news);
  void answered(const Open& open, const lobby::Answer& answer, Gossip& gossip);
  void came_of(const lobby::Create& create, const lobby::Answer& answer);

  std::string name_;
  support::Chance chance_;
  support::RandomAsks asks_;
  std::optional<lobby::Token> token_;
  bool connected_ = false;
  bool welcomed_ = false;
  std::uint32_t last_request_ = 0;
  std::map<lobby::RequestId, Open> unanswered_;
  std::map<match::MatchId, std::uint32_t> follows_;
  std::map<match::MatchId, Known> known_;
  /// The command that it has not seen answered yet, which it sends again.
  std::optional<lobby::Act> pending_;
  bool repeated_ = false;
  /// The Create with a key that it has not seen answered yet, which it sends again.
  std::optional<lobby::Create> wish_;
  bool wish_repeated_ = false;
  Counts counts_;
};

}  // namespace breakshot::simulation
