#include "client_cli/online/identity.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "client_cli/command_error.hpp"
#include "tests/support/scratch.hpp"

namespace breakshot::client {
namespace {

namespace fs = std::filesystem;

const ServerAddress server{"127.0.0.1", 7665};

lobby::Token token_of(std::uint8_t first) {
  lobby::Token token{};
  token[0] = first;
  token[31] = 0xab;
  return token;
}

unsigned mode_of(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 0777u;
}

std::string contents_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Identity, ComesBackByServerAndName) {
  const support::Scratch scratch;
  const TokenStore store(scratch.path());
  EXPECT_EQ(store.load(server, "Ann"), std::nullopt);
  store.save(server, "Ann", token_of(1));
  store.save(server, "Bob", token_of(2));
  store.save({"pool.example", 7665}, "Ann", token_of(3));
  EXPECT_EQ(store.load(server, "Ann"), token_of(1));
  EXPECT_EQ(store.load(server, "Bob"), token_of(2));
  EXPECT_EQ(store.load({"pool.example", 7665}, "Ann"), token_of(3));
  EXPECT_EQ(store.load({"127.0.0.1", 7666}, "Ann"), std::nullopt);
}

TEST(Identity, IsReadableByItsOwnerAlone) {
  const support::Scratch scratch;
  const fs::path state = scratch.path() / "a" / "b";
  const TokenStore store(state);
  const mode_t before = ::umask(0);
  store.save(server, "Ann", token_of(1));
  ::umask(before);
  const fs::path file = store.file_of(server, "Ann");
  EXPECT_EQ(mode_of(file), 0600u);
  EXPECT_EQ(mode_of(file.parent_path()), 0700u);
  EXPECT_EQ(mode_of(state), 0700u);
}

TEST(Identity, ReplacesATokenAndLeavesNothingBeside) {
  const support::Scratch scratch;
  const TokenStore store(scratch.path());
  store.save(server, "Ann", token_of(1));
  const fs::path file = store.file_of(server, "Ann");
  fs::permissions(file, fs::perms::all);
  store.save(server, "Ann", token_of(2));
  EXPECT_EQ(store.load(server, "Ann"), token_of(2));
  EXPECT_EQ(mode_of(file), 0600u);
  const fs::directory_iterator files(file.parent_path());
  EXPECT_EQ(std::distance(fs::begin(files), fs::end(files)), 1);
}

TEST(Identity, KeepsTheOldTokenWhereTheNewOneCannotBeWritten) {
  const support::Scratch scratch;
  const TokenStore store(scratch.path());
  store.save(server, "Ann", token_of(1));
  const fs::path file = store.file_of(server, "Ann");
  // A directory stands where the new file would be written.
  fs::create_directory(file.string() + ".new." + std::to_string(::getpid()));
  EXPECT_THROW(store.save(server, "Ann", token_of(2)), CommandError);
  EXPECT_EQ(store.load(server, "Ann"), token_of(1));
}

TEST(Identity, SetsATokenAsideWhereNoGuestLooks) {
  const support::Scratch scratch;
  const TokenStore store(scratch.path());
  store.save(server, "Ann", token_of(1));
  const fs::path aside = store.set_aside(server, "Ann", token_of(1));
  store.save(server, "Ann", token_of(2));
  EXPECT_EQ(store.load(server, "Ann"), token_of(2));
  EXPECT_EQ(store.load(server, "Ann~"), std::nullopt);
  EXPECT_EQ(mode_of(aside), 0600u);
  // Its owner takes it back by giving it the guest's name again.
  fs::rename(aside, store.file_of(server, "Ann"));
  EXPECT_EQ(store.load(server, "Ann"), token_of(1));
}

TEST(Identity, ADamagedFileIsNamedAndLeftAlone) {
  const support::Scratch scratch;
  const TokenStore store(scratch.path());
  store.save(server, "Ann", token_of(1));
  const fs::path file = store.file_of(server, "Ann");
  const std::string good = contents_of(file);
  ASSERT_EQ(good.size(), 65u);
  for (const std::string& bad :
       {std::string(), good.substr(0, 63), "x" + good.substr(1), good + "0", good + good}) {
    std::ofstream(file) << bad;
    try {
      store.load(server, "Ann");
      ADD_FAILURE() << "took " << bad;
    } catch (const CommandError& error) {
      EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos) << error.what();
    }
    EXPECT_EQ(contents_of(file), bad);
  }
}

TEST(Identity, NamesNeverLeaveTheDirectory) {
  const support::Scratch scratch;
  const TokenStore store(scratch.path());
  for (const char* name : {"..", ".", "../../up", "a/b", "Jos\xc3\xa9 \xe2\x98\x85", "%41", "A"}) {
    store.save(server, name, token_of(7));
    EXPECT_EQ(store.load(server, name), token_of(7)) << name;
    EXPECT_EQ(store.file_of(server, name).parent_path(), store.file_of(server, "x").parent_path());
  }
  std::string longest;
  for (int i = 0; i < 32; ++i) longest += "\xf0\x9f\x8e\xb1";
  store.save(server, longest, token_of(8));
  EXPECT_EQ(store.load(server, longest), token_of(8));
  EXPECT_NE(store.file_of(server, "%41"), store.file_of(server, "A"));
}

TEST(StateDirectory, FollowsTheXdgSpecification) {
  const support::Environment environment({{"HOME", "/home/ann"}, {"XDG_STATE_HOME", "/state"}});
  EXPECT_EQ(state_directory(), "/state/breakshot");
  ::setenv("XDG_STATE_HOME", "not/absolute", 1);
  EXPECT_EQ(state_directory(), "/home/ann/.local/state/breakshot");
  ::setenv("XDG_STATE_HOME", "", 1);
  EXPECT_EQ(state_directory(), "/home/ann/.local/state/breakshot");
  ::unsetenv("HOME");
  EXPECT_THROW(state_directory(), CommandError);
}

TEST(Entropy, IsNeverTheSame) {
  EXPECT_NE(entropy(), entropy());
}

}  // namespace
}  // namespace breakshot::client
