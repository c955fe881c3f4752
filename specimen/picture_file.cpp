#include "specimen/picture_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

namespace specimen {
namespace {

Error disk_error(const std::string& path, const std::string& what, int code) {
  return {path, what + ": " + std::strerror(code), "", "", Fault::write};
}

/// A file under a temporary name that is removed unless it was kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target) : target_(target) {
    static std::atomic<unsigned> serial{0};
    name_ = target + ".part-" + std::to_string(::getpid()) + "-" + std::to_string(serial++);
    descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw disk_error(target_, "cannot be written", errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) (void)::close(descriptor_);
    if (!kept_) (void)::unlink(name_.c_str());
  }

  void write(const Bytes& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t count = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) throw disk_error(target_, "writing failed", errno);
      done += static_cast<std::size_t>(count);
    }
  }

  void keep() {
    if (::fsync(descriptor_) != 0) throw disk_error(target_, "flushing to the disk failed", errno);
    if (::close(std::exchange(descriptor_, -1)) != 0) throw disk_error(target_, "closing failed", errno);
    if (::rename(name_.c_str(), target_.c_str()) != 0) throw disk_error(target_, "cannot be written", errno);
    kept_ = true;
  }

 private:
  std::string target_, name_;
  int descriptor_ = -1;
  bool kept_ = false;
};

}  // namespace

Error bad_picture(const std::string& path, std::string problem, std::string cure) {
  return {path, std::move(problem), "", std::move(cure)};
}

PictureSource open_picture(const std::string& path, std::int64_t max_pixels) {
  PictureSource source{path, max_pixels, 0, nullptr};
  // Looked at before opening: opening a pipe would wait for its other end.
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) throw disk_error(path, "cannot be read", errno);
  if (!S_ISREG(about.st_mode)) throw bad_picture(path, "is no regular file", "give a picture file");
  source.file.reset(std::fopen(path.c_str(), "rb"));
  if (source.file == nullptr) throw disk_error(path, "cannot be read", errno);
  source.bytes = about.st_size;
  return source;
}

void read_exactly(const PictureSource& source, std::uint8_t* bytes, std::size_t count) {
  if (std::fread(bytes, 1, count, source.file.get()) == count) return;
  if (std::ferror(source.file.get()) != 0) throw disk_error(source.path, "cannot be read", errno);
  throw bad_picture(source.path, "is cut off: the file ends before its last pixel");
}

void write_whole_file(const std::string& path, const Bytes& bytes) {
  TemporaryFile file(path);
  file.write(bytes);
  file.keep();
}

}  // namespace specimen
