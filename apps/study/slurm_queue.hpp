/// What Slurm was asked for in the name of a study.
///   DIR/slurm/001/job.sh          the script
///   DIR/slurm/001/job_id          what Slurm calls it; missing for one that was not submitted
///   DIR/slurm/001/task_0.log ...  what the tasks said
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace app {

/// One job.
class SlurmFolder {
 public:
  /// The next one of a study, made.   @throws Rejected (Exit::io).
  [[nodiscard]] static SlurmFolder next(const std::filesystem::path& study);

  explicit SlurmFolder(std::filesystem::path path) : path_(std::move(path)) {}
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path script() const { return path_ / "job.sh"; }

  /// Hand the script to sbatch, and keep what Slurm calls the job.
  /// @return that.   @throws Rejected (Exit::io) with what sbatch says when it does not take it.
  [[nodiscard]] std::string submit() const;
  /// Empty for one that was not submitted.
  [[nodiscard]] std::string job_id() const;

 private:
  std::filesystem::path path_;
};

/// Those of a study, first one first.
[[nodiscard]] std::vector<SlurmFolder> slurm_folders(const std::filesystem::path& study);

/// How many tasks of a job are in which state: "PENDING", "RUNNING"; none once it has left the queue.
/// @throws Rejected (Exit::io) when squeue is not there.
[[nodiscard]] std::map<std::string, int> tasks_in_queue(const std::string& job_id);

}  // namespace app
