// The database file: whose it is, its version, its tables.
#pragma once

#include <filesystem>

#include "server/store/sqlite.hpp"

namespace breakshot::store {

/// In the header of the file ("PRAGMA application_id"): the letters BRKS.
inline constexpr std::int64_t application_id = 0x42524b53;
/// Of the tables ("PRAGMA user_version"). A change of the tables raises it and comes with the
/// statements that bring an older file up to it.
inline constexpr std::int64_t schema_version = 1;

/// Files up to this size are checked as a whole when they are opened, bytes: about a second. In
/// larger ones damage shows when it is read.
inline constexpr std::int64_t checked_size_bytes = 256LL * 1024 * 1024;

/// Makes sure that the file is a database of this version, creating one if there is nothing yet,
/// and that it is not damaged, unless it is larger than `checked_bytes`. Throws StoreError.
void prepare_file(const std::filesystem::path& file,
                  std::int64_t checked_bytes = checked_size_bytes);

/// A connection that writes: a commit is on the medium when it returns.
Database open_to_write(const std::filesystem::path& file);

}  // namespace breakshot::store
