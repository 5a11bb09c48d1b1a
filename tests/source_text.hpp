// What the text of a C++ source says, read word by word: comments and literals set aside, the
// headers that it includes, and the names by which it may mean the standard library's functions.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace breakshot {

struct Source {
  std::string path;  // from the root of the source tree, with '/'
  std::string text;
};

/// Every C++ source below the root, but for what builds and runs leave there.
std::vector<Source> sources_below(const std::filesystem::path& root);

/// The text with comments and literals blanked, line for line; include directives stay whole.
std::string code_of(std::string_view text);

struct Mention {
  std::size_t line;  // from 1
  std::string name;
};

/// The header that each include directive of `code` names.
std::vector<Mention> includes_of(std::string_view code);

/// The words of `code` that would mean the standard library if it has a function of that name:
/// after std:: or a leading ::, or unqualified and called. Members and the functions of other
/// namespaces are somebody else's.
std::vector<Mention> standard_names_of(std::string_view code);

}  // namespace breakshot
