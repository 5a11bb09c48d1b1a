// `breakshot verify FILE...`: re-simulates stored matches and compares them bit for bit.
#include <algorithm>
#include <array>
#include <iostream>

#include "client_cli/commands/commands.hpp"
#include "client_cli/json.hpp"
#include "client_cli/online/match_name.hpp"
#include "client_cli/stored_match.hpp"

namespace breakshot::client {
namespace {

using Kind = record::Verdict::Kind;

/// What was found out about one match.
struct Finding {
  const char* verdict = "";  ///< a word for programs
  int status = exit_done;
  std::string text;  ///< for people
  std::size_t entries = 0;
  std::optional<match::Seq> entry;  ///< the first that diverges
  std::optional<std::size_t> offset;
  std::optional<std::string> what;
};

std::string entries_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

Finding finding_of(const record::Record& record, const record::Verdict& verdict) {
  const std::size_t entries = record.entries.size();
  switch (verdict.kind) {
    case Kind::verified:
      return {"verified", exit_done, "verified, " + entries_text(entries), entries, {}, {}, {}};
    case Kind::not_revealed_yet:
      return {"not_revealed_yet",
              exit_not_revealed,
              "not revealed yet: the match keeps its secret until it is finished; order and "
              "digests of its " +
                  entries_text(entries) + " are sound",
              entries,
              {},
              {},
              {}};
    case Kind::unknown_physics: {
      const std::string what = "it was played by version " + std::to_string(record.header.physics) +
                               " of the physics and this program has " +
                               record::simulated_versions();
      return {"unknown_physics", exit_usage, "cannot be verified: " + what, entries, {}, {}, what};
    }
    case Kind::diverged:
      break;
  }
  const record::Divergence& divergence = verdict.divergence.value();
  const auto seq = static_cast<std::uint32_t>(divergence.seq);
  return {"diverged",
          exit_failed,
          "diverged at entry " + std::to_string(seq) + ": " + divergence.what,
          entries,
          divergence.seq,
          {},
          divergence.what};
}

Finding finding_of(const StoredMatch& match) {
  const record::Verdict verdict = record::verify(match.record);
  // Of a damaged file the prefix is judged too: if that diverges, it is the older fault.
  if (!match.damage || verdict.kind == Kind::diverged) return finding_of(match.record, verdict);
  return {"damaged", exit_failed,          damage_text(match), match.record.entries.size(),
          {},        match.damage->offset, match.damage->what};
}

void print(const std::string& name, const Finding& finding, bool json) {
  if (!json) {
    std::cout << name << ": " << finding.text << '\n';
    return;
  }
  const auto entry = finding.entry ? Json(static_cast<std::uint32_t>(*finding.entry)) : Json();
  std::cout << object({{"file", name},
                       {"verdict", finding.verdict},
                       {"entries", finding.entries},
                       {"entry", entry},
                       {"offset", finding.offset},
                       {"what", finding.what}})
                   .text()
            << '\n';
}

/// The status of the whole: nothing hides that something could not be read, or was wrong.
int worse(int a, int b) {
  static constexpr std::array<int, 4> from_worst = {exit_usage, exit_failed, exit_not_revealed,
                                                    exit_done};
  return *std::find_if(from_worst.begin(), from_worst.end(),
                       [a, b](int status) { return status == a || status == b; });
}

int verify_one(const std::string& name, const std::string& guest, const Globals& globals) {
  try {
    const Finding finding = finding_of(open_match(name, globals, guest));
    print(name, finding, globals.json);
    return finding.status;
  } catch (const CommandError& error) {
    if (globals.json) {
      print(name, {"unreadable", error.status(), {}, 0, {}, {}, std::string(error.what())}, true);
    }
    std::cout.flush();
    std::cerr << "breakshot: " << error.what() << '\n';
    return exit_usage;
  }
}

}  // namespace

Command add_verify(CLI::App& program, const Globals& globals) {
  const auto names = std::make_shared<std::vector<std::string>>();
  const auto guest = std::make_shared<std::string>();
  CLI::App* parser = program.add_subcommand(
      "verify", "Simulate stored matches again and compare every bit with what is stored");
  parser
      ->add_option("MATCH", *names,
                   "A .breakshot file, - for standard input, or the id of a "
                   "match on the server")
      ->required();
  add_guest_name(*parser, *guest);
  parser->footer(
      "Exit status: 0 all verified; 1 something diverged or is damaged; 2 something cannot be\n"
      "read, or was played by physics that this program does not have; 3 a match that is not\n"
      "finished keeps its secret, so that only order and digests could be checked.");
  return {parser, [names, guest, &globals] {
            int status = exit_done;
            for (const std::string& name : *names) {
              status = worse(status, verify_one(name, *guest, globals));
            }
            return status;
          }};
}

}  // namespace breakshot::client
