// breakshot export: a match from a server into a file.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

#include "client_cli/commands/commands.hpp"
#include "client_cli/json.hpp"
#include "client_cli/online/connection.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/words.hpp"
#include "common/record/record.hpp"

namespace breakshot::client {
namespace {

struct Options {
  MatchOptions match;
  std::string name;
  std::string file;
};

record::Record fetched(const Options& options, const Globals& globals) {
  const MatchName which = options.match.required_name();
  Connection connection(server_of(globals), guest_or_stranger(options.name),
                        notice_on_standard_error());
  auto answer = connection.fetch({which.id, which.code, {}});
  if (const auto* refused = std::get_if<lobby::Refused>(&answer)) refuse(*refused);
  return std::get<record::Record>(std::move(answer));
}

/// Where to write so that a file is whole or not there: beside it first. What is no plain file, a
/// pipe or a device, is written to as it is.
std::string first_name_of(const std::string& name) {
  std::error_code none;
  const bool plain = !std::filesystem::exists(name, none) ||
                     std::filesystem::is_regular_file(std::filesystem::symlink_status(name, none));
  return plain ? name + ".part" : name;
}

void write_file(const std::string& name, const record::ByteVector& bytes) {
  const std::string fresh = first_name_of(name);
  std::ofstream out(fresh, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out || (fresh != name && std::rename(fresh.c_str(), name.c_str()) != 0)) {
    const std::string cause = std::strerror(errno);
    if (fresh != name) std::remove(fresh.c_str());
    throw CommandError(name + ": cannot be written: " + cause);
  }
}

int export_match(const Options& options, const Globals& globals) {
  const record::Record record = fetched(options, globals);
  const record::ByteVector bytes = record::file_of(record);
  // What the network carried must be what the server stored: the chain of digests shows it.
  const record::Reading reading = record::read_file(bytes);
  if (reading.damage) {
    throw CommandError("the record that the server sent is damaged at byte " +
                       std::to_string(reading.damage->offset) + ": " + reading.damage->what);
  }
  if (options.file == "-") {
    std::cout.write(reinterpret_cast<const char*>(bytes.data()),
                    static_cast<std::streamsize>(bytes.size()));
    return exit_done;
  }
  const std::string id = words_of(record.header.id);
  const std::string file = options.file.empty() ? id + ".breakshot" : options.file;
  write_file(file, bytes);
  const bool finished = !record.entries.empty() &&
                        record.entries.back().outcome.status.stage == match::Stage::finished;
  if (globals.json) {
    std::cout << object({{"match", id},
                         {"file", file},
                         {"bytes", bytes.size()},
                         {"entries", record.entries.size()},
                         {"finished", finished}})
                     .text()
              << '\n';
  } else {
    std::cout << file << ": " << match_text(record.header) << ", " << record.entries.size()
              << " entries" << (finished ? "" : ", not finished yet") << '\n';
  }
  return exit_done;
}

}  // namespace

Command add_export(CLI::App& program, const Globals& globals) {
  const auto options = std::make_shared<Options>();
  CLI::App* parser = program.add_subcommand("export", "Save a match of a server in a file");
  options->match.add_to(*parser);
  parser
      ->add_option("-o,--output", options->file,
                   "The file, - for standard output (default: the match's id with .breakshot)")
      ->type_name("FILE");
  add_guest_name(*parser, options->name);
  return {parser, [options, &globals] { return export_match(*options, globals); }};
}

}  // namespace breakshot::client
