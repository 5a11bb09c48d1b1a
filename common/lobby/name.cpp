#include "common/lobby/name.hpp"

#include "common/record/text.hpp"

namespace breakshot::lobby {
namespace {

bool is_space(char32_t c) {
  return c == ' ' || c == 0xa0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200a) || c == 0x202f ||
         c == 0x205f || c == 0x3000;
}

}  // namespace

std::optional<std::string> name_fault(std::string_view name) {
  if (name.empty()) return "a name must not be empty";
  std::size_t length = 0;
  bool ends_in_space = false;
  while (!name.empty()) {
    const record::Character next = record::first_of(name);
    if (next.bytes == 0) return "a name must be UTF-8 text";
    if (const auto what = record::unprintable(next.code_point))
      return "a name must not hold " + *what;
    ends_in_space = is_space(next.code_point);
    if (length == 0 && ends_in_space) return "a name must not begin with a space";
    if (++length > max_name_length) {
      return "a name must have at most " + std::to_string(max_name_length) + " characters";
    }
    name.remove_prefix(next.bytes);
  }
  if (ends_in_space) return "a name must not end with a space";
  return std::nullopt;
}

}  // namespace breakshot::lobby
