#include "server/store/lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "server/store/store.hpp"

namespace breakshot::store {

Lock::Lock(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
  if (descriptor_ < 0) {
    throw StoreError(file.string() + ": cannot be opened for writing: " + std::strerror(errno));
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const std::string why = errno == EWOULDBLOCK
                              ? "another server uses this database; stop it or choose another file"
                              : std::string("cannot be locked: ") + std::strerror(errno);
  ::close(descriptor_);
  throw StoreError(file.string() + ": " + why);
}

Lock::~Lock() {
  ::close(descriptor_);
}

}  // namespace breakshot::store
