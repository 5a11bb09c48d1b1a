// A server, two players and a spectator who play matches at random, from a seed, whatever happens
// to the server.
//
// The seed fixes what the guests do. What comes of it differs from run to run, since the server's
// secrets are its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/record/record.hpp"
#include "tests/simulation/guest.hpp"
#include "tests/support/random_asks.hpp"
#include "tests/support/scratch.hpp"
#include "tests/support/server_process.hpp"

namespace breakshot::simulation {

class Evening {
 public:
  explicit Evening(std::uint64_t seed, std::vector<std::string> server_options = {});

  /// Two take their seats and contribute, the third watches; until the first entry has come.
  void begin(const lobby::Create& create = {});
  /// One command of the player whose turn it is, until all three have its entry. `said` is called
  /// when it has been sent and not answered yet. The server may be lost at any moment: then
  /// everybody comes back and the same command is sent again. False if the store cannot keep it;
  /// then it cannot when it is sent again either.
  bool step(const std::function<void()>& said = {});
  /// Plays on; after `commands` of them somebody concedes.
  void finish(int commands);
  bool running() const;

  support::ServerProcess& server() { return *server_; }
  std::filesystem::path data() const { return scratch_.path() / "data"; }
  /// Starts the server again on the same data, and brings everybody back.
  void resume(const support::Disk& disk = {});

  /// The finished match, fetched by the spectator; checks that it verifies and holds everything
  /// that anybody was ever told.
  record::Record checked_record();

  Guest& ada() { return guests_[0]; }
  Guest& bob() { return guests_[1]; }
  Guest& eve() { return guests_[2]; }

 private:
  match::Command command_of(const Guest& player);
  lobby::Answer act(Guest& player, const lobby::Act& act, const std::function<void()>& said);

  const std::vector<std::string> server_options_;
  support::Scratch scratch_;
  std::unique_ptr<support::ServerProcess> server_;
  support::RandomAsks random_;
  std::vector<Guest> guests_;
  int commands_left_ = 1'000'000;
};

}  // namespace breakshot::simulation
