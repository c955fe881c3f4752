#include "apps/command/study_input.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/settings/assignment.hpp"
#include "apps/study/study_file.hpp"
#include "apps/study/study_growth.hpp"
#include "apps/study/study_outcome.hpp"
#include "apps/system/job_pool.hpp"
#include "apps/system/processes.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/text_parts.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* about_values =
    "[vary] has keys of the scene; several with + take one value. Values are a list, equal steps, or a range "
    "to "
    "sample:\n"
    "  \"generate.width + generate.height\" = [\"75 mm\", \"150 mm\"]\n"
    "  \"loading.velocity\" = {from = \"0.02 m/s\", to = \"0.1 m/s\", steps = 5}\n"
    "  \"phases.mortar.tensile_scale\" = {low = \"10 MPa\", high = \"20 MPa\"}\n";

constexpr const char* about_members =
    "Members run one on each core, each on one thread. Memory is taken by those that run, for a million "
    "points\nless than 100 MB each with small strain, 200 MB without inertia and 400 MB with moving points, "
    "and by 200\npoints of the curve of every member. The folder keeps every member by what it depends on, "
    "the version of the "
    "program included:\nthe same command goes on where it stopped, and a study may grow by seeds, levels and "
    "samples (a Latin\nhypercube cannot). It gets table.csv, table.h5 and report.html; members write no "
    "frames. The table is the\nsame whatever ran where; on processors of different kinds, set "
    "solver.instruction_set in the scene.\n"
    "On a cluster: mesopix study submit, status, collect.\n"
    "Example: twenty specimens, or as many as tell the mean strength to 2 %\n"
    "  mesopix study data/tension_study.toml\n"
    "  mesopix study data/tension_study.toml --until-ci \"2 %\"";

/// What a study file may say, by its own schema.
std::string study_footer() {
  std::string text = "Keys of STUDY.toml:\n";
  for (const auto& field : study_fields())
    text += fmt::format("  {:<14}{:<30}{}\n", field.key, type(field.form), field.help);
  return text + about_values + about_members;
}

class StudyCommand : public Command {
 public:
  explicit StudyCommand(CLI::App& program)
      : Command(program, "study", "Run a scene many times, with other seeds and values", study_footer()) {
    input_.add_to(options());
    option("--jobs", jobs_, "members at a time [one a core]", WholeNumberCodec().form());
    option("--until-ci", until_ci_,
           "more seeds until the 95 % confidence interval of the mean peak stress is within this share "
           "of it, e.g. \"2 %\"",
           text_form("RATIO"));
    option("--members", members_, "only those from number I to before J, and no table: for several machines",
           text_form("I:J"));
    flag("--retry", retry_, "run members again that have failed before");
    json_and_quiet("number of members and mean peak as JSON on standard output");
    below_.push_back(study_submit_command(options()));
    below_.push_back(study_status_command(options()));
    below_.push_back(study_collect_command(options()));
  }

  Exit run(Console& console) override {
    check_options();
    const Workers workers = this->workers();
    workers_ = workers.count;
    if (!workers.note.empty()) console.say("note: " + workers.note);
    (void)until_ci();
    const Study study = read_study(input_.file());
    if (!until_ci_.empty() && study.plan.seeds.empty())
      throw Rejected(Exit::usage, "--until-ci", until_ci_, "needs a study with seeds",
                     "write seeds = 10 into " + input_.file());
    const std::vector<Member> all = list_members(study);
    const std::vector<Member> members = members_.empty() ? all : wanted(all);
    const CheckedScenes checked = check_scenes(study, members);
    for (const std::string& doubt : checked.doubts) console.warn(doubt);
    if (const std::string note = note_of_left_out(study.base.origins, *members.front().settings);
        !note.empty())
      console.say("note: " + note);
    input_.folder().open(study, all);
    if (retry_)
      for (const Member& member : members) input_.folder().forget_failure(member);
    if (!console.quiet)
      if (const std::string length = announcement(input_.folder(), members, checked.sizes, workers_);
          !length.empty())
        console.say(length);
    return members_.empty() ? run_whole(study, members, console) : run_part(study, members, console);
  }

 private:
  void check_options() const {
    input_.check();
    if (!until_ci_.empty() && !members_.empty())
      throw Rejected(Exit::usage, "--until-ci", "given with --members", "", "give one of the two");
  }

  [[nodiscard]] Workers workers() const {
    if (jobs_.empty()) return {core_count(), ""};
    return workers_within_cores(read_option("jobs", jobs_, IntegerCodec<>{between(1, 1024)}), "--jobs");
  }

