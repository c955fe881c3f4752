#include "apps/study/slurm_queue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <system_error>

#include "apps/text/complaint.hpp"
#include "apps/system/other_program.hpp"
#include "apps/system/text_file.hpp"
#include "apps/text/text_parts.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr int most_jobs = 999;

fs::path folder_of(const fs::path& study, int number) {
  return study / "slurm" / fmt::format("{:03}", number);
}

/// On one line, for a message.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return printable(std::string(trimmed(text)));
}

/// Of what sbatch says, where the name of a cluster may stand behind it, and of the file that keeps it.
std::string id_in(const std::string& text) { return text.substr(0, text.find_first_of(";\n")); }

}  // namespace

SlurmFolder SlurmFolder::next(const fs::path& study) {
  std::error_code error;
  fs::create_directories(study / "slurm", error);
  for (int number = 1; number <= most_jobs && !error; ++number)
    if (fs::create_directory(folder_of(study, number), error)) return SlurmFolder(folder_of(study, number));
  throw Rejected(Exit::io, complaint((study / "slurm").string(), error ? error.message() : "holds 999 jobs",
                                     "must take the folder of another job", "remove those that are over"));
}

std::string SlurmFolder::submit() const {
  const ProgramOutcome outcome = run_other_program({"sbatch", "--parsable", script().string()});
  if (outcome.code != 0)
    throw Rejected(Exit::io, complaint("sbatch", one_line(outcome.err), "",
                                       "mesopix study submit --help tells how to give it options"));
  const std::string id = id_in(outcome.out);
  mpm::replace_file((path_ / "job_id").string(), id + "\n");
  return id;
}

std::string SlurmFolder::job_id() const {
  std::error_code error;
  const fs::path file = path_ / "job_id";
  return fs::exists(file, error) ? id_in(read_text_file(file.string())) : "";
}

std::vector<SlurmFolder> slurm_folders(const fs::path& study) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(study / "slurm", error))
    if (entry.is_directory(error)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<SlurmFolder> folders;
  for (const fs::path& path : paths) folders.emplace_back(path);
  return folders;
}

std::map<std::string, int> tasks_in_queue(const std::string& job_id) {
  std::map<std::string, int> states;
  // Of a job that it has forgotten squeue says that there is none.
  std::istringstream lines(
      run_other_program({"squeue", "--array", "--noheader", "--format=%T", "--jobs=" + job_id}).out);
  for (std::string state; lines >> state;) ++states[state];
  return states;
}

}  // namespace app
