// The real server as a process of its own, to be stopped and killed.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/subprocess.hpp"

namespace breakshot::support {

/// No file can grow beyond this many bytes, as if the disk were full; 0: no such limit.
struct Disk {
  std::uint64_t file_bytes = 0;
};

class ServerProcess {
 public:
  /// Starts `program` with its data in `data`, and waits until it listens. What it logs is appended
  /// to `data`/log. Without a --port among the options it is any that is free.
  ServerProcess(const std::string& program, const std::filesystem::path& data,
                const std::vector<std::string>& options = {}, const Disk& disk = {}) {
    std::vector<std::string> words = {program, "--data", data.string()};
    if (std::find(options.begin(), options.end(), "--port") == options.end()) {
      words.insert(words.end(), {"--port", "0"});
    }
    words.insert(words.end(), options.begin(), options.end());
    std::filesystem::create_directories(data);
    const std::string log = (data / "log").string();
    detail::Pipe out;
    const pid_t parent = ::getpid();
    child_ = ::fork();
    if (child_ < 0) throw std::runtime_error("fork failed");
    if (child_ == 0) {
      // A test that dies takes its server with it.
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (::getppid() != parent) ::_exit(127);
      limit(disk);
      ::dup2(out.write_end, 1);
      ::dup2(::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600), 2);
      detail::become(words, {});
    }
    out.close_write();
    port_ = port_in(first_line(out.read_end));
  }
  ~ServerProcess() { kill(); }
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  std::uint16_t port() const { return port_; }

  bool running() const { return child_ > 0; }

  /// Ends it without a word, and nothing flushed.
  void kill() {
    if (!running()) return;
    signal(SIGKILL);
    wait();
  }
  void signal(int number) { ::kill(child_, number); }
  /// Waits until it has ended; its exit status, or 128 and the signal.
  int wait() {
    int status = 0;
    ::waitpid(std::exchange(child_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  static void limit(const Disk& disk) {
    if (disk.file_bytes == 0) return;
    ::signal(SIGXFSZ, SIG_IGN);  // writing fails instead
    const rlimit limit{disk.file_bytes, disk.file_bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }

  static std::string first_line(int fd) {
    constexpr int patience_ms = 20'000;
    std::string text;
    while (text.find('\n') == std::string::npos) {
      pollfd readable{fd, POLLIN, 0};
      if (::poll(&readable, 1, patience_ms) <= 0 || !detail::drain(fd, text)) {
        throw std::runtime_error("the server said only '" + text + "', see its log");
      }
    }
    return text.substr(0, text.find('\n'));
  }
  static std::uint16_t port_in(const std::string& line) {
    return static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
  }

  pid_t child_ = -1;
  std::uint16_t port_ = 0;
};

}  // namespace breakshot::support
