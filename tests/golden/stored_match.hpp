// The matches that were really played and are kept here for ever, one or more of each format and
// each version of the physics: match_*.breakshot.
#pragma once

#include <string>
#include <vector>

#include "common/record/record.hpp"

namespace breakshot::golden {

/// The file's name without its folder.
std::string name_of(const std::string& path);

record::Reading read_match(const std::string& path);

/// The digest of the last entry of a match that is simulated again with the same bits, in
/// hexadecimal; or what is wrong with it.
std::string digest_of_match(const std::string& path);

}  // namespace breakshot::golden
