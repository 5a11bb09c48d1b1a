#include "server/config.hpp"

#include <arpa/inet.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <sstream>

#include "common/lobby/lobby.hpp"

namespace breakshot::server {
namespace {

std::string address_fault(const std::string& text) {
  std::array<std::uint8_t, 16> bytes{};
  const bool good = ::inet_pton(AF_INET, text.c_str(), bytes.data()) == 1 ||
                    ::inet_pton(AF_INET6, text.c_str(), bytes.data()) == 1;
  return good ? "" : "'" + text + "' is no IPv4 or IPv6 address";
}

void add_options(CLI::App& app, Config& config, std::int64_t& claim_after_s) {
  shell::Settings& shell = config.shell;
  app.set_version_flag("--version", shell.version);
  app.set_config("--config", "", "Read options from this file, a line each: port = 7665")
      ->type_name("FILE");
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.add_option("--bind", shell.address, "Listen at this address; 0.0.0.0 or :: for everyone")
      ->type_name("ADDRESS")
      ->check(address_fault)
      ->capture_default_str();
  app.add_option("--port", shell.port, "Listen at this port; 0 for any free one")
      ->type_name("PORT")
      ->check(CLI::Range(0, 65535).description(""))
      ->capture_default_str();
  app.add_option("--data", config.data, "Keep matches in this directory, made if missing")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--log-level", config.log_level, "Log this and what is graver on standard error")
      ->type_name("LEVEL")
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  app.add_option("--connections", shell.net.connections, "Connections at once")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000).description(""))
      ->capture_default_str();
  app.add_option("--connections-per-address", shell.net.connections_per_address,
                 "Connections at once from one address")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000).description(""))
      ->capture_default_str();
  app.add_option("--claim-after", claim_after_s,
                 "A match can be claimed when the opponent has been away for so many seconds")
      ->type_name("SECONDS")
      ->check(CLI::Range(1, 30 * 24 * 3600).description(""))
      ->capture_default_str();
}

}  // namespace

std::variant<Config, Exit> config_of(int argc, const char* const* argv) {
  Config config;
  config.shell.port = lobby::default_port;
  config.shell.version = "breakshot-server " BREAKSHOT_VERSION;
  config.data = "var/server";
  config.log_level = "info";
  auto claim_after = std::chrono::duration_cast<std::chrono::seconds>(config.shell.hub.claim_after);
  std::int64_t claim_after_s = claim_after.count();

  CLI::App app("Hosts online pool matches.", "breakshot-server");
  add_options(app, config, claim_after_s);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(error, out, err) == 0) return Exit{0, out.str(), ""};
    return Exit{
        2, "",
        std::string("breakshot-server: ") + error.what() + "\nTry 'breakshot-server --help'.\n"};
  }
  if (config.data.empty()) {
    return Exit{2, "", "breakshot-server: --data: must name a directory\n"};
  }
  config.shell.hub.claim_after = std::chrono::seconds(claim_after_s);
  config.shell.hub.connections = config.shell.net.connections;
  config.shell.database = config.data / "breakshot.sqlite";
  return config;
}

std::string join_command(const std::string& address, std::uint16_t port) {
  std::string host = address;
  if (address == "0.0.0.0" || address == "::") {
    // Everyone else knows this machine by its name.
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) == 0 && name[0] != '\0') host = name.data();
  }
  if (host.find(':') != std::string::npos) host = "[" + host + "]";
  return "breakshot play --server " + host + ":" + std::to_string(port);
}

}  // namespace breakshot::server
