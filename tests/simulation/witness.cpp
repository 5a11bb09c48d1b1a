#include "tests/simulation/witness.hpp"

#include "tests/simulation/broken.hpp"

namespace breakshot::simulation {

void Witness::appended(const support::Kept& kept, const ledger::Batch& batch) {
  for (const ledger::Change& change : batch) {
    const auto* append = std::get_if<ledger::AppendEntry>(&change);
    if (!append) continue;
    const record::Entry& entry = *append->entry;
    const auto& entries = kept.matches.at(append->match).entries;
    // The first entry depends on contributions that may yet change if it is not stored.
    if (entries.empty()) continue;
    const Command command(append->match, entries.back()->digest, entry.author.seat, entry.id);
    const auto [known, is_new] = outcomes_.emplace(command, append->entry);
    if (is_new || known->second->command != entry.command) continue;
    require(*known->second == entry, "a command has another outcome the second time");
    ++outcomes_repeated_;
  }
}

void Witness::stored(const support::Kept& kept) {
  for (const auto& [id, match] : kept.matches) {
    Seen& seen = seen_[id];
    seen.code = match.row.code;
    seen.next = match.row.progress.next;
    Names names;
    for (const auto& sitter : match.row.seats) {
      names.push_back(sitter ? sitter->name : "");
      if (sitter) seen.sitters.insert(sitter->guest);
    }
    seen.seats.insert(std::move(names));
  }
}

void Witness::shown(const ledger::GuestId& guest, const std::string& code) {
  shown_.insert({guest, code});
}

void Witness::told(const support::Kept& kept, const ledger::GuestId& to,
                   const lobby::Answer& answer) {
  if (const auto* news = std::get_if<lobby::EntryNews>(&answer)) check(kept, to, *news);
  if (const auto* news = std::get_if<lobby::MatchNews>(&answer)) check(to, news->info);
  if (const auto* listing = std::get_if<lobby::Listing>(&answer)) {
    for (const lobby::MatchInfo& info : listing->matches) {
      check(to, info);
      require(!info.is_private || seen_.at(info.id).sitters.contains(to),
              "a private match was listed for one who does not sit at it");
    }
  }
}

void Witness::nothing_lost(const support::Kept& kept) const {
  for (const auto& [place, digest] : told_) {
    const auto& entries = kept.matches.at(place.first).entries;
    require(place.second < entries.size(), "an entry that was told is lost");
    require(entries[place.second]->digest == digest, "an entry that was told has changed");
  }
}

const Witness::Seen& Witness::seen_by(const ledger::GuestId& guest, match::MatchId match) const {
  const auto seen = seen_.find(match);
  require(seen != seen_.end(), "a match was told of that was never stored");
  const auto& code = seen->second.code;
  require(!code || seen->second.sitters.contains(guest) || shown_.contains({guest, *code}),
          "a private match was told of to one who has neither seat nor code");
  return seen->second;
}

void Witness::check(const ledger::GuestId& to, const lobby::MatchInfo& info) const {
  const Seen& seen = seen_by(to, info.id);
  require(info.next <= seen.next, "a match was told to be further than it is stored");
  Names names;
  for (const lobby::SeatInfo& seat : info.seats) names.push_back(seat.name);
  require(seen.seats.contains(names), "seats were told that were never stored");
  require(!info.code || seen.sitters.contains(to), "the code was told to one who does not sit");
}

void Witness::check(const support::Kept& kept, const ledger::GuestId& to,
                    const lobby::EntryNews& news) {
  seen_by(to, news.match);
  const auto& entries = kept.matches.at(news.match).entries;
  const auto seq = static_cast<std::uint32_t>(news.entry->seq);
  require(seq < entries.size(), "an entry was told that is not stored");
  require(*entries[seq] == *news.entry, "an entry was told that is not the stored one");
  const bool finished = news.entry->outcome.status.stage == match::Stage::finished;
  require(news.entry->secret.has_value() == finished, "the secret comes with the last entry");
  told_.emplace(Place(news.match, seq), news.entry->digest);
}

}  // namespace breakshot::simulation
