#include "apps/study/slurm.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <sstream>
#include <system_error>

#include "apps/system/files.hpp"
#include "apps/system/processes.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/text_parts.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

/// In the names of files Slurm puts a number for %a, and a % for %%.
std::string log_pattern(const std::string& folder) {
  std::string pattern;
  for (const char c : folder) pattern += c == '%' ? std::string("%%") : std::string(1, c);
  return pattern + "/task_%a.log";
}

std::string command_of(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

constexpr const char* before = R"(again='' signal='' signalled=1 code=0 mesopix=''
pass_on() { signalled=1 signal=$1; [ -n "$mesopix" ] && kill -"$signal" "$mesopix" 2>/dev/null; }
trap 'again=1; pass_on USR1' USR1
trap 'pass_on TERM' TERM INT
)";

// wait returns early when a signal is passed on, and is then called again.
constexpr const char* after = R"( &
mesopix=$!
[ -n "$signal" ] && pass_on "$signal"  # that came before there was anyone to pass it on to
while [ -n "$signalled" ]; do
  signalled=''
  wait "$mesopix"
  code=$?
done
# 75: ended on demand, and can go on from where it was.
[ -n "$again" ] && [ "$code" = 75 ] && scontrol requeue "$SLURM_JOB_ID"
exit "$code"
)";

}  // namespace

std::string ranges_text(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return text;
}

std::string slurm_script(const SlurmJob& job) {
  std::string text = "#!/bin/bash\n";
  const auto wish = [&](const std::string& option) { text += "#SBATCH " + option + "\n"; };
  wish("--job-name=" + shell_word(printable(job.name)));
  wish("--array=" + ranges_text(job.tasks));
  wish(fmt::format("--cpus-per-task={}", job.cpus));
  wish("--output=" + shell_word(log_pattern(job.logs)));
  wish("--open-mode=append");
  wish("--requeue");
  wish("--signal=B:USR1@120");
  for (const std::string& one : job.wishes) wish(one);
  text += "\n# Some members of a study a task; made by mesopix study submit.\n";
  text += "cd " + shell_word(job.folder) + " || exit 74\n";
  text += fmt::format("first=$((SLURM_ARRAY_TASK_ID * {}))\n", job.chunk);
  text += fmt::format("beyond=$((first + {} < {} ? first + {} : {}))\n", job.chunk, job.members, job.chunk,
                      job.members);
  text += before + command_of(job.study) + fmt::format(" --members \"$first:$beyond\" --jobs {}", job.cpus) +
          after;
  return text;
}

std::string command_list(const SlurmJob& job) {
  std::string text;
  for (const std::size_t task : job.tasks) {
    const std::size_t first = task * job.chunk;
    text += fmt::format("cd {} && {} --members {}:{} --jobs {}\n", shell_word(job.folder),
                        command_of(job.study), first, std::min(first + job.chunk, job.members), job.cpus);
  }
  return text;
}

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
  throw Rejected(Exit::io, (study / "slurm").string(), error ? error.message() : "holds 999 jobs",
                 "must take the folder of another job", "remove those that are over");
}

std::string SlurmFolder::submit() const {
  const ProgramOutcome outcome = run_other_program({"sbatch", "--parsable", script().string()});
  if (outcome.code != 0)
    throw Rejected(Exit::io, "sbatch", one_line(outcome.err), "",
                   "mesopix study submit --help tells how to give it options");
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
