#include "apps/command/study_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/settings/assignment.hpp"
#include "apps/study/slurm.hpp"
#include "apps/study/study_run.hpp"
#include "apps/system/processes.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/text_parts.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* study_submit_footer =
    "The members that have neither a result nor a failure become the tasks of an array job, some of them a "
    "task.\nResults go to the folder of the study, which all nodes must see; each is written whole or not at "
    "all. A task\nwhose time is nearly up keeps what it has and queues itself again; one whose node fails is "
    "queued again by\nSlurm; members go on from a checkpoint that is a minute old at most. What was lost all "
    "the same is submitted\nby the same command again.\n"
    "Nodes of several kinds: name an instruction set that all have in the scene (solver.instruction_set), "
    "for "
    "the\nsame results to the last bit.\n"
    "Example: 1000 members, 20 a task, with an hour and a partition for each\n"
    "  mesopix study submit study.toml --slurm --chunk 20 --sbatch=--time=1:00:00 "
    "--sbatch=--partition=short\n"
    "  mesopix study status study.toml\n"
    "  mesopix study collect study.toml\n"
    "Without Slurm:\n"
    "  mesopix study submit study.toml --commands | parallel";

constexpr std::size_t usual_chunk = 10;
constexpr std::size_t most_tasks = 1000;  // Slurm's own limit, unless it is set up for more

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Those with a member that is neither done nor has failed.
std::vector<std::size_t> open_tasks(const OpenStudy& open, std::size_t chunk) {
  std::vector<std::size_t> tasks;
  for (const Member& member : open.members) {
    const std::size_t task = member.number / chunk;
    if (!tasks.empty() && tasks.back() == task) continue;
    if (!open.folder.has_result(member) && !open.folder.has_failed(member)) tasks.push_back(task);
  }
  return tasks;
}

std::string command_of(const char* name, const StudyInput& input) {
  std::string text = std::string("mesopix study ") + name;
  for (const std::string& word : input.words()) text += " " + shell_word(word);
  return text;
}

class StudySubmitCommand : public Command {
 public:
  explicit StudySubmitCommand(CLI::App& study)
      : Command(study, "submit", "Leave a study to Slurm, or list its commands", study_submit_footer) {
    input_.add_to(options());
    flag("--slurm", slurm_, "submit an array job with sbatch");
    flag("--commands", commands_, "print a command a line, for GNU parallel and the like");
    flag("--dry-run", dry_run_, "with --slurm: write the script, and submit nothing");
    option("--chunk", chunk_, "members a task [10, or as many as make 1000 tasks]",
           WholeNumberCodec().form());
    option("--jobs", jobs_, "members at a time, each on a core of its own, in a task [1]",
           WholeNumberCodec().form());
    option("--sbatch", sbatch_, "option for sbatch, as --sbatch=--time=1:00:00; may be repeated",
           text_form("OPTION"))
        ->take_all();
    json_and_quiet("with --slurm: the job as JSON on standard output");
  }

  Exit run(Console& console) override {
    input_.check();
    check_options();
    (void)chunk(1);
    (void)cpus();
    const OpenStudy open = open_study(input_);
    for (const std::string& doubt : check_scenes(open.study, open.members).doubts) console.warn(doubt);
    const SlurmJob wanted = job(open);
    if (wanted.tasks.empty()) {
      tell(wanted, "", "", console);
      console.say(fmt::format("nothing to do: all {} members are done or have failed", open.members.size()));
      return Exit::ok;
    }
    if (commands_)
      console.out << command_list(wanted);
    else
      submit(wanted, open, console);
    return Exit::ok;
  }

 private:
  void check_options() const {
    if (slurm_ == commands_)
      throw Rejected(Exit::usage, "study submit", slurm_ ? "--slurm and --commands" : "",
                     "must be told where to: --slurm or --commands");
    if (commands_ && (dry_run_ || !sbatch_.empty() || json_))
      throw Rejected(Exit::usage,
                     dry_run_           ? "--dry-run"
                     : !sbatch_.empty() ? "--sbatch"
                                        : "--json",
                     "given with --commands", "goes with --slurm");
    for (const std::string& option : sbatch_)
      if (option.rfind("-", 0) != 0 || printable(option) != option)
        throw Rejected(Exit::usage, "--sbatch", app::quoted(option), "must be an option of sbatch",
                       "--sbatch=--time=1:00:00");
  }

  [[nodiscard]] std::size_t chunk(std::size_t members) const {
    if (chunk_.empty()) return std::max(usual_chunk, (members + most_tasks - 1) / most_tasks);
    return static_cast<std::size_t>(read_option("chunk", chunk_, IntegerCodec<>{between(1, 100'000)}));
  }

  [[nodiscard]] int cpus() const {
    return jobs_.empty() ? 1 : read_option("jobs", jobs_, IntegerCodec<>{between(1, 1024)});
  }

  [[nodiscard]] SlurmJob job(const OpenStudy& open) const {
    const std::size_t members = chunk(open.members.size());
    return {.name = fs::path(input_.file()).stem().string(),
            .folder = fs::current_path().string(),
            .logs = {},
            .study = with({this_program(), "study"}, input_.words()),
            .members = open.members.size(),
            .chunk = members,
            .tasks = open_tasks(open, members),
            .cpus = cpus(),
            .wishes = sbatch_};
  }

  /// @param script, id  of the job; empty = there is none.
  void tell(const SlurmJob& job, const std::string& script, const std::string& id, Console& console) const {
    using Json = nlohmann::ordered_json;
    const auto text_or_null = [](const std::string& text) {
      return text.empty() ? Json(nullptr) : Json(text);
    };
    if (json_)
      console.out << json_text({{"job", text_or_null(id)},
                                {"script", text_or_null(script)},
                                {"tasks", job.tasks.size()},
                                {"members_a_task", job.chunk}});
  }

  void submit(SlurmJob job, const OpenStudy& open, Console& console) const {
    const SlurmFolder folder = SlurmFolder::next(open.folder.path());
    job.logs = fs::absolute(folder.path()).string();
    if (printable(job.logs) != job.logs)
      throw Rejected(Exit::usage, "-o", app::quoted(job.logs), "must have no control characters for Slurm");
    mpm::replace_file(folder.script().string(), slurm_script(job));
    const std::string what = fmt::format("{} tasks of {} members", job.tasks.size(), job.chunk);
    if (dry_run_) {
      tell(job, folder.script().string(), "", console);
      console.say("wrote " + folder.script().string() + ": " + what);
      return;
    }
    const std::string id = folder.submit();
    tell(job, folder.script().string(), id, console);
    console.say("submitted job " + id + ": " + what);
    console.say("to see how far it is: " + command_of("status", input_));
    console.say("for tables and report: " + command_of("collect", input_));
  }

  StudyInput input_;
  bool slurm_ = false;
  bool commands_ = false;
  bool dry_run_ = false;
  std::string chunk_;
  std::string jobs_;
  std::vector<std::string> sbatch_;
};

}  // namespace

CommandPointer study_submit_command(CLI::App& parent) { return std::make_unique<StudySubmitCommand>(parent); }

}  // namespace app
