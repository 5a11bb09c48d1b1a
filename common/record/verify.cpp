#include "common/record/chain.hpp"
#include "common/record/difference.hpp"
#include "common/record/record.hpp"

namespace breakshot::record {
namespace {

using Fault = std::optional<std::string>;

Verdict diverged(std::size_t verified, match::Seq seq, std::string what) {
  return {Verdict::Kind::diverged, verified, Divergence{seq, std::move(what)}};
}

match::Seq seq_at(std::size_t index) {
  return match::Seq{static_cast<std::uint32_t>(index)};
}

/// What keeps a match from being started from `header`.
Fault start_fault(const Header& header) {
  if (auto fault = fault_of(header)) return fault;
  if (auto fault = newer_part_of(header.settings.scene, header.physics)) {
    return *fault + "; the header says " + std::to_string(header.physics);
  }
  const std::vector<physics::Fault> faults = match::faults_of(header.settings);
  if (faults.empty()) return std::nullopt;
  return faults.front().field + ": " + faults.front().what;
}

Fault commitment_fault(const Header& header, const match::Secret& secret) {
  const hash::Digest commitment = match::commitment_of(secret);
  if (commitment == header.commitment) return std::nullopt;
  return "secret: its commitment is " + hash::hex_of(commitment) + ", the header has " +
         hash::hex_of(header.commitment);
}

match::Match start_of(const Header& header, const match::Secret& secret) {
  std::vector<match::Contribution> contributions;
  for (const Player& player : header.players) contributions.push_back(player.contribution);
  return match::created(header.settings, match::seed_of(secret, contributions), header.physics);
}

/// Plays the command of `entry` again and moves `match` on; or says how what is stored differs.
Fault replay_fault(match::Match& match, const Entry& entry) {
  const match::Ask ask{entry.author, entry.seq, entry.command};
  auto answer = match::apply(match, ask);
  if (const auto* refusal = std::get_if<match::Refusal>(&answer)) {
    return "command: refused: " + refusal->what;
  }
  auto& accepted = std::get<match::Accepted>(answer);
  if (auto difference = difference_of(entry.outcome, accepted.outcome)) return difference;
  match = std::move(accepted.next);
  const bool finished = match.status.stage == match::Stage::finished;
  if (entry.secret && !finished) return "secret: revealed before the match was finished";
  return std::nullopt;
}

/// Without the secret nothing can be simulated, but order and digests must hold.
Verdict verdict_on_chain(const Record& record) {
  Chain chain(record.header);
  for (std::size_t i = 0; i < record.entries.size(); ++i) {
    auto fault = chain.place_fault(record.entries[i]);
    if (!fault) fault = chain.append(record.entries[i]);
    if (fault) return diverged(0, seq_at(i), std::move(*fault));
  }
  return {Verdict::Kind::not_revealed_yet, 0, std::nullopt};
}

}  // namespace

Verdict verify(const Record& record) {
  const Header& header = record.header;
  if (!can_simulate(header.physics)) {
    return {Verdict::Kind::unknown_physics, 0, std::nullopt};
  }
  if (auto fault = start_fault(header)) return diverged(0, seq_at(0), "header: " + *fault);
  if (record.entries.empty() || !record.entries.back().secret) return verdict_on_chain(record);
  const match::Secret& secret = *record.entries.back().secret;
  if (auto fault = commitment_fault(header, secret)) {
    return diverged(0, seq_at(record.entries.size() - 1), std::move(*fault));
  }
  match::Match match = start_of(header, secret);
  Chain chain(header);
  for (std::size_t i = 0; i < record.entries.size(); ++i) {
    const Entry& entry = record.entries[i];
    auto fault = chain.place_fault(entry);
    if (!fault) fault = replay_fault(match, entry);
    if (!fault) fault = chain.append(entry);
    if (fault) return diverged(i, seq_at(i), std::move(*fault));
  }
  return {Verdict::Kind::verified, record.entries.size(), std::nullopt};
}

}  // namespace breakshot::record
