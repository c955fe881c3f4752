#include "apps/system/held_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "apps/text/complaint.hpp"
#include "libmpm/scene/error.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

int open_lock(const fs::path& lock) {
  const int descriptor = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw mpm::FileError(lock.string(), "cannot be created: " + std::generic_category().message(errno), "",
                         "choose a folder that may be written to");
  return descriptor;
}

/// Not when the program that held it has removed it since it was opened.
bool is_still_there(int descriptor, const fs::path& lock) {
  struct stat opened = {}, found = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(lock.c_str(), &found) == 0 &&
         opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
}

/// @return false while another program has the lock.
bool take(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

int hold(const fs::path& lock) {
  for (;;) {
    const int descriptor = open_lock(lock);
    const bool taken = take(descriptor);
    if (taken && is_still_there(descriptor, lock)) return descriptor;
    ::close(descriptor);
    if (!taken)
      throw Rejected(Exit::interrupted,
                     complaint(lock.parent_path().string(), "another program is writing a run there", "",
                               "wait until it has ended, or choose another folder"));
  }
}

}  // namespace

HeldFolder::HeldFolder(const fs::path& folder)
    : lock_(folder / "in_progress.lock"), descriptor_(hold(lock_)) {}

HeldFolder::~HeldFolder() {
  if (is_still_there(descriptor_, lock_))  // else the folder was moved, and another may be in its place
    ::unlink(lock_.c_str());               // before it is let go: who opens it now makes another
  ::close(descriptor_);
}

}  // namespace app
