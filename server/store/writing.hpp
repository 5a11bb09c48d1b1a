// Each change in SQL.
#pragma once

#include "server/ledger/ledger.hpp"
#include "server/store/sqlite.hpp"

namespace breakshot::store {

/// Carries out changes; one for each connection that writes.
class Writing {
 public:
  explicit Writing(Database& database);

  /// Within the caller's transaction. Throws if the change cannot be made; what was made before it
  /// is then the caller's to undo.
  void carry_out(const ledger::Change& change);

 private:
  void change(const ledger::PutGuest& put);
  void change(const ledger::CreateMatch& create);
  void change(const ledger::PutSeats& put);
  void change(const ledger::PutHeader& put);
  void change(const ledger::AppendEntry& append);
  void change(const ledger::DiscardMatch& discard);
  void insert_seats(match::MatchId match, const ledger::Seats& seats);
  /// Runs a statement that must change exactly one row.
  void change_one(Statement& statement, const char* otherwise);

  Database& database_;
  Statement put_guest_;
  Statement create_match_;
  Statement put_secret_;
  Statement hold_gathering_;
  Statement delete_seats_;
  Statement put_seat_;
  Statement put_header_;
  Statement advance_;
  Statement append_entry_;
  Statement discard_;
};

}  // namespace breakshot::store
