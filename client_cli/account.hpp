// A match told in lines of text: what `replay` prints where there is no terminal, and what anybody
// prints who follows a match.
#pragma once

#include <string>
#include <vector>

#include "client_cli/json.hpp"
#include "client_cli/words.hpp"
#include "common/record/record.hpp"

namespace breakshot::client {

/// Tells a match entry by entry.
class Account {
 public:
  explicit Account(Names names) : names_(std::move(names)) {}

  /// The lines that `entry` adds: what was done, what it meant and what is next; a line for a new
  /// rack or the end of the match. With `events`, every event of a shot as well.
  std::vector<std::string> lines_of(const record::Entry& entry, bool events = false);

  /// The same as one JSON object.
  Json json_of(const record::Entry& entry);

 private:
  Names names_;
  match::Status before_;
  std::uint32_t shots_ = 0;

  std::string label_of(const record::Entry& entry) const;
};

/// Two lines that say which match it is.
std::vector<std::string> heading_of(const record::Record& record);

/// Every line of the account.
std::vector<std::string> account_of(const record::Record& record, bool events = false);

}  // namespace breakshot::client
