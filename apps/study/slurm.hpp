/// A study as an array job of Slurm.
/// What Slurm was asked for in the name of a study.
///   DIR/slurm/001/job.sh          the script
///   DIR/slurm/001/job_id          what Slurm calls it; missing for one that was not submitted
///   DIR/slurm/001/task_0.log ...  what the tasks said
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace app {

struct SlurmJob {
  std::string name;                 ///< in the queue
  std::string folder;               ///< that its commands are given in, absolute
  std::string logs;                 ///< folder of the messages, task_0.log ...; absolute
  std::vector<std::string> study;   ///< words of the command, but for --members and --jobs
  std::size_t members = 0;          ///< of the study
  std::size_t chunk = 1;            ///< members a task
  std::vector<std::size_t> tasks;   ///< that are wanted, rising, at least one
  int cpus = 1;                     ///< a task
  std::vector<std::string> wishes;  ///< options of sbatch, which come last and so count
};

/// "0-3,7,9-12" of numbers that rise.
[[nodiscard]] std::string ranges_text(const std::vector<std::size_t>& numbers);

/// The script for sbatch; folders must hold no control characters. Task T runs the members from T chunk on.
/// Two minutes before its time is up a task keeps what it has and is queued again; after a node has failed
/// Slurm does that by itself.
[[nodiscard]] std::string slurm_script(const SlurmJob& job);

/// One command a task, for GNU parallel or another program that takes a line a job.
[[nodiscard]] std::string command_list(const SlurmJob& job);

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
