/// The checkpoints of a run in its folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/files/checkpoint_file.hpp"

namespace app {

/// RUN/checkpoints/step_000000001234.checkpoint: the last two, by the steps that led there.
class CheckpointFolder {
 public:
  explicit CheckpointFolder(const std::filesystem::path& run) : folder_(run / "checkpoints") {}

  /// Makes the folder where it is missing; the one before the one before is removed.   @throws
  /// mpm::FileError.
  void write(const mpm::Checkpoint& checkpoint, const std::string& scene_text, const std::string& remarks);

  struct Last {
    std::filesystem::path path;
    mpm::CheckpointFile file;
  };
  /// The last one that can be read, and what is wrong with those behind it. Nothing when there is none.
  struct Found {
    std::optional<Last> last;
    std::vector<std::string> faults;
  };
  [[nodiscard]] Found last() const;

  /// Removes those behind a step, and what writing them left when it was cut off: a run that goes on from
  /// there comes to them again.   @throws mpm::FileError.
  void remove_behind(std::int64_t step) const;
  /// Removes all of them, and the folder when nothing else is in it.   @throws mpm::FileError.
  void remove() const { remove_behind(-1); }

  [[nodiscard]] int written() const { return written_; }
  [[nodiscard]] double wall_time() const { return wall_time_; }  ///< that writing took [s]

 private:
  [[nodiscard]] std::map<std::int64_t, std::filesystem::path> files() const;  ///< by step

  std::filesystem::path folder_;
  int written_ = 0;
  double wall_time_ = 0;
};

}  // namespace app
