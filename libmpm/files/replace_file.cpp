#include "libmpm/files/replace_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "libmpm/scene/error.hpp"

namespace mpm {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw FileError(path, "cannot be written: " + std::generic_category().message(error), "",
                  "check that the folder exists, may be written to and has space left");
}

/// Unique in the folder for as long as this process lives; an earlier one of the same number may have left
/// it.
std::string temporary_name(const std::string& path) {
  static std::atomic<unsigned> count{0};
  return path + "." + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp";
}

/// So that the new name outlasts the power too. Not every file system can, and the file itself is there.
void flush_folder(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)::fsync(descriptor);
  ::close(descriptor);
}

/// A file that is removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path)
      : path_(path),
        name_(temporary_name(path)),
        descriptor_(::open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail(path_, errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(path_, errno);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  /// Some file systems report a full disk only here.
  void close() {
    int synced = 0;
    do synced = ::fsync(descriptor_);
    while (synced != 0 && errno == EINTR);
    const int sync_error = errno;
    const int closed = ::close(std::exchange(descriptor_, -1));
    if (synced != 0 && sync_error != EINVAL && sync_error != EROFS) fail(path_, sync_error);
    if (closed != 0) fail(path_, errno);
  }

  void rename() {
    if (::rename(name_.c_str(), path_.c_str()) != 0) fail(path_, errno);
    renamed_ = true;
  }

 private:
  std::string path_;
  std::string name_;
  int descriptor_;
  bool renamed_ = false;
};

}  // namespace

void replace_file(const std::string& path, std::string_view bytes) { replace_file(path, {bytes}); }

void replace_file(const std::string& path, std::initializer_list<std::string_view> pieces) {
  TemporaryFile file(path);
  for (const std::string_view piece : pieces) file.write(piece);
  file.close();
  file.rename();
  flush_folder(path);
}

}  // namespace mpm
