// Files of matches for the commands to read.
#pragma once

#include <fstream>
#include <string>

#include "tests/support/played_match.hpp"
#include "tests/support/scratch.hpp"

namespace breakshot::client {

/// A finished match of 8-ball between two players who do anything legal.
inline const record::Record& finished_match() {
  static const record::Record record = [] {
    support::PlayedMatch match(8, match::GameKind::eight_ball, 2);
    match.play(12);
    return match.record();
  }();
  return record;
}

/// A directory with files of matches.
class MatchFiles {
 public:
  std::string write(const std::string& name, const record::ByteVector& bytes) const {
    const std::string path = scratch_.path() / name;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
    return path;
  }
  std::string write(const std::string& name, const record::Record& record) const {
    return write(name, record::file_of(record));
  }
  std::string finished() const { return write("finished.breakshot", finished_match()); }
  /// The first half of a file.
  std::string cut() const {
    record::ByteVector bytes = record::file_of(finished_match());
    bytes.resize(bytes.size() / 2);
    return write("cut.breakshot", bytes);
  }
  std::string path(const std::string& name) const { return scratch_.path() / name; }

 private:
  support::Scratch scratch_;
};

}  // namespace breakshot::client
