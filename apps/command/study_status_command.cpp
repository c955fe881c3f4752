#include "apps/command/study_input.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/study/slurm.hpp"
#include "apps/text/markup.hpp"

namespace app {
namespace {

/// Members by what became of them.
struct Count {
  std::size_t all = 0, done = 0, failed = 0;
  std::size_t begun = 0;  ///< have neither a result nor a failure, but a checkpoint
  std::size_t open = 0;   ///< the others
};

Count count(const OpenStudy& study) {
  Count count{.all = study.members.size()};
  for (const Member& member : study.members)
    ++(study.folder.has_result(member)   ? count.done
       : study.folder.has_failed(member) ? count.failed
       : study.folder.has_begun(member)  ? count.begun
                                         : count.open);
  return count;
}

/// A job that was submitted, and its tasks that have not ended.
struct ClusterJob {
  std::string id;
  std::map<std::string, int> states;  ///< number of tasks by state
};

/// Slurm is asked only where there is such a job.
std::vector<ClusterJob> jobs_of(const OpenStudy& study) {
  std::vector<ClusterJob> jobs;
  for (const SlurmFolder& folder : slurm_folders(study.folder.path()))
    if (const std::string id = folder.job_id(); !id.empty()) jobs.push_back({id, tasks_in_queue(id)});
  return jobs;
}

nlohmann::ordered_json json_of(const Count& count, const std::vector<ClusterJob>& jobs) {
  nlohmann::ordered_json json{{"members", count.all},   {"done", count.done},
                              {"failed", count.failed}, {"begun", count.begun},
                              {"open", count.open},     {"jobs", nlohmann::json::array()}};
  for (const ClusterJob& job : jobs) json["jobs"].push_back({{"id", job.id}, {"tasks", job.states}});
  return json;
}

std::string job_text(const ClusterJob& job) {
  std::string states;
  for (const auto& [state, tasks] : job.states)
    states += fmt::format("{}{} {}", states.empty() ? "" : ", ", tasks, state);
  return "Slurm job " + job.id + ": " + (states.empty() ? "no task in the queue" : states);
}

class StudyStatusCommand : public Command {
 public:
  explicit StudyStatusCommand(CLI::App& study)
      : Command(study, "status", "Tell how far a study is, here and in the queue of Slurm",
                "Begun are members that have a checkpoint and no result yet.\n"
                "Example: a study whose members run elsewhere\n"
                "  mesopix study status study.toml") {
    input_.add_to(options());
    flag("--json", json_, "as JSON");
  }

  Exit run(Console& console) override {
    const OpenStudy study = open_study(input_);
    const Count members = count(study);
    const std::vector<ClusterJob> jobs = jobs_of(study);
    if (json_) {
      console.out << json_text(json_of(members, jobs));
      return Exit::ok;
    }
    console.out << fmt::format("{}: {} members: {} done, {} failed, {} begun, {} open\n",
                               printable(study.folder.path().string()), members.all, members.done,
                               members.failed, members.begun, members.open);
    for (const ClusterJob& job : jobs) console.out << job_text(job) << '\n';
    return Exit::ok;
  }

 private:
  StudyInput input_;
};

}  // namespace

CommandPointer study_status_command(CLI::App& parent) { return std::make_unique<StudyStatusCommand>(parent); }

}  // namespace app
