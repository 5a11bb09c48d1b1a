// Finished or running matches as commands name them: a file, standard input or a match on a server;
// and the shots that are in them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client_cli/command.hpp"
#include "client_cli/draw/picture.hpp"
#include "common/record/record.hpp"

namespace breakshot::client {

struct StoredMatch {
  record::Record record;
  std::optional<record::Damage> damage;  ///< the record is what stood before it
};

/// Opens what a user named: "-" is standard input, a name that exists as a file is one, and
/// otherwise 16 hexadecimal digits or an invite code name a match on the server. Throws
/// CommandError where there is no record, which names the source and what is wrong. The server is
/// asked as `guest`, whose token is kept here, or as nobody in particular.
StoredMatch open_match(const std::string& name, const Globals& globals,
                       const std::string& guest = {});

/// How damage is reported: "damaged at byte 17: ...; the 3 entries before it are whole".
std::string damage_text(const StoredMatch& match);

/// One shot of a match with what was known before it. Refers to the record's entry.
struct StoredShot {
  const record::Entry* entry = nullptr;
  std::uint32_t number = 0;               ///< from 1
  match::Status before;                   ///< what the shooter met
  std::vector<physics::BallId> pocketed;  ///< of this rack, before the shot, in order

  const match::Shoot& command() const { return std::get<match::Shoot>(entry->command); }
  const physics::Shot& shot() const { return *entry->outcome.shot; }
};

/// All shots in order. `record` must outlive them.
std::vector<StoredShot> shots_of(const record::Record& record);

/// The shot of that number. Throws CommandError, which says which there are, where there is none.
const StoredShot& shot_of(const std::vector<StoredShot>& shots, std::uint32_t number);

/// Where the cue ball stood at the start of an entry's shot and how it was struck.
CueVector cue_vector_of(const record::Entry& entry);

/// Follows which balls of a rack are down, entry by entry.
class PocketedBalls {
 public:
  void follow(const match::Outcome& outcome);
  const std::vector<physics::BallId>& balls() const { return balls_; }

 private:
  std::vector<physics::BallId> balls_;
};

}  // namespace breakshot::client
