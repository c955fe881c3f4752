#include "specimen/body/replace_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "specimen/body/error.hpp"

namespace specimen {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason, const std::string& cure = {}) {
  throw Error(path, "could not be written: " + reason, {}, cure, Fault::write);
}

[[noreturn]] void fail_with_errno(const std::string& path) {
  const int code = errno;
  fail(path, std::generic_category().message(code), code == ENOENT ? "create its folder first" : "");
}

/// A file under a name of its own, removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target) : target_(target), name_(unique_name(target)) {
    file_ = ::open(name_.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) fail_with_errno(target_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (file_ >= 0) ::close(file_);
    if (!renamed_) ::unlink(name_.c_str());
  }

  void write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(file_, bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR) fail_with_errno(target_);
      if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }

  /// Some disks report only here that they are full.
  void flush_and_close() {
    if (::fsync(file_) != 0) fail_with_errno(target_);
    const int file = file_;
    file_ = -1;
    if (::close(file) != 0) fail_with_errno(target_);
  }

  void rename_to_target() {
    if (std::rename(name_.c_str(), target_.c_str()) != 0) fail_with_errno(target_);
    renamed_ = true;
  }

 private:
  /// Two threads or two programs that write one path must not share their unfinished file.
  static std::string unique_name(const std::string& target) {
    static std::atomic<unsigned> serial{0};
    return target + ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(serial++);
  }

  std::string target_;
  std::string name_;
  int file_ = -1;
  bool renamed_ = false;
};

/// So that the new name survives a power cut. Not every file system can do it, and the bytes are safe anyway.
void flush_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

}  // namespace

void replace_file(const std::string& path, const std::function<void(const ByteSink&)>& produce) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) fail(path, "it is a folder", "give the name of a file");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    fail(path, "it is a device or a pipe, and a rename would replace it", "give the name of a file");
  TemporaryFile file(path);
  produce([&](std::span<const std::byte> bytes) { file.write(bytes); });
  file.flush_and_close();
  file.rename_to_target();
  flush_folder_of(path);
}

void replace_file(const std::string& path, std::span<const std::byte> bytes) {
  replace_file(path, [&](const ByteSink& sink) { sink(bytes); });
}

}  // namespace specimen
