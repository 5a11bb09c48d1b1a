// The server's program: reads its configuration, serves until it is told to stop.
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <system_error>
#include <variant>

#include "server/config.hpp"
#include "server/shell/shell.hpp"

namespace breakshot::server {
namespace {

void set_up_log(const Config& config) {
  spdlog::set_default_logger(spdlog::stderr_logger_mt("breakshot"));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %l: %v");
  spdlog::set_level(spdlog::level::from_str(config.log_level));
}

/// Each connection is a descriptor; many systems begin with 1024 of them.
void raise_descriptor_limit(std::size_t connections) {
  constexpr rlim_t others = 64;  // the store's files, standard streams, event queues
  const rlim_t wanted = connections + others;
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= wanted) return;
  limit.rlim_cur = std::min<rlim_t>(wanted, limit.rlim_max);
  if (::setrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur < wanted) {
    spdlog::warn("the system allows {} open files, too few for {} connections", limit.rlim_cur,
                 connections);
  }
}

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (!error && !std::filesystem::is_directory(directory, error)) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (error) {
    throw std::runtime_error("--data " + directory.string() + ": " + error.message());
  }
}

void serve(const Config& config) {
  set_up_log(config);
  std::signal(SIGPIPE, SIG_IGN);  // nobody may be reading the line below
  ::umask(077);                   // the database holds the secrets of matches
  raise_descriptor_limit(config.shell.net.connections);
  make_directory(config.data);
  shell::Shell shell(config.shell);
  spdlog::info("{} listens at {} port {}, matches are kept in {}", config.shell.version,
               config.shell.address, shell.port(), config.data.string());
  std::cout << join_command(config.shell.address, shell.port()) << std::endl;
  shell.run();
  spdlog::info("stopped");
}

}  // namespace
}  // namespace breakshot::server

int main(int argc, char** argv) {
  using namespace breakshot::server;
  const auto config = config_of(argc, argv);
  if (const auto* exit = std::get_if<Exit>(&config)) {
    std::cout << exit->out;
    std::cerr << exit->err;
    return exit->status;
  }
  try {
    serve(std::get<Config>(config));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "breakshot-server: " << error.what() << '\n';
    return 1;
  }
}
