#include "client_cli/online/match_name.hpp"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <iostream>

#include "client_cli/command.hpp"
#include "common/lobby/code.hpp"
#include "common/lobby/name.hpp"

namespace breakshot::client {
namespace {

constexpr std::size_t id_digits = 16;

std::optional<match::MatchId> id_of(std::string_view text) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, 16);
  if (text.size() != id_digits || error != std::errc{} || stop != end) return std::nullopt;
  return match::MatchId{number};
}

}  // namespace

std::optional<MatchName> match_name_of(std::string_view text) {
  if (const auto id = id_of(text)) return MatchName{id, std::nullopt};
  if (const auto code = lobby::code_of(text)) return MatchName{std::nullopt, code};
  return std::nullopt;
}

void MatchOptions::add_to(CLI::App& parser) {
  auto* id =
      parser.add_option("MATCH", match, "The match: 16 hexadecimal digits, or its invite code");
  parser.add_option("--code", code, "The invite code of a private match")
      ->type_name("CODE")
      ->excludes(id);
}

std::optional<MatchName> MatchOptions::name() const {
  if (!code.empty()) {
    const auto invite = lobby::code_of(code);
    if (!invite) {
      throw CommandError(
          "--code: " + code + ": must be the 10 letters and digits of an invite code", exit_usage);
    }
    return MatchName{std::nullopt, invite};
  }
  if (match.empty()) return std::nullopt;
  const auto name = match_name_of(match);
  if (!name) {
    throw CommandError(match +
                           ": names no match; that takes 16 hexadecimal digits, as 'breakshot "
                           "list' shows them, or an invite code",
                       exit_usage);
  }
  return name;
}

MatchName MatchOptions::required_name() const {
  const auto which = name();
  if (!which) throw CommandError("say which match: MATCH or --code CODE", exit_usage);
  return *which;
}

ServerAddress server_of(const Globals& globals) {
  const auto address = server_address_of(globals.server);
  if (!address) {
    throw CommandError("--server: " + globals.server + ": must be HOST, HOST:PORT or [HOST]:PORT",
                       exit_usage);
  }
  return *address;
}

Guest guest_of(const std::string& name) {
  if (const auto fault = lobby::name_fault(name)) {
    throw CommandError("--name: " + name + ": " + *fault, exit_usage);
  }
  return {name, TokenStore(state_directory())};
}

Guest stranger() {
  return {"spectator", std::nullopt};
}

Guest guest_or_stranger(const std::string& name) {
  return name.empty() ? stranger() : guest_of(name);
}

void add_guest_name(CLI::App& parser, std::string& name) {
  parser.add_option("--name", name, "Ask as this guest, who sits at a private match")
      ->type_name("NAME");
}

std::string user_name() {
  const passwd* user = ::getpwuid(::geteuid());
  if (user == nullptr || lobby::name_fault(user->pw_name)) return "guest";
  return user->pw_name;
}

Connection::Notice notice_on_standard_error() {
  return [](const std::string& what) {
    std::cout.flush();
    std::cerr << "breakshot: " << what << '\n';
  };
}

void refuse(const lobby::Refused& refused) {
  throw CommandError("the server says no: " + refused.what);
}

}  // namespace breakshot::client
