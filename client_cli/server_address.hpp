// Where a server listens, as people write it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace breakshot::client {

struct ServerAddress {
  std::string host;
  std::uint16_t port = 0;

  friend bool operator==(const ServerAddress&, const ServerAddress&) = default;
};

/// Reads HOST, HOST:PORT, [HOST] or [HOST]:PORT; an IPv6 address needs its brackets to have a port.
/// Nothing if the text is none of these or the port is not in [1, 65535].
std::optional<ServerAddress> server_address_of(std::string_view text);

/// HOST:PORT, with brackets round an IPv6 address.
std::string text_of(const ServerAddress& address);

}  // namespace breakshot::client
