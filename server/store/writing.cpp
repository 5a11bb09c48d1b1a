#include "server/store/writing.hpp"

#include <stdexcept>
#include <variant>

#include "server/store/columns.hpp"

namespace breakshot::store {
namespace {

template <class Value>
std::optional<std::int64_t> number_of(const std::optional<Value>& value) {
  if (!value) return std::nullopt;
  return static_cast<std::int64_t>(*value);
}

}  // namespace

Writing::Writing(Database& database)
    : database_(database),
      put_guest_(database.prepare("INSERT INTO guest (token_hash, name) VALUES (?, ?) "
                                  "ON CONFLICT (token_hash) DO UPDATE SET name = excluded.name")),
      create_match_(database.prepare(
          "INSERT INTO match (id, settings, commitment, created_unix_ms, code, stage, next, score) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?)")),
      put_secret_(database.prepare("INSERT INTO secret (match, secret) VALUES (?, ?)")),
      hold_gathering_(
          database.prepare("UPDATE match SET stage = stage WHERE id = ? AND stage = 0")),
      delete_seats_(database.prepare("DELETE FROM seat WHERE match = ?")),
      put_seat_(database.prepare(
          "INSERT INTO seat (match, seat, guest, name, contribution) VALUES (?, ?, ?, ?, ?)")),
      put_header_(database.prepare(
          "UPDATE match SET header = ? WHERE id = ? AND stage = 0 AND header IS NULL")),
      advance_(database.prepare(
          "UPDATE match SET stage = ?, next = ?, score = ?, winner = ?, ending = ? "
          "WHERE id = ? AND next = ? AND header IS NOT NULL")),
      append_entry_(database.prepare("INSERT INTO entry (match, seq, bytes) VALUES (?, ?, ?)")),
      discard_(database.prepare("DELETE FROM match WHERE id = ? AND stage = 0")) {}

void Writing::carry_out(const ledger::Change& what) {
  std::visit([this](const auto& kind) { change(kind); }, what);
}

void Writing::change(const ledger::PutGuest& put) {
  put_guest_.bind(0, put.guest.id.token_hash).bind(1, put.guest.name).run();
}

void Writing::change(const ledger::CreateMatch& create) {
  const ledger::MatchRow& row = create.row;
  create_match_.bind(0, column_of(row.id))
      .bind(1, record::encode(row.settings))
      .bind(2, row.commitment)
      .bind(3, row.created_unix_ms)
      .bind_optional(4, row.code)
      .bind(5, static_cast<std::int64_t>(row.progress.stage))
      .bind(6, column_of(row.progress.next))
      .bind(7, column_of(row.progress.score))
      .run();
  put_secret_.bind(0, column_of(row.id)).bind(1, create.secret).run();
  insert_seats(row.id, row.seats);
}

void Writing::change(const ledger::PutSeats& put) {
  hold_gathering_.bind(0, column_of(put.match));
  change_one(hold_gathering_, "there is no such match whose seats may change");
  delete_seats_.bind(0, column_of(put.match)).run();
  insert_seats(put.match, put.seats);
}

void Writing::change(const ledger::PutHeader& put) {
  put_header_.bind(0, record::encode(put.header)).bind(1, column_of(put.header.id));
  change_one(put_header_, "there is no such match that may start");
}

void Writing::change(const ledger::AppendEntry& append) {
  const record::Entry& entry = *append.entry;
  const ledger::Progress progress = ledger::progress_after(entry);
  advance_.bind(0, static_cast<std::int64_t>(progress.stage))
      .bind(1, column_of(progress.next))
      .bind(2, column_of(progress.score))
      .bind_optional(3, number_of(progress.winner))
      .bind_optional(4, number_of(progress.end))
      .bind(5, column_of(append.match))
      .bind(6, column_of(entry.seq));
  change_one(advance_, "the entry is not the next one of its match");
  append_entry_.bind(0, column_of(append.match))
      .bind(1, column_of(entry.seq))
      .bind(2, record::encode(entry))
      .run();
}

void Writing::change(const ledger::DiscardMatch& discard) {
  discard_.bind(0, column_of(discard.match));
  change_one(discard_, "there is no such match that has not started");
}

void Writing::insert_seats(match::MatchId match, const ledger::Seats& seats) {
  for (std::size_t seat = 0; seat < seats.size(); ++seat) {
    const auto& sitter = seats[seat];
    if (!sitter) continue;
    put_seat_.bind(0, column_of(match))
        .bind(1, static_cast<std::int64_t>(seat))
        .bind(2, sitter->guest.token_hash)
        .bind(3, sitter->name)
        .bind_optional(4, sitter->contribution)
        .run();
  }
}

void Writing::change_one(Statement& statement, const char* otherwise) {
  statement.run();
  if (database_.changes() != 1) throw std::runtime_error(otherwise);
}

}  // namespace breakshot::store
