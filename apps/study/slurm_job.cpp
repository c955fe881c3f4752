#include "apps/study/slurm_job.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/text/complaint.hpp"
#include "apps/text/shell_word.hpp"

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

}  // namespace app
