// What the record says of itself: header and entry. This is the format (docs/record.md).
#pragma once

#include "common/record/describe_match.hpp"
#include "common/record/record.hpp"

namespace breakshot::record {

template <class Codec>
void describe(Codec& c, Value<Codec, Player>& player) {
  field(c, "name", player.name, max_text_bytes);
  field(c, "contribution", player.contribution);
}

template <class Codec>
void describe(Codec& c, Value<Codec, Header>& header) {
  fixed(c, "format", format_version);
  field(c, "physics", header.physics);
  field(c, "id", header.id);
  field(c, "created_unix_ms", header.created_unix_ms);
  field(c, "settings", header.settings);
  field(c, "players", header.players, max_seats);
  field(c, "commitment", header.commitment);
  c.rule([&] { return shape_fault(header); });
}

/// An entry without its digest.
template <class Codec>
void describe(Codec& c, Value<Codec, Entry>& entry) {
  field(c, "seq", entry.seq);
  field(c, "author", entry.author);
  field(c, "id", entry.id);
  field(c, "command", entry.command);
  field(c, "outcome", entry.outcome);
  field(c, "secret", entry.secret);
}

}  // namespace breakshot::record
