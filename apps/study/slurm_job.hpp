/// A study as an array job of Slurm.
#pragma once

#include <cstddef>
#include <string>
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

}  // namespace app