  /// That goes on with the study.
  [[nodiscard]] std::string command() const {
    std::string text = "mesopix study";
    for (const std::string& word : input_.words()) text += " " + shell_word(word);
    if (!members_.empty()) text += " --members " + members_;
    if (!until_ci_.empty()) text += " --until-ci " + shell_word(until_ci_);
    if (!jobs_.empty()) text += " --jobs " + jobs_;
    return text;
  }

  /// Those of --members.
  [[nodiscard]] std::vector<Member> wanted(const std::vector<Member>& members) const {
    const std::size_t colon = members_.find(':');
    const auto number = [&](std::string_view text) { return whole_number(trimmed(text)); };
    const auto from = number(std::string_view(members_).substr(0, colon));
    const auto to =
        colon == std::string::npos ? std::nullopt : number(std::string_view(members_).substr(colon + 1));
    const auto count = static_cast<std::int64_t>(members.size());
    if (!from || !to || *from < 0 || *from >= *to || *to > count)
      throw Rejected(Exit::usage, "--members", members_,
                     fmt::format("must be I:J with 0 <= I < J <= {}, the number of members", count));
    return {members.begin() + *from, members.begin() + *to};
  }

  [[nodiscard]] StudyTally work(const Study& study, const std::vector<Member>& members,
                                const InterruptGuard& guard, Console& console) const {
    TerminalLine line(console);
    return run_members(study, input_.folder(), members, workers_,
                       {[&](const StudyTally& tally) { line.show(study_text(tally, line.elapsed())); },
                        [&] { return !guard.interrupted(); }});
  }

  [[nodiscard]] Exit say_interrupted(const StudyTally& tally, const std::vector<Member>& members,
                                     Console& console) const {
    if (json_) console.out << json_text(count_json(input_.folder(), members));
    console.say(fmt::format("interrupted; {} of {} members are done or have failed, and are kept",
                            tally.all - tally.open(), tally.all));
    console.say("to go on: " + command());
    return Exit::interrupted;
  }

  [[nodiscard]] Exit run_part(const Study& study, const std::vector<Member>& members,
                              Console& console) const {
    const InterruptGuard guard;
    const StudyTally tally = work(study, members, guard, console);
    if (tally.open() > 0) return say_interrupted(tally, members, console);
    console.say(fmt::format("{} members, of which {} were there before", tally.all, tally.before));
    if (json_) console.out << json_text(count_json(input_.folder(), members));
    refuse_failures(study, input_.folder(), members);
    return Exit::ok;
  }

  /// Runs the study, and as many seeds more as --until-ci asks for.
  [[nodiscard]] Exit run_whole(Study study, std::vector<Member> members, Console& console) const {
    const InterruptGuard guard;
    const WholeStudy whole = run_whole_study(
        std::move(study), std::move(members), input_.folder(), until_ci(),
        [&](const Study& grown, const std::vector<Member>& all) { return work(grown, all, guard, console); });
    if (!whole.results) return say_interrupted(whole.tally, whole.members, console);
    finish(whole, console);
    return Exit::ok;
  }

  /// Tables, report, and what a person wants to hear.   @throws Rejected when members have failed.
  void finish(const WholeStudy& whole, Console& console) const {
    const std::vector<std::string> doubts =
        close_study(input_.folder(), whole.study, whole.members, *whole.results, console);
    if (const std::string text = inertia_text(*whole.results); !text.empty()) console.warn(text);
    if (json_)
      console.out << json_text(
          study_json(input_.folder(), whole.study, whole.members, *whole.results, doubts));
    refuse_failures(whole.study, input_.folder(), whole.members);
    if (const double share = until_ci(); share > 0 && !(whole.half_width() <= share))
      throw Rejected(Exit::data, "--until-ci", until_ci_,
                     fmt::format("not met with {} seeds", whole.study.plan.seeds.size()),
                     "choose a larger share");
  }

  /// 0 when it is not given.
  [[nodiscard]] double until_ci() const {
    if (until_ci_.empty()) return 0;
    return read_option("until-ci", until_ci_, QuantityCodec{Dimension::ratio, inside(0, 1)});
  }

  StudyInput input_;
  std::string members_;
  std::string jobs_;
  std::string until_ci_;
  int workers_ = 1;
  bool retry_ = false;
};

}  // namespace

CommandPointer study_command(CLI::App& parent) { return std::make_unique<StudyCommand>(parent); }

}  // namespace app
