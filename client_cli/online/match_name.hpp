// How people name a match on a server, and what is asked of the command line for it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "client_cli/online/connection.hpp"
#include "client_cli/server_address.hpp"
#include "common/lobby/lobby.hpp"

namespace CLI {
class App;
}

namespace breakshot::client {

struct Globals;

/// One of the two.
struct MatchName {
  std::optional<match::MatchId> id;
  std::optional<lobby::InviteCode> code;
};

/// 16 hexadecimal digits, or an invite code. Nothing if the text is neither.
std::optional<MatchName> match_name_of(std::string_view text);

/// `MATCH` and `--code CODE` of a command, as they were typed.
struct MatchOptions {
  std::string match;
  std::string code;

  void add_to(CLI::App& parser);
  /// Nothing if neither was given; CommandError, with exit_usage, for what names no match.
  std::optional<MatchName> name() const;
  /// The same, where one must be given.
  MatchName required_name() const;
};

/// The server of the command line. CommandError, with exit_usage, for what is no address.
ServerAddress server_of(const Globals& globals);

/// The guest of that name with the token that this machine keeps. CommandError, with exit_usage,
/// for what cannot be a name.
Guest guest_of(const std::string& name);
/// Somebody who only looks, and whom nobody remembers: looking must not take over the connection
/// with which the same person is playing.
Guest stranger();

/// The guest of that name, or a stranger where none was given.
Guest guest_or_stranger(const std::string& name);

/// The option by which a player asks for a private match without its code: `--name NAME`.
void add_guest_name(CLI::App& parser, std::string& name);
/// What the system calls the user, as far as it can be a name; else "guest".
std::string user_name();

/// Tells people on standard error how the connection fares.
Connection::Notice notice_on_standard_error();

/// Ends the command with what the server said.
[[noreturn]] void refuse(const lobby::Refused& refused);

}  // namespace breakshot::client
