// The smallest values that the record accepts, to spoil one field of.
#pragma once

#include "common/record/record.hpp"

namespace breakshot::record {

inline Header small_header() {
  Header header;
  header.settings.preset = "paper";
  header.settings.seats = 1;
  header.players = {{"Ada", {}}};
  return header;
}

inline Entry small_entry() {
  Entry entry;
  entry.outcome.status.score = {0};
  entry.outcome.status.game.groups = {rules::Group::none};
  entry.outcome.status.rerack_agreed = {false};
  return entry;
}

}  // namespace breakshot::record
