#include "apps/command/compared_runs.hpp"

#include <algorithm>

#include "apps/run/run_location.hpp"
#include "apps/scene/input.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/complaint.hpp"

namespace app {

namespace fs = std::filesystem;

fs::path result_of(const std::string& run) {
  switch (kind_of_input(run)) {
    case InputKind::folder:
      return fs::path(run) / "result.h5";
    case InputKind::hdf5:
      return run;
    default:
      throw Rejected(Exit::usage, "RUN", run, "must be the folder of a run, or its result.h5");
  }
}

namespace {

/// The folder of each run by its last part; the whole path where that is not enough to tell them apart.
std::vector<std::string> folder_names(const std::vector<std::string>& runs) {
  std::vector<std::string> names;
  for (const std::string& run : runs) {
    const fs::path folder = fs::absolute(result_of(run)).lexically_normal().parent_path();
    names.push_back(folder.filename().string());
  }
  const std::vector<std::string> short_names = names;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (std::count(short_names.begin(), short_names.end(), short_names[i]) > 1) names[i] = runs[i];
  return names;
}

void check_names(const std::vector<std::string>& runs) {
  if (runs.size() > output::most_compared_runs)
    throw Rejected(Exit::usage, "RUN", std::to_string(runs.size()) + " given",
                   "must be " + std::to_string(output::most_compared_runs) +
                       " runs at most: more lines cannot be told apart");
  for (const std::string& run : runs)
    if (std::count(runs.begin(), runs.end(), run) > 1)
      throw Rejected(Exit::usage, "RUN", run, "must not be given twice");
}

}  // namespace

std::vector<output::ComparedRun> read_compared(const std::vector<std::string>& runs) {
  check_names(runs);
  const std::vector<std::string> names = folder_names(runs);
  std::vector<output::ComparedRun> compared;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const fs::path path = result_of(runs[i]);
    if (path.filename() == "result.h5") check_one_run(path.parent_path().string());
    compared.push_back({names[i], read_result(path.string())});
  }
  return compared;
}

}  // namespace app
