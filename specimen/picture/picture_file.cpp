#include "specimen/picture/picture_file.hpp"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace specimen {
namespace {

Error disk_error(const std::string& path, const std::string& what, int code) {
  return {path, what + ": " + std::strerror(code), "", "", Fault::write};
}

}  // namespace

Error bad_picture(const std::string& path, std::string problem, std::string cure) {
  return {path, std::move(problem), "", std::move(cure)};
}

Error several_pictures(const std::string& path, std::string what_it_is) {
  return {path, std::move(what_it_is), "must hold one picture", "save the right one as a separate file"};
}

PictureSource open_picture(const std::string& path, std::int64_t max_pixels) {
  PictureSource source{path, max_pixels, 0, nullptr};
  // Looked at before opening: opening a pipe would wait for its other end.
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) throw disk_error(path, "cannot be read", errno);
  if (!S_ISREG(about.st_mode)) throw bad_picture(path, "is not a regular file", "give a picture file");
  source.file.reset(std::fopen(path.c_str(), "rb"));
  if (source.file == nullptr) throw disk_error(path, "cannot be read", errno);
  source.bytes = about.st_size;
  return source;
}

void read_exactly(const PictureSource& source, std::uint8_t* bytes, std::size_t count) {
  if (std::fread(bytes, 1, count, source.file.get()) == count) return;
  if (std::ferror(source.file.get()) != 0) throw disk_error(source.path, "cannot be read", errno);
  throw bad_picture(source.path, "is truncated: the file ends before its last pixel");
}

}  // namespace specimen
