// A whole stored match from a server.
#pragma once

#include <string>
#include <variant>

#include "client_cli/online/connection.hpp"
#include "client_cli/server_address.hpp"
#include "common/record/record.hpp"

namespace breakshot::client {

/// Why something could not be had from a server, as a sentence for people.
struct Failure {
  std::string what;
};

/// Fetches the record of a match by its id (16 hexadecimal digits) or its invite code, as a guest:
/// one who sits at a private match needs no code.
std::variant<record::Record, Failure> fetch_record(const ServerAddress& server, const Guest& guest,
                                                   const std::string& id_or_code);

}  // namespace breakshot::client
