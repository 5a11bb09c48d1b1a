#include "client_cli/online/identity.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

#include "client_cli/command_error.hpp"
#include "common/hash/hash.hpp"

namespace breakshot::client {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const char* doing) {
  throw CommandError(file.string() + ": cannot " + doing + ": " + std::strerror(errno));
}

/// A descriptor that is closed in any case.
class File {
 public:
  File(const fs::path& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0600)) {}
  ~File() {
    if (fd_ >= 0) ::close(fd_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  int fd() const { return fd_; }

 private:
  int fd_;
};

std::string file_name_of(std::string_view text) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string name;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       c == '-' || c == '_' || (c == '.' && !name.empty()) || byte >= 0x80;
    if (plain) {
      name += c;
    } else {
      name += '%';
      name += digits[byte / 16];
      name += digits[byte % 16];
    }
  }
  return name;
}

/// Makes the directory and those above it that are missing, for nobody else to enter.
void make_private_directories(const fs::path& directory) {
  fs::path path;
  for (const auto& part : directory) {
    path /= part;
    if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST && !fs::is_directory(path)) {
      fail(path, "make this directory");
    }
  }
}

void write_all(int fd, std::string_view text, const fs::path& file) {
  while (!text.empty()) {
    const ssize_t written = ::write(fd, text.data(), text.size());
    if (written < 0 && errno != EINTR) fail(file, "write");
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Replaces the file in one step.
void write_token(const fs::path& path, const lobby::Token& token) {
  make_private_directories(path.parent_path());
  // Another process may be saving at the same moment: each writes a file of its own.
  const fs::path fresh = path.string() + ".new." + std::to_string(::getpid());
  {
    const File file(fresh, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (file.fd() < 0) fail(fresh, "write");
    if (::fchmod(file.fd(), 0600) != 0) fail(fresh, "make private");
    write_all(file.fd(), hash::hex_of(token) + '\n', fresh);
    if (::fsync(file.fd()) != 0) fail(fresh, "write");
  }
  if (::rename(fresh.c_str(), path.c_str()) != 0) fail(path, "write");
}

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

fs::path state_directory() {
  const fs::path state = environment("XDG_STATE_HOME");
  if (state.is_absolute()) return state / "breakshot";
  const fs::path home = environment("HOME");
  if (!home.is_absolute()) {
    throw CommandError("there is no place to keep your identity: set HOME or XDG_STATE_HOME");
  }
  return home / ".local" / "state" / "breakshot";
}

fs::path TokenStore::file_of(const ServerAddress& server, const std::string& name) const {
  return directory_ / "tokens" / file_name_of(text_of(server)) / file_name_of(name);
}

std::optional<lobby::Token> TokenStore::load(const ServerAddress& server,
                                             const std::string& name) const {
  const fs::path path = file_of(server, name);
  const File file(path, O_RDONLY);
  if (file.fd() < 0) {
    if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
    fail(path, "read");
  }
  std::array<char, 80> buffer{};
  const ssize_t got = ::read(file.fd(), buffer.data(), buffer.size());
  if (got < 0) fail(path, "read");
  std::string_view text(buffer.data(), static_cast<std::size_t>(got));
  if (text.ends_with('\n')) text.remove_suffix(1);
  const auto token = hash::bytes_of_hex<std::tuple_size_v<lobby::Token>>(text);
  if (!token) {
    throw CommandError(path.string() +
                       ": this is not a token, which is 64 hexadecimal digits. "
                       "Restore the file, or remove it to become a new guest");
  }
  return token;
}

void TokenStore::save(const ServerAddress& server, const std::string& name,
                      const lobby::Token& token) const {
  write_token(file_of(server, name), token);
}

fs::path TokenStore::set_aside(const ServerAddress& server, const std::string& name,
                               const lobby::Token& token) const {
  const fs::path path = file_of(server, name).string() + '~';
  write_token(path, token);
  return path;
}

std::array<std::uint8_t, 32> entropy() {
  std::array<std::uint8_t, 32> bytes{};
  // Requests of up to 256 bytes are answered whole.
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw CommandError(std::string("the system gives no random bytes: ") + std::strerror(errno));
  }
  return bytes;
}

}  // namespace breakshot::client
