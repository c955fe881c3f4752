#include "libmpm/files/checkpoint_file.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "libmpm/files/replace_file.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/checkpoint.hpp"

namespace mpm {
namespace {

constexpr std::string_view magic = "MPXCKPT\n";
constexpr std::int64_t version = 1;
constexpr const char* cure = "resume from an earlier one, or start again";

/// All but the state.
template <class Archive, class Kept, class Text>
void pass_header(Archive& archive, Kept& kept, Text& scene_text, Text& remarks) {
  archive.whole(kept.precision, 0, 1);
  archive.flag(kept.moving);
  archive.text(kept.instruction_set);
  archive.text(kept.specimen);
  archive.whole(kept.step, 1, std::int64_t{1} << 62);
  archive.finite(kept.fraction);
  archive.finite(kept.wall_time);
  archive.list(kept.frames);
  archive.text(scene_text);
  archive.text(remarks);
}

std::string bytes_of(const std::string& path) {
  if (std::filesystem::is_directory(path)) throw FileError(path, "is a folder", "must be a checkpoint");
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
    throw FileError(path, "is not a regular file", "must be a checkpoint");
  errno = 0;
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream.is_open() ? static_cast<std::streamoff>(stream.tellg()) : -1;
  std::string bytes(magic.size(), '\0');
  if (size >= 0 && stream.seekg(0).read(bytes.data(), static_cast<std::streamsize>(bytes.size())) &&
      bytes != magic)
    throw FileError(path, "is not a checkpoint", "", cure);  // however long it is
  stream.clear();
  bytes.resize(static_cast<std::size_t>(std::max<std::streamoff>(size, 0)));
  if (size < 0 || !stream.seekg(0) || !stream.read(bytes.data(), size))
    throw FileError(path, "cannot be read: " + std::generic_category().message(errno),
                    "must be a checkpoint");
  return bytes;
}

/// The bytes between the magic and the digest.
std::string_view body_of(const std::string& path, std::string_view bytes) {
  if (bytes.size() < magic.size() + sha256_bytes || bytes.substr(0, magic.size()) != magic)
    throw FileError(path, "is not a checkpoint", "", cure);
  const std::string_view digest = bytes.substr(bytes.size() - sha256_bytes);
  bytes.remove_suffix(sha256_bytes);
  if (Sha256().add(bytes).digest() != digest)
    throw FileError(path, "is damaged: its digest does not match its bytes", "", cure);
  return bytes.substr(magic.size());
}

}  // namespace

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint, const std::string& scene_text,
                      const std::string& remarks) {
  ArchiveWriter archive;
  archive.raw(magic.data(), magic.size());
  archive.whole(version, 0, 0);
  pass_header(archive, checkpoint, scene_text, remarks);
  archive.whole(checkpoint.state.size(), 0, 0);  // which follows as it is, for it may be large
  const std::string header = archive.take();
  const std::string digest = Sha256().add(header).add(checkpoint.state).digest();
  replace_file(path, {header, checkpoint.state, digest});
}

CheckpointFile read_checkpoint(const std::string& path) {
  const std::string bytes = bytes_of(path);
  ArchiveReader archive(body_of(path, bytes));
  std::int64_t found = 0;
  archive.whole(found, INT64_MIN, INT64_MAX);
  if (archive.ok() && found != version)
    throw FileError(path, "is of version " + std::to_string(found),
                    "must be of version " + std::to_string(version), "resume with the program that wrote it");
  CheckpointFile file;
  pass_header(archive, file.checkpoint, file.scene_text, file.remarks);
  archive.text(file.checkpoint.state);
  archive.finish();
  if (!archive.ok()) throw FileError(path, "holds " + archive.fault(), "", cure);
  return file;
}

}  // namespace mpm
