#include "server/store/reading.hpp"

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "server/store/columns.hpp"

namespace breakshot::store {
namespace {

const std::string select_match =
    "SELECT match.id, settings, commitment, created_unix_ms, code, header, stage, next, score, "
    "winner, ending FROM match ";

ledger::Seats seats_of(Database& database, match::MatchId match, std::size_t count) {
  Statement row = database.prepare(
      "SELECT seat, guest, name, contribution FROM seat WHERE match = ? ORDER BY seat");
  row.bind(0, column_of(match));
  ledger::Seats seats(count);
  while (row.step()) {
    ledger::Sitter sitter{{bytes_in<32>(row, 1)}, row.text(2), std::nullopt};
    if (!row.is_null(3)) sitter.contribution = bytes_in<32>(row, 3);
    seats.at(static_cast<std::size_t>(row.number(0))) = std::move(sitter);
  }
  return seats;
}

/// The match in a row of `select_match`.
ledger::MatchRow match_in(Database& database, const Statement& row) {
  ledger::MatchRow match;
  match.id = id_in(row.number(0));
  match.settings = sound(record::decode_settings(row.blob(1)), "the settings");
  match.commitment = bytes_in<32>(row, 2);
  match.created_unix_ms = row.number(3);
  if (!row.is_null(4)) match.code = row.text(4);
  if (!row.is_null(5)) match.header = sound(record::decode_header(row.blob(5)), "the header");
  match.progress.stage = value_in(row, 6, match::Stage::finished);
  match.progress.next = value_in(row, 7, match::Seq{std::numeric_limits<std::uint32_t>::max()});
  match.progress.score = score_in(row.text(8));
  if (!row.is_null(9)) match.progress.winner = value_in(row, 9, match::Seat{255});
  if (!row.is_null(10)) match.progress.end = value_in(row, 10, match::MatchEnd::abandoned);
  match.seats = seats_of(database, match.id, match.settings.seats);
  return match;
}

std::vector<ledger::EntryPointer> entries_of(Database& database, match::MatchId match,
                                             match::Seq from, std::size_t bytes) {
  Statement row =
      database.prepare("SELECT bytes FROM entry WHERE match = ? AND seq >= ? ORDER BY seq");
  row.bind(0, column_of(match)).bind(1, column_of(from));
  std::vector<ledger::EntryPointer> entries;
  std::size_t read = 0;
  while ((entries.empty() || read < bytes) && row.step()) {
    const Statement::Blob blob = row.blob(0);
    read += blob.size();
    auto entry = sound(record::decode_entry(blob), "an entry");
    entries.push_back(std::make_shared<const record::Entry>(std::move(entry)));
  }
  return entries;
}

ledger::Found found(Database& database, const ledger::FindGuest& query) {
  Statement row = database.prepare("SELECT name FROM guest WHERE token_hash = ?");
  row.bind(0, query.id.token_hash);
  if (!row.step()) return ledger::FoundGuest{};
  return ledger::FoundGuest{ledger::Guest{query.id, row.text(0)}};
}

ledger::Found found(Database& database, const ledger::FindMatch& query) {
  if (!query.id && !query.code) return ledger::FoundMatch{};
  const std::string by = query.id && query.code ? "WHERE id = ? AND code = ?"
                         : query.id             ? "WHERE id = ?"
                                                : "WHERE code = ?";
  Statement row = database.prepare(select_match + by);
  int parameter = 0;
  if (query.id) row.bind(parameter++, column_of(*query.id));
  if (query.code) row.bind(parameter++, *query.code);
  if (!row.step()) return ledger::FoundMatch{};
  return ledger::FoundMatch{match_in(database, row)};
}

ledger::Found found(Database& database, const ledger::ListMatches& query) {
  constexpr const char* seat_of_guest = "(SELECT match FROM seat WHERE guest = ?1)";
  std::string sql = select_match;
  if (query.which == ledger::ListMatches::Which::mine) {
    sql += std::string("WHERE id IN ") + seat_of_guest;
  } else {
    sql += "WHERE stage = " + std::to_string(static_cast<int>(match::Stage::finished)) +
           " AND (code IS NULL OR id IN " + seat_of_guest + ")";
  }
  if (query.after) sql += " AND (created_unix_ms, id) < (?3, ?4)";
  sql += " ORDER BY created_unix_ms DESC, id DESC LIMIT ?2";
  Statement row = database.prepare(sql);
  row.bind(0, query.guest.token_hash).bind(1, static_cast<std::int64_t>(query.count));
  if (query.after) {
    row.bind(2, query.after->created_unix_ms).bind(3, column_of(query.after->match));
  }
  ledger::FoundMatches matches;
  while (row.step()) matches.rows.push_back(match_in(database, row));
  return matches;
}

ledger::Found found(Database& database, const ledger::FindEntries& query) {
  return ledger::FoundEntries{entries_of(database, query.match, query.from, query.bytes)};
}

match::Secret secret_of(Database& database, match::MatchId match) {
  Statement row = database.prepare("SELECT secret FROM secret WHERE match = ?");
  row.bind(0, column_of(match));
  if (!row.step()) throw std::runtime_error("its secret is missing");
  return bytes_in<32>(row, 0);
}

ledger::Restored restored(Database& database, const Statement& row) {
  const match::MatchId id = id_in(row.number(0));
  try {
    ledger::LiveMatch match;
    match.row = match_in(database, row);
    match.secret = secret_of(database, id);
    match.entries = entries_of(database, id, {}, std::numeric_limits<std::size_t>::max());
    return match;
  } catch (const SqliteError&) {
    throw;
  } catch (const std::exception& error) {
    return ledger::DamagedMatch{id, error.what()};
  }
}

}  // namespace

ledger::Found answer(Database& database, const ledger::Query& query) {
  return std::visit([&](const auto& kind) { return found(database, kind); }, query);
}

void read_live(Database& database, const std::function<void(ledger::Restored)>& give) {
  Statement row =
      database.prepare(select_match + "WHERE stage < " +
                       std::to_string(static_cast<int>(match::Stage::finished)) + " ORDER BY id");
  while (row.step()) give(restored(database, row));
}

}  // namespace breakshot::store
