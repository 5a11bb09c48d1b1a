#include "server/hub/follow.hpp"

#include <utility>

#include "server/hub/guests.hpp"
#include "server/hub/presence.hpp"

namespace breakshot::hub {
namespace {

match::Seq after(match::Seq seq, std::size_t entries) {
  return match::Seq{static_cast<std::uint32_t>(static_cast<std::uint32_t>(seq) + entries)};
}

/// About what an entry takes in a send queue, bytes; only its shot can be large.
std::size_t weight_of(const record::Entry& entry) {
  constexpr std::size_t segment_bytes = 64;
  constexpr std::size_t event_bytes = 24;
  constexpr std::size_t rest_bytes = 1024;
  if (!entry.outcome.shot) return rest_bytes;
  return rest_bytes + segment_bytes * entry.outcome.shot->segments.size() +
         event_bytes * entry.outcome.shot->events.size();
}

ReaderId add_reader(Moment& moment, Connection& connection, const Reader& reader) {
  const ReaderId id{++moment.state.last_reader};
  if (!reader.live) connection.behind.push_back(id);
  moment.state.readers.emplace(id, reader);
  return id;
}

match::Seq end_of(State& state, const Reader& reader) {
  return reader.end ? *reader.end : live_match(state, reader.match)->row.progress.next;
}

/// The next batch for a reader out of what is in memory; empty if it has to be loaded.
std::vector<ledger::EntryPointer> recent_batch(State& state, const Reader& reader) {
  const LiveMatch* match = live_match(state, reader.match);
  std::vector<ledger::EntryPointer> batch;
  if (!match || match->recent.empty() || match->recent.front()->seq > reader.next) return batch;
  const match::Seq end = end_of(state, reader);
  std::size_t bytes = 0;
  for (const ledger::EntryPointer& entry : match->recent) {
    if (entry->seq < reader.next) continue;
    if (entry->seq >= end || bytes >= state.limits.batch_bytes) break;
    bytes += weight_of(*entry);
    batch.push_back(entry);
  }
  return batch;
}

/// The reader has been told everything up to its end: it goes on live, or is done.
void come_to_end(Moment& moment, ReaderId id) {
  Reader& reader = moment.state.readers.at(id);
  if (!reader.end) {
    reader.live = true;
    return;
  }
  const Reader done = reader;
  moment.state.readers.erase(id);
  Connection* connection = open_connection(moment.state, done.connection);
  if (!connection) return;
  if (done.fetch) {
    connection->fetches.erase(id);
    finish(moment, *done.fetch, lobby::FetchDone{done.match, done.next});
  } else {
    connection->follows.erase(done.match);
  }
}

void tell_batch(Moment& moment, ReaderId id, const std::vector<ledger::EntryPointer>& batch) {
  Reader& reader = moment.state.readers.at(id);
  Connection& connection = *open_connection(moment.state, reader.connection);
  const lobby::RequestId request = reader.fetch ? reader.fetch->request : lobby::RequestId{};
  for (const ledger::EntryPointer& entry : batch) {
    tell(moment, {reader.connection}, request, lobby::EntryNews{reader.match, entry});
  }
  reader.next = after(reader.next, batch.size());
  connection.serving = true;
  moment.out.push_back(ReportDrained{reader.connection});
  if (reader.next == end_of(moment.state, reader)) {
    come_to_end(moment, id);
  } else {
    connection.behind.push_back(id);
  }
}

}  // namespace

bool may_follow(State& state, ConnectionId id, match::MatchId match) {
  const Connection* connection = open_connection(state, id);
  if (!connection) return false;
  return connection->follows.contains(match) ||
         connection->follows.size() + connection->joining < state.limits.follows_per_connection;
}

void follow(Moment& moment, ConnectionId id, LiveMatch& match, match::Seq from) {
  Connection* connection = open_connection(moment.state, id);
  if (!connection) return;
  const auto known = connection->follows.find(match.row.id);
  if (known != connection->follows.end()) moment.state.readers.erase(known->second);
  Reader reader;
  reader.connection = id;
  reader.match = match.row.id;
  reader.next = from;
  reader.live = from == match.row.progress.next;
  const ReaderId reader_id = add_reader(moment, *connection, reader);
  connection->follows[match.row.id] = reader_id;
  match.followers[id] = reader_id;
  update_standing(moment, id);
}

void follow_stored(Moment& moment, ConnectionId id, const ledger::MatchRow& row, match::Seq from) {
  Connection* connection = open_connection(moment.state, id);
  if (!connection) return;
  const auto known = connection->follows.find(row.id);
  if (known != connection->follows.end()) moment.state.readers.erase(known->second);
  Reader reader;
  reader.connection = id;
  reader.match = row.id;
  reader.next = from;
  reader.end = row.progress.next;
  connection->follows[row.id] = add_reader(moment, *connection, reader);
}

void read_out(Moment& moment, const Asker& asker, match::MatchId match, match::Seq from,
              match::Seq end) {
  Connection* connection = open_connection(moment.state, asker.connection);
  if (!connection) return;
  Reader reader;
  reader.connection = asker.connection;
  reader.match = match;
  reader.next = from;
  reader.end = end;
  reader.fetch = asker;
  connection->fetches.insert(add_reader(moment, *connection, reader));
}

void unfollow(Moment& moment, ConnectionId id, match::MatchId match) {
  Connection* connection = open_connection(moment.state, id);
  if (!connection) return;
  const auto known = connection->follows.find(match);
  if (known == connection->follows.end()) return;
  moment.state.readers.erase(known->second);
  connection->follows.erase(known);
  if (LiveMatch* live = live_match(moment.state, match)) live->followers.erase(id);
  update_standing(moment, id);
}

void stop_reading(Moment& moment, ConnectionId id) {
  const auto found = moment.state.connections.find(id);
  if (found == moment.state.connections.end()) return;
  Connection& connection = found->second;
  for (const ReaderId reader : connection.fetches) moment.state.readers.erase(reader);
  for (const auto& [match, reader] : connection.follows) {
    moment.state.readers.erase(reader);
    LiveMatch* live = live_match(moment.state, match);
    if (live && live->followers.erase(id) > 0) update_presence(moment, *live);
  }
  connection.fetches.clear();
  connection.follows.clear();
  connection.behind.clear();
}

void serve(Moment& moment, ConnectionId id) {
  Connection* connection = open_connection(moment.state, id);
  while (connection && !connection->serving && !connection->behind.empty()) {
    const ReaderId first = connection->behind.front();
    connection->behind.pop_front();
    const auto found = moment.state.readers.find(first);
    if (found == moment.state.readers.end()) continue;  // it has stopped meanwhile
    const Reader& reader = found->second;
    if (reader.next == end_of(moment.state, reader)) {
      come_to_end(moment, first);
      continue;
    }
    const auto batch = recent_batch(moment.state, reader);
    if (!batch.empty()) {
      tell_batch(moment, first, batch);
      continue;
    }
    connection->serving = true;
    const std::size_t bytes = moment.state.limits.batch_bytes;
    load(moment, ledger::FindEntries{reader.match, reader.next, bytes}, LoadingBatch{first, id});
  }
}

void drained(Moment& moment, ConnectionId id) {
  Connection* connection = open_connection(moment.state, id);
  if (!connection) return;
  connection->serving = false;
  serve(moment, id);
}

void batch_loaded(Moment& moment, const LoadingBatch& loading, const ledger::FoundEntries& found) {
  Connection* connection = open_connection(moment.state, loading.connection);
  if (!connection) return;
  if (found.entries.empty()) return batch_failed(moment, loading);
  connection->serving = false;
  const auto reader = moment.state.readers.find(loading.reader);
  if (reader != moment.state.readers.end()) {
    // Meanwhile the reader may have been told the first of them as an answer, and more may have
    // been stored than a fetch asked for.
    const match::Seq end = end_of(moment.state, reader->second);
    std::vector<ledger::EntryPointer> batch;
    for (const ledger::EntryPointer& entry : found.entries) {
      if (entry->seq == after(reader->second.next, batch.size()) && entry->seq < end) {
        batch.push_back(entry);
      }
    }
    if (batch.empty()) {
      connection->behind.push_front(loading.reader);
    } else {
      tell_batch(moment, loading.reader, batch);
    }
  }
  serve(moment, loading.connection);
}

void batch_failed(Moment& moment, const LoadingBatch& loading) {
  Connection* connection = open_connection(moment.state, loading.connection);
  if (!connection) return;
  connection->serving = false;
  const auto found = moment.state.readers.find(loading.reader);
  if (found == moment.state.readers.end()) return serve(moment, loading.connection);
  if (const auto fetched = found->second.fetch) {
    moment.state.readers.erase(found);
    connection->fetches.erase(loading.reader);
    refuse(moment, *fetched, lobby::RefusalCode::unavailable, "the record cannot be read now");
    return serve(moment, loading.connection);
  }
  // A follower cannot go on over a gap. When it comes back it asks for the same entries again.
  dismiss(moment, loading.connection, lobby::GoodbyeReason::stopping,
          "the match so far cannot be read now");
}

void answer_with_entry(Moment& moment, const Asker& asker, match::MatchId match,
                       const ledger::EntryPointer& entry) {
  const Connection* connection = open_connection(moment.state, asker.connection);
  if (!connection) return;
  const auto follow = connection->follows.find(match);
  if (follow != connection->follows.end()) {
    Reader& reader = moment.state.readers.at(follow->second);
    if (reader.next == entry->seq) reader.next = after(entry->seq, 1);
  }
  finish(moment, asker, lobby::EntryNews{match, entry});
}

void announce(Moment& moment, LiveMatch& match, const std::optional<Asker>& asker) {
  const ledger::EntryPointer& entry = match.recent.back();
  if (asker) answer_with_entry(moment, *asker, match.row.id, entry);
  std::vector<ConnectionId> to;
  for (const auto& [connection, reader_id] : match.followers) {
    Reader& reader = moment.state.readers.at(reader_id);
    if (!reader.live || reader.next != entry->seq) continue;
    reader.next = match.row.progress.next;
    to.push_back(connection);
  }
  tell(moment, std::move(to), {}, lobby::EntryNews{match.row.id, entry});
}

void end_following(Moment& moment, LiveMatch& match) {
  const auto followers = std::exchange(match.followers, {});
  for (const auto& [id, reader_id] : followers) {
    Reader& reader = moment.state.readers.at(reader_id);
    reader.end = match.row.progress.next;
    if (reader.live) come_to_end(moment, reader_id);
    update_standing(moment, id);
  }
}

}  // namespace breakshot::hub
