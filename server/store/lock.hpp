// One server a database: whoever holds the lock file beside it.
#pragma once

#include <filesystem>

namespace breakshot::store {

/// Holds `file` locked until it is destroyed; the kernel lets go of it too when the process ends,
/// however it ends. Throws StoreError if another process holds it. A file of its own, since closing
/// any descriptor of the database would drop SQLite's locks on it.
class Lock {
 public:
  explicit Lock(const std::filesystem::path& file);
  ~Lock();
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int descriptor_;
};

}  // namespace breakshot::store
