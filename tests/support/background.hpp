// A program that runs beside the test.
#pragma once

#include <sys/prctl.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/scratch.hpp"
#include "tests/support/subprocess.hpp"

namespace breakshot::support {

class Background {
 public:
  /// Starts `words[0]` with `input` on its standard input, which must fit into a pipe.
  explicit Background(const std::vector<std::string>& words,
                      const std::map<std::string, std::string>& environment = {},
                      const std::string& input = {}) {
    detail::Pipe in;
    if (::write(in.write_end, input.data(), input.size()) != static_cast<ssize_t>(input.size())) {
      throw std::runtime_error("the input does not fit into a pipe");
    }
    child_ = ::fork();
    if (child_ < 0) throw std::runtime_error("fork failed");
    if (child_ == 0) {
      // A test that dies takes its programs with it.
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::dup2(in.read_end, 0);
      ::dup2(::open(out().c_str(), O_WRONLY | O_CREAT, 0600), 1);
      ::dup2(::open(err().c_str(), O_WRONLY | O_CREAT, 0600), 2);
      detail::become(words, environment);
    }
  }
  ~Background() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    wait();
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// What it has printed so far.
  std::string printed() const { return contents_of(out()); }

  /// Waits for its end.
  Finished wait() {
    int status = 0;
    ::waitpid(std::exchange(child_, -1), &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), printed(),
            contents_of(err())};
  }

 private:
  std::string out() const { return (scratch_.path() / "out").string(); }
  std::string err() const { return (scratch_.path() / "err").string(); }
  static std::string contents_of(const std::string& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  Scratch scratch_;
  pid_t child_ = -1;
};

}  // namespace breakshot::support
