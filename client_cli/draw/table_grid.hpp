// The picture of the table in a terminal's cells: in colour, two pixels a cell with the balls'
// numbers on top; otherwise in plain characters.
#pragma once

#include <string>
#include <vector>

#include "client_cli/draw/abilities.hpp"
#include "client_cli/draw/grid.hpp"
#include "client_cli/draw/picture.hpp"

namespace breakshot::client {

/// The table, under it the pocketed balls with the caption, and under that `lines`. The table takes
/// the rows that are left; where there are hardly any, the lines win.
Grid grid_of(const Picture& picture, const std::vector<std::string>& lines, TerminalSize size,
             const Abilities& abilities);

/// The table in ASCII, `columns` wide and as high as its shape asks: balls are 1 to 9 and a to f,
/// the cue ball is 0, other balls are *; gaps in the border are pockets. The text explains itself.
std::string plain_text_of(const Picture& picture, int columns);

/// Width of the plain picture where nothing else is known.
inline constexpr int plain_columns = 76;

}  // namespace breakshot::client
