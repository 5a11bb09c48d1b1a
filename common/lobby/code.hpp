// The codes of private matches, as people type them.
#pragma once

#include <optional>
#include <string_view>

#include "common/lobby/lobby.hpp"

namespace breakshot::lobby {

/// The code that somebody meant: in any case, with O for 0 and I or L for 1, as Crockford's base 32
/// reads them. Nothing if it is no code.
std::optional<InviteCode> code_of(std::string_view text);

}  // namespace breakshot::lobby
