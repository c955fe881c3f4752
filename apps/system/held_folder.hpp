/// One program at a time writes a run folder.
#pragma once

#include <filesystem>

namespace app {

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
