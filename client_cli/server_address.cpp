#include "client_cli/server_address.hpp"

#include <algorithm>
#include <charconv>

#include "common/lobby/lobby.hpp"

namespace breakshot::client {
namespace {

std::optional<std::uint16_t> port_of(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc{} || end != text.data() + text.size() || port == 0) return std::nullopt;
  return port;
}

std::optional<ServerAddress> with_port(std::string_view host, std::string_view rest) {
  if (host.empty()) return std::nullopt;
  if (rest.empty()) return ServerAddress{std::string(host), lobby::default_port};
  if (rest.front() != ':') return std::nullopt;
  const auto port = port_of(rest.substr(1));
  if (!port) return std::nullopt;
  return ServerAddress{std::string(host), *port};
}

}  // namespace

std::optional<ServerAddress> server_address_of(std::string_view text) {
  if (!text.empty() && text.front() == '[') {
    const std::size_t close = text.find(']');
    if (close == std::string_view::npos) return std::nullopt;
    return with_port(text.substr(1, close - 1), text.substr(close + 1));
  }
  if (std::count(text.begin(), text.end(), ':') > 1) return with_port(text, "");
  const std::size_t colon = std::min(text.find(':'), text.size());
  return with_port(text.substr(0, colon), text.substr(colon));
}

std::string text_of(const ServerAddress& address) {
  const bool brackets = address.host.find(':') != std::string::npos;
  const std::string host = brackets ? "[" + address.host + "]" : address.host;
  return host + ":" + std::to_string(address.port);
}

}  // namespace breakshot::client
