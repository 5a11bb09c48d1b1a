// Random values of everything that is asked and told, each a pure function of its seed.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "common/lobby/lobby.hpp"
#include "tests/support/chance.hpp"

namespace breakshot::wire::samples {

using support::Chance;

std::string random_name(Chance& chance);
rules::Seat random_seat(Chance& chance);
match::Seq random_seq(Chance& chance);
std::optional<match::MatchEnd> random_end(Chance& chance);
/// The command that is alternative `index` of its variant.
match::Command random_command(Chance& chance, std::size_t index);
physics::Shot random_shot(Chance& chance, std::size_t events);
match::Settings random_settings(Chance& chance);
record::Header random_header(Chance& chance);
record::Entry random_entry(Chance& chance);

inline constexpr std::size_t command_kinds = std::variant_size_v<match::Command>;
inline constexpr std::size_t request_kinds = std::variant_size_v<lobby::Request>;
inline constexpr std::size_t answer_kinds = std::variant_size_v<lobby::Answer>;

/// The request, or answer, that is alternative `index` of its variant.
lobby::Request random_request(Chance& chance, std::size_t index);
lobby::Answer random_answer(Chance& chance, std::size_t index);

}  // namespace breakshot::wire::samples
