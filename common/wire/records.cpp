#include "common/wire/records.hpp"

#include "common/lobby/name.hpp"
#include "common/wire/matches.hpp"

namespace breakshot::wire {

void write(const record::Header& header, v1::Header& message) {
  message.set_format(header.format);
  message.set_physics(header.physics);
  message.set_match(static_cast<std::uint64_t>(header.id));
  message.set_created_unix_ms(header.created_unix_ms);
  write(header.settings, *message.mutable_settings());
  for (const record::Player& player : header.players) {
    v1::Player& said = *message.add_players();
    said.set_name(player.name);
    said.set_contribution(player.contribution.data(), player.contribution.size());
  }
  message.set_commitment(header.commitment.data(), header.commitment.size());
}

record::Header read(const v1::Header& message, const Where& at) {
  record::Header header;
  header.format = message.format();
  header.physics = message.physics();
  header.id = match::MatchId{message.match()};
  header.created_unix_ms = message.created_unix_ms();
  header.settings = read(message.settings(), Where(at, "settings"));
  check_per_seat(message.players_size(), Where(at, "players"));
  for (int i = 0; i < message.players_size() && at.good(); ++i) {
    const v1::Player& player = message.players(i);
    const Where here(at, "players", i);
    if (auto fault = lobby::name_fault(player.name())) Where(here, "name").refuse(*fault);
    header.players.push_back(
        {player.name(), bytes32(player.contribution(), Where(here, "contribution"))});
  }
  header.commitment = bytes32(message.commitment(), Where(at, "commitment"));
  return header;
}

void write(const record::Entry& entry, v1::Entry& message) {
  message.set_seq(static_cast<std::uint32_t>(entry.seq));
  if (entry.author.seat) message.set_seat(number(*entry.author.seat));
  message.set_command_id(static_cast<std::uint64_t>(entry.id));
  write(entry.command, *message.mutable_command());
  write(entry.outcome, *message.mutable_outcome());
  if (entry.secret) message.set_secret(entry.secret->data(), entry.secret->size());
  message.set_digest(entry.digest.data(), entry.digest.size());
}

record::Entry read(const v1::Entry& message, const Where& at) {
  record::Entry entry;
  entry.seq = match::Seq{message.seq()};
  if (message.has_seat()) entry.author.seat = seat(message.seat(), Where(at, "seat"));
  entry.id = match::CommandId{message.command_id()};
  entry.command = read(message.command(), Where(at, "command"));
  entry.outcome = read(message.outcome(), Where(at, "outcome"));
  entry.secret = optional_bytes32(message.secret(), Where(at, "secret"));
  entry.digest = bytes32(message.digest(), Where(at, "digest"));
  return entry;
}

}  // namespace breakshot::wire
