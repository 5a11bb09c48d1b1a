#include "server/hub/creation.hpp"

#include <optional>
#include <variant>
#include <vector>

#include "server/hub/seating.hpp"

namespace breakshot::hub {
namespace {

/// Whether this guest opened the match with the key.
bool opened(const LiveMatch& match, const Ask& ask, const lobby::CreationKey& key) {
  const auto& creation = match.creation;
  return creation && creation->guest == ask.guest.id && creation->wish.key == key;
}

LiveMatch* opened_before(State& state, const Ask& ask, const lobby::CreationKey& key) {
  for (auto& [id, match] : state.matches) {
    if (opened(match, ask, key)) return &match;
  }
  return nullptr;
}

StoringMatch* being_opened(State& state, const Ask& ask, const lobby::CreationKey& key) {
  for (auto& [ticket, storing] : state.storing) {
    auto* created = std::get_if<StoringMatch>(&storing);
    if (created && opened(created->match, ask, key)) return created;
  }
  return nullptr;
}

/// Those whose connection is gone are forgotten, and a guest has one connection at a time: no more
/// wait than one connection may ask.
void wait_for(Moment& moment, const Asker& asker, std::vector<Asker>& waiting) {
  std::erase_if(waiting, [&](const Asker& other) {
    return open_connection(moment.state, other.connection) == nullptr;
  });
  waiting.push_back(asker);
}

}  // namespace

bool create_again(Moment& moment, const Ask& ask, const lobby::Create& create) {
  if (!create.key) return false;
  LiveMatch* live = opened_before(moment.state, ask, *create.key);
  StoringMatch* storing = live ? nullptr : being_opened(moment.state, ask, *create.key);
  if (!live && !storing) return false;
  const LiveMatch& match = live ? *live : storing->match;
  if (match.creation->wish != create) {
    refuse(moment, ask.asker, lobby::RefusalCode::bad_request,
           "key: it is that of a match of yours with other settings; a new match takes a new key");
  } else if (live) {
    come_back(moment, ask.asker, *live);
  } else {
    wait_for(moment, ask.asker, storing->again);
  }
  return true;
}

void come_back(Moment& moment, const Asker& asker, LiveMatch& match) {
  const ledger::Guest* guest = guest_of(moment.state, asker.connection);
  if (!guest) return;
  // The seat is the guest's: nothing is to be stored, and so no change under way is in the way.
  join(moment, {asker, *guest}, match, lobby::Join{match.row.id, std::nullopt, match::Seq{}});
}

}  // namespace breakshot::hub
