/// Whole files as text, several files of which a disk takes what it can, and folders that one program writes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "libmpm/scene/error.hpp"

namespace app {

inline constexpr std::size_t longest_text = std::size_t{16} << 20U;    ///< of what a person writes [bytes]
inline constexpr std::size_t longest_table = std::size_t{256} << 20U;  ///< of what a machine measured [bytes]

/// What stands after the last dot of the name of a file, with the dot and in small letters; or nothing.
[[nodiscard]] std::string ending_of(const std::string& path);

/// A pipe or a device may never begin, or never end: it is not even opened.
/// @throws Rejected (Exit::io) for what is there and neither a regular file nor a folder.
void require_regular_file(const std::string& path);

/// @throws Rejected naming the file: (Exit::io) for what is no regular file, and with the reason of the
/// system; (Exit::data) when it is longer.
[[nodiscard]] std::string read_text_file(const std::string& path, std::size_t longest = longest_text);

}  // namespace app

/// Files that could not be written; all others were. As an error it reads like the first of them.
struct NotWritten : mpm::FileError {
  explicit NotWritten(std::vector<mpm::FileError> all);
  std::vector<mpm::FileError> files;  ///< one at least
};

/// Writes that are each tried, whatever became of those before: where a large file does not fit on a disk any
/// more, a small one may.
class Attempts {
 public:
  /// Calls `write` and keeps what it throws when the disk fails; its other exceptions pass.
  void operator()(const std::function<void()>& write);
  /// @throws NotWritten when any write failed.
  void conclude() const;

 private:
  std::vector<mpm::FileError> failures_;
};

namespace app {

/// Removes what programs that are gone left in a folder: files on their way to the disk, under the names that
/// both libraries give them. Those of other programs that run stay.
/// @pre the folder is held: programs on other machines are not seen, and this one writes nothing there yet.
void remove_remainders(const std::filesystem::path& folder);

/// The same in a folder that several machines write to: a file on its way to the disk for more than an hour
/// is on no way any more.
void remove_old_remainders(const std::filesystem::path& folder);

/// While it lives, no other program can hold the folder. A program that is killed holds nothing any more; its
/// file, in_progress.lock, may stay.
class HeldFolder {
 public:
  /// File systems without locks hold nothing, and say nothing.
  /// @throws Rejected (Exit::interrupted) while another program holds it; mpm::FileError.
  explicit HeldFolder(const std::filesystem::path& folder);
  ~HeldFolder();
  HeldFolder(const HeldFolder&) = delete;
  HeldFolder& operator=(const HeldFolder&) = delete;

 private:
  std::filesystem::path lock_;
  int descriptor_;
};

}  // namespace app
