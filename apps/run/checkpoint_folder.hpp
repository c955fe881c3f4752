/// The checkpoints of a run in its folder.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
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

/// Writes checkpoints beside the run, on a thread of its own: a disk that stalls does not hold the run up.
/// One is under way at a time. Without a thread, where the system gives none, it writes at once.
class CheckpointWriter {
 public:
  /// @param folder  must outlive it, and is not to be used while one is under way.
  CheckpointWriter(CheckpointFolder& folder, std::string scene_text, std::string remarks);
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// Waits for the one before.
  void write(mpm::Checkpoint checkpoint);
  /// Until none is under way.
  void wait();
  [[nodiscard]] bool is_busy() const { return busy_; }
  /// What the last one took that was written [s]; 0 = there was none.
  [[nodiscard]] double last_time() const { return last_time_; }
  /// Why the last one is missing; empty = it is there.   @pre it is not busy.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

 private:
  void work();
  void write_now();

  CheckpointFolder& folder_;
  std::string scene_text_, remarks_;
  mpm::Checkpoint checkpoint_;
  std::atomic<double> last_time_ = 0;
  std::string trouble_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> busy_ = false;
  bool ends_ = false;
  std::optional<std::jthread> thread_;
};

}  // namespace app
