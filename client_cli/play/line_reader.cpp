#include "client_cli/play/line_reader.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace breakshot::client {

std::optional<std::string> LineReader::next() {
  const std::size_t end = text_.find('\n');
  const bool whole = end != std::string::npos;
  if (!whole && text_.size() < max_line_bytes && !(ended_ && !text_.empty())) return std::nullopt;
  const std::size_t length = std::min({end, text_.size(), max_line_bytes});
  std::string line = text_.substr(0, length);
  text_.erase(0, length + (length == end ? 1 : 0));
  return line;
}

void LineReader::fill() {
  pollfd readable{fd_, POLLIN, 0};
  if (ended_ || ::poll(&readable, 1, 0) <= 0) return;
  std::array<char, 4096> buffer{};
  const ssize_t got = ::read(fd_, buffer.data(), buffer.size());
  if (got > 0) text_.append(buffer.data(), static_cast<std::size_t>(got));
  ended_ = got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN);
}

}  // namespace breakshot::client
