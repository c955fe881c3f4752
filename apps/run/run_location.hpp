/// In which folder a run is written, and how it is read back.
#pragma once

#include <filesystem>
#include <system_error>
#include <utility>

#include "apps/job/job.hpp"
#include "apps/run/run_folder.hpp"

namespace app {

/// Make a folder, and those that it lies in, where they are missing.   @throws Rejected (Exit::io).
void make_folders(const std::filesystem::path& folder);

/// Creates the folder of a run: `wanted`, or runs/STEM, runs/STEM-2, ... when it is empty.
/// @throws Rejected (Exit::usage) when `wanted` is taken and may not be overwritten, (Exit::io) when it
/// cannot be made.
[[nodiscard]] std::filesystem::path make_run_folder(const std::filesystem::path& wanted,
                                                    const std::filesystem::path& stem, bool overwrite);

/// The folder that was made for a run disappears again when the run could not begin.
class FreshFolder {
 public:
  explicit FreshFolder(std::filesystem::path path) : path_(std::move(path)) {}
  ~FreshFolder() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);  // fails, as it should, once something is in it
  }
  FreshFolder(const FreshFolder&) = delete;
  FreshFolder& operator=(const FreshFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Owner of what a RunRecord refers to: the job, paths in its settings relative to where the program is, and
/// what came of it.
struct ReadRun : Job {
  mpm::Result result;
  std::string scene_toml;
  std::string run;                            ///< run_digest(); empty where result.h5 names none
  output::ErrorEstimate error_estimate = {};  ///< without sources when none was asked for

  [[nodiscard]] RunRecord record() const;
};

/// That the files of a folder are of one run: scene.toml, result.h5 and summary.json.
/// @throws Rejected (Exit::data) naming those that are not; the errors of the readers.
void check_one_run(const std::string& folder);

/// Specimen, scene and result of a run. A specimen that is missing is made again from the scene.
/// @throws Rejected (Exit::usage) for what is no run folder, (Exit::data) for one whose files do not belong
/// together, and the errors of the readers.
[[nodiscard]] ReadRun read_run(const std::string& folder);

}  // namespace app
