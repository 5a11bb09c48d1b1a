#include "client_cli/online/player.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "client_cli/command_error.hpp"

namespace breakshot::client {
namespace {

match::CommandId fresh_command_id() {
  const auto bytes = entropy();
  std::uint64_t id = 0;
  std::memcpy(&id, bytes.data(), sizeof id);
  return match::CommandId{id == 0 ? 1 : id};
}

lobby::CreationKey fresh_key() {
  const auto bytes = entropy();
  lobby::CreationKey key{};
  std::copy_n(bytes.begin(), key.size(), key.begin());
  return key;
}

/// The matches of one filter, the newest first; one page is plenty to choose from.
std::vector<lobby::MatchInfo> listed(Connection& connection, lobby::Filter filter) {
  const auto answer = connection.ask(lobby::List{filter, std::nullopt});
  if (const auto* refused = std::get_if<lobby::Refused>(&answer)) refuse(*refused);
  const auto* listing = std::get_if<lobby::Listing>(&answer);
  return listing == nullptr ? std::vector<lobby::MatchInfo>{} : listing->matches;
}

bool suits(const lobby::MatchInfo& info, const lobby::Create& wish) {
  return has_free_seat(info) && info.settings.game == wish.game &&
         info.settings.race_to == wish.race_to && info.settings.seats == wish.seats &&
         (wish.preset.empty() || info.settings.preset == wish.preset);
}

MatchView seated(const lobby::Answer& answer) {
  if (const auto* refused = std::get_if<lobby::Refused>(&answer)) refuse(*refused);
  const auto* news = std::get_if<lobby::MatchNews>(&answer);
  if (news == nullptr) throw CommandError("the server's answer makes no sense here");
  return view_of(*news);
}

MatchView sit_down_at(Connection& connection, lobby::Create create) {
  // The request may be asked again without our seeing it: the key makes that the same match.
  create.key = fresh_key();
  return seated(connection.ask(create));
}

MatchView sit_down_at(Connection& connection, const MatchName& name) {
  return seated(connection.ask(lobby::Join{name.id, name.code, {}}));
}

MatchView sit_down_at(Connection& connection, const AnyMatch& any) {
  for (const auto& mine : listed(connection, lobby::Filter::mine)) {
    if (mine.stage == match::Stage::finished) continue;
    return sit_down_at(connection, MatchName{mine.id, std::nullopt});
  }
  for (const auto& open : listed(connection, lobby::Filter::open)) {
    if (!suits(open, any.settings)) continue;
    const auto answer = connection.ask(lobby::Join{open.id, std::nullopt, {}});
    // Somebody may have been faster.
    if (std::holds_alternative<lobby::MatchNews>(answer)) return seated(answer);
  }
  return sit_down_at(connection, any.settings);
}

}  // namespace

MatchView sit_down(Connection& connection, const Opening& opening) {
  return std::visit([&](const auto& way) { return sit_down_at(connection, way); }, opening);
}

Player::Player(Connection& connection, MatchView view, Heard heard)
    : connection_(connection),
      view_(std::move(view)),
      heard_(std::move(heard)),
      contribution_(entropy()) {
  contribute_if_asked();
}

bool Player::hear(Milliseconds patience, int other) {
  const auto news = connection_.next(patience, other);
  if (!news) return false;
  take(view_, *news);
  heard_(view_, *news);
  contribute_if_asked();
  return true;
}

std::optional<lobby::Refused> Player::act(const match::Command& command) {
  return carry_out(lobby::Act{view_.info.id, view_.next, fresh_command_id(), command});
}

std::optional<lobby::Refused> Player::claim() {
  return carry_out(lobby::Claim{view_.info.id});
}

std::optional<lobby::Refused> Player::carry_out(const lobby::Request& request) {
  const auto answer = connection_.ask(request);
  if (const auto* refused = std::get_if<lobby::Refused>(&answer)) return *refused;
  const auto* news = std::get_if<lobby::EntryNews>(&answer);
  if (news == nullptr) throw CommandError("the server's answer makes no sense here");
  // Everything up to the entry has arrived with it.
  while (view_.next <= news->entry->seq && hear(Milliseconds::zero())) {
  }
  return std::nullopt;
}

void Player::contribute_if_asked() {
  if (contributed_ || !view_.you || stage_of(view_) != match::Stage::gathering) return;
  const std::size_t seat = rules::number(*view_.you);
  if (seat >= view_.info.seats.size() || view_.info.seats[seat].contributed) return;
  const auto answer = connection_.ask(lobby::Contribute{view_.info.id, contribution_});
  if (const auto* refused = std::get_if<lobby::Refused>(&answer)) refuse(*refused);
  contributed_ = true;
}

}  // namespace breakshot::client
