// Sees everything that the hub orders and says, and everything that is stored: whatever is told
// must have been stored before, nothing stored is ever lost or changed, and a command has one
// outcome, however often a failure makes it be asked for again.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "server/hub/hub.hpp"
#include "tests/support/memory_store.hpp"

namespace breakshot::simulation {

class Witness {
 public:
  /// The hub orders this to be stored, after what `kept` holds.
  void appended(const support::Kept& kept, const ledger::Batch& batch);
  /// This is stored now.
  void stored(const support::Kept& kept);
  /// A guest shows the code of a private match.
  void shown(const ledger::GuestId& guest, const std::string& code);
  /// The hub tells this to a guest.
  void told(const support::Kept& kept, const ledger::GuestId& to, const lobby::Answer& answer);
  /// Everything that was ever told is still there, unchanged.
  void nothing_lost(const support::Kept& kept) const;

  std::size_t entries_told() const { return told_.size(); }
  /// Commands that were played again after a failure.
  std::size_t outcomes_repeated() const { return outcomes_repeated_; }

 private:
  using Names = std::vector<std::string>;
  using Place = std::pair<match::MatchId, std::uint32_t>;
  using Command =
      std::tuple<match::MatchId, hash::Digest, std::optional<match::Seat>, match::CommandId>;

  /// What was ever stored about a match.
  struct Seen {
    std::optional<std::string> code;
    std::set<Names> seats;
    std::set<ledger::GuestId> sitters;
    match::Seq next{};
  };

  void check(const ledger::GuestId& to, const lobby::MatchInfo& info) const;
  void check(const support::Kept& kept, const ledger::GuestId& to, const lobby::EntryNews& news);
  const Seen& seen_by(const ledger::GuestId& guest, match::MatchId match) const;

  std::map<match::MatchId, Seen> seen_;
  std::map<Place, hash::Digest> told_;
  std::map<Command, ledger::EntryPointer> outcomes_;
  std::set<std::pair<ledger::GuestId, std::string>> shown_;
  std::size_t outcomes_repeated_ = 0;
};

}  // namespace breakshot::simulation
